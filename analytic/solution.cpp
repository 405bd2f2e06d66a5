#include "tautline/solution.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "instantiate.hpp"
#include "tautline/flight.hpp"

namespace tautline {

template <class Real>
BasicState<Real> BasicArc<Real>::after(const Real& dt, const BasicVec2<Real>& gravity) const {
  if (series.rows() == 0) {
    return fly(initial, gravity, dt);
  }
  Eigen::Matrix<Real, 1, 3> pose = Eigen::Matrix<Real, 1, 3>::Zero();
  Eigen::Matrix<Real, 1, 3> rate = Eigen::Matrix<Real, 1, 3>::Zero();
  for (Eigen::Index k = series.rows() - 1; k >= 0; --k) {
    rate = (rate * dt + pose).eval();
    pose = (pose * dt + series.row(k)).eval();
  }
  return {{pose[0], pose[1]}, pose[2], {rate[0], rate[1]}, rate[2]};
}

template <class Real>
BasicSolution<Real>::BasicSolution(BasicVec2<Real> gravity, std::vector<BasicArc<Real>> arcs,
                                   std::vector<BasicEvent<Real>> events, Ending ending,
                                   std::vector<BasicAccumulation<Real>> accumulations,
                                   std::optional<BasicSwing<Real>> swing,
                                   std::optional<BasicRepetition<Real>> repetition)
    : gravity_(std::move(gravity)),
      arcs_(std::move(arcs)),
      events_(std::move(events)),
      ending_(ending),
      accumulations_(std::move(accumulations)),
      swing_(std::move(swing)),
      repetition_(std::move(repetition)) {
  if (arcs_.empty()) {
    throw std::invalid_argument("a solution needs at least one arc");
  }
}

template <class Real>
BasicState<Real> BasicSolution<Real>::at(const Real& time) const {
  if (!(time >= 0 && time <= end_time())) {
    throw std::out_of_range("time " + std::to_string(static_cast<double>(time)) +
                            " is outside the solution, which ends at " +
                            std::to_string(static_cast<double>(end_time())));
  }
  // the last arc that starts at or before `time`: after an event, not before it
  const auto next =
      std::upper_bound(arcs_.begin(), arcs_.end(), time,
                       [](const Real& t, const BasicArc<Real>& arc) { return t < arc.start; });
  const BasicArc<Real>& arc = *std::prev(next);
  return arc.after(time - arc.start, gravity_);
}

template struct BasicArc<Instance>;
template class BasicSolution<Instance>;

#ifndef TAUTLINE_MULTIPRECISION

std::string_view to_string(EventKind kind) {
  switch (kind) {
    case EventKind::impact:
      return "impact";
    case EventKind::taut:
      return "taut";
    case EventKind::slack:
      return "slack";
  }
  return "unknown";
}

std::string_view to_string(Ending ending) {
  switch (ending) {
    case Ending::reached_duration:
      return "reached_duration";
    case Ending::rest:
      return "rest";
    case Ending::unstable_rest:
      return "unstable_rest";
    case Ending::locked:
      return "locked";
    case Ending::angle_limit:
      return "angle_limit";
    case Ending::ceiling:
      return "ceiling";
    case Ending::singular:
      return "singular";
    case Ending::event_limit:
      return "event_limit";
    case Ending::step_limit:
      return "step_limit";
    case Ending::no_progress:
      return "no_progress";
    case Ending::overflow:
      return "overflow";
  }
  return "unknown";
}
#endif

}  // namespace tautline
