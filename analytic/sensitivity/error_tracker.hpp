#pragma once

#include <deque>
#include <optional>
#include <span>

#include "linearised.hpp"
#include "spread.hpp"
#include "tautline/accumulation.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline {

/// Nothing is said where an error may be this part of the shortest cable, or of a radian [-].
inline constexpr double largest_part = 0.1;

/// d state(dt) / d state(0) along `arc`.
[[nodiscard]] StateMatrix arc_flow(const Case& the_case, const Arc& arc, double dt);

/// Follows the errors of a solution from event to event and fills an `Uncertainty`.
class ErrorTracker {
 public:
  ErrorTracker(const Case& the_case, const Solution& solution, const SolveOptions& options,
               Uncertainty& result);

  void run();

 private:
  /// The errors after an event, from where an accumulation may be completed.
  struct Place {
    std::size_t event;
    Spread spread;
    CableSet taut;
  };

  /// What all motions come to that are still alike at a place before an unsure stretch.
  struct Meeting {
    std::size_t event;  // after which all of them are on the same taut cables
    Spread spread;
    double from, until;  // [s], of the instant at which that begins
  };

  void start_events(std::size_t arc);
  void take(const Event& event, bool arrives);
  [[nodiscard]] EventErrors take_impact(const Event& event);
  [[nodiscard]] EventErrors take_taut(const Event& event);
  [[nodiscard]] EventErrors take_slack(const Event& event);
  [[nodiscard]] BasicReboundSlopes<double> slopes_of(const Event& event) const;
  [[nodiscard]] const Accumulation* completed_by(const Event& event);
  [[nodiscard]] bool arrive(const Event& event, CableSet hit);
  [[nodiscard]] bool release(const Event& event);
  [[nodiscard]] bool order_is_sure(const Event& event) const;
  [[nodiscard]] bool is_sure() const;
  void follow(const Arc& arc);
  void lose();
  [[nodiscard]] std::optional<Meeting> meeting() const;
  [[nodiscard]] std::optional<Meeting> meeting_from(const Place& place) const;
  [[nodiscard]] std::optional<Meeting> sampled_meeting(const Place& place) const;
  void meet(const Event& event);

  const Case& case_;
  const Solution& solution_;
  const SolveOptions& options_;
  Uncertainty& result_;

  Spread now_ = Spread::Zero();
  StateVector rate_ = StateVector::Zero();  // of the state, at the end of the arc before
  const Arc* before_ = nullptr;             // the arc that ended last
  double fastest_ = 0.0;                    // [m/s]
  CableSet taut_;
  std::size_t next_ = 0;                // event
  std::size_t accumulation_ = 0;        // not before that event
  double curvature_ = square_rounding;  // [-], square of the largest part that is not first order
  bool lost_ = false;
  std::deque<Place> places_;
  std::optional<Meeting> meeting_;
};

}  // namespace tautline
