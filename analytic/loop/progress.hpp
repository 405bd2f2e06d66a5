#pragma once

#include <optional>

#include "tautline/detail/projection.hpp"

namespace tautline {

/// Looks whether the time of a motion advances.
template <class Real>
class Progress {
 public:
  /// A round of the loop in which `hit` were hit, if any.
  void note_hit(CableSet hit) { hit_ = hit_ | hit; }

  /// After another round has led to `time`: the cables that have been hit all the while, if time
  /// has not advanced meanwhile.
  [[nodiscard]] std::optional<CableSet> stands_still(const Real& time) {
    if (++rounds_ % rounds_to_advance != 0) {
      return std::nullopt;
    }
    const bool stands = time - last_ <= rounds_to_advance * epsilon<Real>() * time;
    const CableSet hit = hit_;
    in_a_row_ = stands ? in_a_row_ + 1 : 0;
    last_ = time;
    hit_ = {};
    return stands ? std::optional(hit) : std::nullopt;
  }

  /// True where it has stood still again and again.
  [[nodiscard]] bool is_hopeless() const { return in_a_row_ > max_cables; }

 private:
  /// In so many rounds time must advance by a rounding each [-]. So many impacts of two cables with
  /// e = 0.99 shrink to a rounding, 0.99^(7200 / 2) = 2e-16, or end before: analytic/README.md,
  /// "Limits".
  static constexpr std::size_t rounds_to_advance = 7'200;

  std::size_t rounds_ = 0;
  std::size_t in_a_row_ = 0;
  Real last_ = Real(0);  // [s], at the last look
  CableSet hit_;         // since then
};

/// The end of impacts that follow each other within an instant, between cables that leave the body
/// next to nowhere to go, and have done so for as long as `Progress` waits. Where one of them loses
/// energy their rates fall to zero, and as all impulses are along the cables, what is left is the
/// part of the motion that closes none: derived for two cables (analytic/README.md, "Limits"),
/// taken for more. None if all are elastic.
template <class TheCase>
[[nodiscard]] std::optional<StateOf<TheCase>> end_of_chatter(const TheCase& the_case,
                                                             const StateOf<TheCase>& state,
                                                             CableSet cables) {
  for (const std::size_t index : cables) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    if (restitution(cable, gap_rate(cable, state)) < 1) {
      return with_zero_rates(the_case, state, cables);
    }
  }
  return std::nullopt;
}

}  // namespace tautline
