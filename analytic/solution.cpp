#include "tautline/solution.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "instantiate.hpp"
#include "tautline/flight.hpp"
#include "tautline/tension.hpp"

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
BasicSolution<Real>::BasicSolution(BasicCase<Real> system, std::vector<BasicArc<Real>> arcs,
                                   std::vector<BasicEvent<Real>> events, Ending ending,
                                   std::vector<BasicAccumulation<Real>> accumulations,
                                   std::optional<BasicSwing<Real>> swing,
                                   std::optional<BasicRepetition<Real>> repetition)
    : system_(std::move(system)),
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
const BasicArc<Real>& BasicSolution<Real>::arc_at(const Real& time) const {
  if (!(time >= 0 && time <= end_time())) {
    throw std::out_of_range("time " + std::to_string(static_cast<double>(time)) +
                            " is outside the solution, which ends at " +
                            std::to_string(static_cast<double>(end_time())));
  }
  // after an event, not before it
  const auto next =
      std::upper_bound(arcs_.begin(), arcs_.end(), time,
                       [](const Real& t, const BasicArc<Real>& arc) { return t < arc.start; });
  return *std::prev(next);
}

template <class Real>
BasicState<Real> BasicSolution<Real>::at(const Real& time) const {
  const BasicArc<Real>& arc = arc_at(time);
  return arc.after(time - arc.start, gravity());
}

template <class Real>
BasicCableVector<Real> BasicSolution<Real>::tensions(const Real& time) const {
  const BasicArc<Real>& arc = arc_at(time);
  return tensions(arc, time - arc.start);
}

template <class Real>
BasicCableVector<Real> BasicSolution<Real>::tensions(const BasicArc<Real>& arc,
                                                     const Real& dt) const {
  BasicCableVector<Real> result =
      BasicCableVector<Real>::Zero(static_cast<Eigen::Index>(system_.cables.size()));
  if (arc.taut.empty()) {
    return result;
  }
  const BasicCableVector<Real> pulls =
      holding_tensions(system_, arc.after(dt, gravity()), arc.taut);
  Eigen::Index row = 0;
  for (const std::size_t index : arc.taut) {
    result[static_cast<Eigen::Index>(index)] = pulls[row++];
  }
  return result;
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
