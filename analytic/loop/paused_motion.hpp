#pragma once

#include <memory>
#include <optional>

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
  PausedMotion() = default;
  PausedMotion(const PausedMotion&) = delete;
  PausedMotion& operator=(const PausedMotion&) = delete;
  virtual ~PausedMotion() = default;

  /// Goes on. True where an ordinary bounce may follow, which is to be taken then; false at the end
  /// of the motion.
  [[nodiscard]] virtual bool advance() = 0;

  /// What asks for that bounce: the body, the cable that it has left, and how long it may fly [s].
  [[nodiscard]] virtual Flyer<Real> flyer() const = 0;
  [[nodiscard]] virtual std::optional<std::size_t> last_hit() const = 0;
  [[nodiscard]] virtual Real time_left() const = 0;
  [[nodiscard]] virtual const OrdinaryBounces<Real>& ordinary() const = 0;

  /// Takes `bounce`, or, where it is no ordinary one, the general way from here.
  virtual void take(const BasicBounce<Real>& bounce) = 0;

  /// After the end: the motion, which is then no longer here.
  [[nodiscard]] virtual BasicSolution<Real> solution() = 0;
};

/// At the start of `the_case`, which has no problems and has to stay where it is; `touching` are
/// the cables at zero gap, `record` an empty one.
[[nodiscard]] std::unique_ptr<PausedMotion<double>> paused_motion(const Case& the_case,
                                                                  const SolveOptions& options,
                                                                  CableSet touching,
                                                                  Record<double> record);

}  // namespace tautline
