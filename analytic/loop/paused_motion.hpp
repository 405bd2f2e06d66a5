#pragma once

#include <memory>
#include <utility>

#include "flight/ordinary.hpp"
#include "loop/record.hpp"
#include "tautline/solution.hpp"

namespace tautline {

struct SolveOptions;

/// A motion that pauses wherever an ordinary bounce may follow, so that the bounces of several can
/// be found side by side.
template <class Real>
class PausedMotion {
 public:
  PausedMotion(const PausedMotion&) = delete;
  PausedMotion& operator=(const PausedMotion&) = delete;
  virtual ~PausedMotion() = default;

  [[nodiscard]] virtual bool has_ended() const = 0;

  /// True where an ordinary bounce may follow, which `search` is to find among the bounces of the
  /// case.
  [[nodiscard]] virtual bool may_bounce() = 0;
  [[nodiscard]] virtual BounceSearch<Real> search() const = 0;
  [[nodiscard]] const OrdinaryBounces<Real>& ordinary() const { return ordinary_; }

  /// One round of the loop, with the bounce that was found, or with none.
  virtual void round(const BasicBounce<Real>& bounce) = 0;

  /// After the end: the motion, which is then no longer here.
  [[nodiscard]] virtual BasicSolution<Real> solution() = 0;

 protected:
  explicit PausedMotion(OrdinaryBounces<Real> ordinary) : ordinary_(std::move(ordinary)) {}

  OrdinaryBounces<Real> ordinary_;
};

/// At the start of `the_case`, which has no problems and has to stay where it is; `touching` are
/// the cables at zero gap, `record` an empty one.
[[nodiscard]] std::unique_ptr<PausedMotion<double>> paused_motion(const Case& the_case,
                                                                  const SolveOptions& options,
                                                                  CableSet touching,
                                                                  Record<double> record);

}  // namespace tautline
