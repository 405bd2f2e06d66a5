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
};

/// A stretch of time [s] in which nothing is sure but the energy's bounds.
struct Unsure {
  double from;   // [s]
  double until;  // [s], infinity: to the end
};

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
