#pragma once

#include <memory>

#include "shortcuts/shortcuts.hpp"

namespace tautline {

/// A motion that pauses wherever a single bounce may follow, so that the bounces of several can be
/// found side by side.
template <class TheCase>
class PausedMotion {
 public:
  PausedMotion(const PausedMotion&) = delete;
  PausedMotion& operator=(const PausedMotion&) = delete;
  virtual ~PausedMotion() = default;

  [[nodiscard]] virtual bool has_ended() const = 0;

  /// True where a single bounce may follow, which `search` is to find among those of the case.
  [[nodiscard]] virtual bool may_bounce() = 0;
  [[nodiscard]] virtual typename Shortcuts<TheCase>::Search search() const = 0;
  [[nodiscard]] const SingleBounces<TheCase>& bounces() const { return shortcuts_.bounces(); }

  /// One round of the loop, with the bounce that was found, or with none.
  virtual void round(const typename Shortcuts<TheCase>::Bounce& bounce) = 0;

  /// After the end: the motion, which is then no longer here.
  [[nodiscard]] virtual BasicSolution<TheCase> solution() = 0;

 protected:
  PausedMotion(const TheCase& the_case, const SolveOptions& options)
      : shortcuts_(the_case, options) {}

  Shortcuts<TheCase> shortcuts_;
};

/// At the start of `the_case`, which has no problems and has to stay where it is; `touching` are
/// the cables at zero gap, `record` an empty one.
[[nodiscard]] std::unique_ptr<PausedMotion<Case>> paused_motion(const Case& the_case,
                                                                const SolveOptions& options,
                                                                CableSet touching,
                                                                Record<Case> record);

}  // namespace tautline
