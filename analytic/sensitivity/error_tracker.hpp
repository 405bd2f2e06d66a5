#pragma once

#include <optional>
#include <vector>

#include "arc_rounding.hpp"
#include "cable_view.hpp"
#include "linearised.hpp"
#include "spread.hpp"
#include "tautline/detail/accumulation.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline {

/// Nothing is said where an error may be this part of the shortest cable, or of a radian [-].
inline constexpr double largest_part = 0.1;

/// First order is trusted while the bound of an error is below this part of what it would change
/// the order of: a closing rate, the time between two events, a gap that stays open [-].
inline constexpr double trusted_part = 0.25;

/// Follows the errors of a solution from event to event and fills an `Uncertainty`.
class ErrorTracker {
 public:
  ErrorTracker(const Case& the_case, const Solution& solution, const SolveOptions& options,
               Uncertainty& result);

  void run();

 private:
  /// What an impact's results gain per unit of the state before.
  struct Kick {
    Eigen::Matrix<double, 3, 6> velocity = Eigen::Matrix<double, 3, 6>::Zero();  // and the spin
    Eigen::Matrix<double, Eigen::Dynamic, 6, 0, max_cables, 6> impulses;  // one row per cable
  };

  /// What all motions come to that are still alike at a place before an unsure stretch.
  struct Meeting {
    std::size_t event;  // after which all of them are on the same taut cables
    Spread spread;
    double until;  // [s], by when all of them are
    double late;   // [s], by how much they may be so at another time
  };

  void start_events(std::size_t arc);
  void look_at(const State& state);
  void take(const Event& event, bool arrives);
  [[nodiscard]] EventErrors take_impact(const Event& event);
  [[nodiscard]] EventErrors take_taut(const Event& event);
  [[nodiscard]] EventErrors take_slack(const Event& event);
  [[nodiscard]] Kick kick_of(const Event& event) const;
  [[nodiscard]] std::optional<StateRow> delay_of(const Event& event, CableSet hit) const;
  [[nodiscard]] const Accumulation* completed_by(const Event& event);
  [[nodiscard]] double earlier(const Event& event, CableSet hit) const;
  [[nodiscard]] double gap_error(std::size_t index, const State& state) const;
  void close(const Event& event, CableSet more);
  [[nodiscard]] bool start(const Event& event);
  [[nodiscard]] bool is_one_start(const Event& event);
  [[nodiscard]] bool arrive(const Event& event, CableSet hit);
  [[nodiscard]] bool release(const Event& event);
  [[nodiscard]] bool releases_are_sure(std::size_t arc);
  [[nodiscard]] bool order_is_sure(const Event& event) const;
  [[nodiscard]] bool is_sure() const;
  void follow(std::size_t arc);
  [[nodiscard]] double late_at_end(std::size_t arc);
  [[nodiscard]] double period_error(const Repetition& again) const;
  [[nodiscard]] StateVector along_motion(double time) const;
  [[nodiscard]] double period_drift(const Repetition& again) const;
  void repeat(const Repetition& again);
  void lose(double since);
  void lose_near(const State& state, double since);
  [[nodiscard]] double last_event() const;
  [[nodiscard]] std::optional<Meeting> meeting() const;
  [[nodiscard]] std::optional<Meeting> meeting_from(std::size_t arc) const;
  [[nodiscard]] std::optional<Meeting> sampled_meeting(std::size_t arc) const;
  [[nodiscard]] std::optional<Meeting> sampled_until(std::size_t arc, double more) const;
  void meet(const Event& event);

  const Case& case_;
  const Solution& solution_;
  const SolveOptions& options_;
  Uncertainty& result_;
  const Sizes sizes_;

  Spread now_ = Spread::Zero();
  const Arc* before_ = nullptr;    // the arc that ended last
  const Arc* followed_ = nullptr;  // the one along which errors were carried last
  std::optional<State> seen_;      // whose pose the views are of
  CableViews views_;
  CableViews start_views_;  // at the start of the arc before
  double fastest_ = 0.0;    // [m/s]
  CableSet taut_;
  CableSet started_;                    // that pulled at the start
  CableSet basis_;                      // independent ones of the arc before's taut cables
  std::size_t next_ = 0;                // event
  std::size_t accumulation_ = 0;        // not before that event
  std::optional<double> period_error_;  // [s], of a motion that repeats
  double curvature_ = square_rounding;  // [-], square of the largest part that is not first order
  bool lost_ = false;
  std::optional<Tie> tie_;            // that rounding decides, where it does next
  CableSet met_;                      // cables of the events so far
  double sure_to_ = 0.0;              // [s], whatever comes of the next event
  std::vector<std::size_t> arrived_;  // for each arc, the events up to its start
  std::size_t first_place_ = 0;       // the first arc after the last unsure stretch
  std::optional<Meeting> meeting_;
};

}  // namespace tautline
