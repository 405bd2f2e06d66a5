#pragma once

#include <optional>
#include <utility>

#include "loop/next_stop.hpp"
#include "loop/record.hpp"
#include "shortcuts/half_swing.hpp"
#include "shortcuts/single_bounces.hpp"
#include "shortcuts/swing_ahead.hpp"

namespace tautline {

/// The one door to what exists for speed alone. The loop asks it twice: whether a single bounce is
/// all that happens next, and whether the motion goes on as it does for ever. Without the answers
/// the general path finds the same motion; SolveOptions turns each off.
template <class Real>
class Shortcuts {
 public:
  using Bounce = typename SingleBounces<Real>::Bounce;
  using Search = typename SingleBounces<Real>::Search;

  Shortcuts(const BasicCase<Real>& the_case, const SolveOptions& options)
      : options_(options), bounces_(the_case, options) {}

  /// True where a single bounce may follow, and `search` is to look for it.
  [[nodiscard]] bool may_bounce(const Present<Real>& now, Attempts<Real>& attempts) {
    return bounces_.may_follow(now, attempts);
  }
  [[nodiscard]] Search search(const Present<Real>& now, const Attempts<Real>& attempts) const {
    return bounces_.search(now, attempts);
  }
  [[nodiscard]] const SingleBounces<Real>& bounces() const { return bounces_; }
  [[nodiscard]] SingleBounces<Real>& bounces() { return bounces_; }

  /// The swing for ever that the taut cables are certain to lead to, told before it is followed.
  [[nodiscard]] std::optional<BasicSwing<Real>> forever(const Present<Real>& now) const {
    return options_.until_locked && options_.swing_ahead && now.held
               ? swing_ahead(now.the_case, now.state, now.held->pulling, now.remaining)
               : std::nullopt;
  }

  /// Where the last arc of `record`, up to `stop` on the cables `pulling`, completes half a swing or
  /// a whole turn: the motion comes again for ever, and meets nothing new. Writes that to `record`,
  /// and returns the ending.
  [[nodiscard]] std::optional<Ending> forever(const Present<Real>& now, const Stop<Real>& stop,
                                              CableSet pulling, Record<Real>& record) {
    const bool is_whole = stop.is_step || stop.ending == Ending::reached_duration;
    if (!options_.half_swings || !is_whole || !has_one_freedom(now.the_case, now.state, pulling)) {
      return std::nullopt;
    }
    const auto half =
        swing_.follow(now.the_case, record.arcs, now.state, stop.dt, record.events.size());
    if (!half) {
      return std::nullopt;
    }
    if (options_.until_locked) {
      record.arcs.back().end = half->end(record.arcs);
      record.swing = swing_of(now.the_case, *half, record.arcs, pulling);
      return Ending::locked;
    }
    record.repetition = repetition_of(now.the_case, *half, record.arcs);
    return Ending::reached_duration;
  }

 private:
  const SolveOptions& options_;
  SingleBounces<Real> bounces_;
  HalfSwingWatch<Real> swing_;
};

}  // namespace tautline
