#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline {

/// Bounds of the errors of an event's numbers, each in the number's own unit.
struct EventErrors {
  double time;           // [s]; of an accumulation that is completed: of its limit
  double rate;           // [m/s], of the fastest closing rate
  CableVector impulses;  // [N s], one per cable
  State before;          // of each number of the state, at the event's own instant
  State after;           // the same
  /// Cables of an impact among which the split of the impulse is not determined (`indeterminate`):
  /// the bounds of their impulses are of the split of smallest size.
  CableSet indeterminate = {};
};

/// What rounding decides: the doubles of the case are at, or too near to, the border of two
/// motions.
struct Tie {
  /// impact: which of `cables` is hit first; slack: whether they let go; taut: with which of two
  /// motions they stay taut.
  EventKind kind;
  CableSet cables;  // hit at one instant, whose tension touches zero, or at a dead point
};

/// A stretch of time [s] in which nothing is sure but the energy's bounds.
struct Unsure {
  double from;                  // [s]
  double until;                 // [s], infinity: to the end
  std::optional<Tie> tie = {};  // that begins it; none: errors have grown
};

/// The cables of an impact among which its impulse can be split in more than one way that does the
/// same to the body: more than statics determine, as three slings of one bar. The impulses of a
/// solution are then the split of smallest size, the sum of their squares. Empty where the split is
/// unique, and under laws that make it so: sequential, energetic, and poisson with several
/// restitutions.
template <class TheCase>
[[nodiscard]] CableSet indeterminate(ImpactLaw law, const TheCase& the_case,
                                     const BasicEvent<TheCase>& event);

/// An instant at which something is least that decides how the motion goes on where it is zero.
template <class Real>
struct BasicTouch {
  /// slack: the tension of a cable, which lets go. taut: the square of the largest sine between two
  /// rows of the taut cables, 0 at a dead point of the linkage that they make of the body: more
  /// than one taut motion goes on from there.
  EventKind kind;
  CableSet cables;  // whose tension it is, or whose dead point
  Real time;        // [s]
  Real value;       // [N] or [-]; a tension < 0 where the cable has let go
  Real bend;        // its second derivative there, > 0
};
using Touch = BasicTouch<double>;

/// Where tensions along arc `index` of `solution` come near zero, against the forces of the motion,
/// without falling through it fast, and where its taut cables come near a dead point; also where a
/// cable is let go near a dead point, as rounding may be why. A motion that starts with a tension
/// of zero does not touch it.
template <class Real>
[[nodiscard]] std::vector<BasicTouch<Real>> touches(const BasicCase<Real>& the_case,
                                                    const BasicSolution<BasicCase<Real>>& solution,
                                                    std::size_t index);

/// The cables that hold the moving body at a dead point as `the_case` begins; empty if it is at
/// none.
template <class Real>
[[nodiscard]] CableSet dead_at_start(const BasicCase<Real>& the_case);

/// True where the taut cables of `solution` pass a dead point in an arc that starts at `from` [s]
/// or later: a motion that repeats is then not known to do so.
template <class Real>
[[nodiscard]] bool passes_dead_point(const BasicCase<Real>& the_case,
                                     const BasicSolution<BasicCase<Real>>& solution,
                                     const Real& from);

/// How far a solution in doubles can be trusted: bounds of its errors, from the rounding that each
/// event and each arc adds and from the derivatives along the motion (analytic/README.md, section
/// "Error bounds"). Against the exact motion of the doubles that the case holds.
///
/// To first order, as long as errors are small against what decides which event comes next. Where
/// they no longer are, the solution is one of many motions that start alike; it is sure again where
/// all of these come to rest on the same taut cables.
class Uncertainty {
 public:
  /// `solution` solves `the_case` with `options`. Both must outlive this.
  Uncertainty(const Case& the_case, const Solution& solution, const SolveOptions& options = {});

  /// A bound of the error of each number of the state at `time`; none where nothing is sure.
  [[nodiscard]] std::optional<State> at(double time) const;

  /// A bound of the error of the energy [J] at `time`; none where it is known as falling only.
  [[nodiscard]] std::optional<double> energy(double time) const;

  /// One for each event of the solution; none where nothing is sure.
  [[nodiscard]] const std::vector<std::optional<EventErrors>>& events() const { return events_; }

  /// In rising time; empty where all of the solution is sure.
  [[nodiscard]] const std::vector<Unsure>& unsure() const { return unsure_; }

  /// The first instant [s] at which nothing is sure any more; none if there is none.
  [[nodiscard]] std::optional<double> horizon() const;

  /// A bound of the error of the last event, where cables become taut for good after a stretch in
  /// which nothing is sure [s]: of its time, or of the limit of the accumulation that it completes.
  /// From motions that start within the errors, which it solves; none where they do not tell.
  [[nodiscard]] std::optional<double> lock() const;

  /// Squares of errors and their products: of the six numbers of a state, relative to its event
  /// before, and of the time of that event.
  using Spread = Eigen::Matrix<double, 7, 7>;

 private:
  friend class ErrorTracker;

  [[nodiscard]] std::optional<Spread> spread(double time) const;
  void add_jumps_near(double time, State& errors) const;

  const Case* case_;
  const Solution* solution_;
  SolveOptions options_;
  std::vector<Spread> starts_;  // of each arc; those in an unsure stretch are not looked at
  double period_error_ = 0.0;   // [s], of a motion that repeats, the root of the square
  std::vector<std::optional<EventErrors>> events_;
  std::vector<Unsure> unsure_;
};

}  // namespace tautline
