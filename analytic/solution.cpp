#include "tautline/solution.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "instantiate.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/elasticity.hpp"
#include "tautline/geometry.hpp"
#include "tension/tension.hpp"

namespace tautline {

template <class TheCase>
StateOf<TheCase> BasicArc<TheCase>::after(const Real& dt, const GravityOf<TheCase>& gravity) const {
  if (series.rows() == 0) {
    return fly(initial, gravity, dt);
  }
  using Pose =
      Eigen::Matrix<Real, 1, TheCase::freedoms, Eigen::RowMajor, 1, TheCase::most_pose_numbers>;
  Pose pose = Pose::Zero(series.cols());
  Pose rate = Pose::Zero(series.cols());
  for (Eigen::Index k = series.rows() - 1; k >= 0; --k) {
    rate = (rate * dt + pose).eval();
    pose = (pose * dt + series.row(k)).eval();
  }
  return state_of(initial, pose, rate, dt);
}

template <class TheCase>
BasicSolution<TheCase>::BasicSolution(TheCase system, std::vector<BasicArc<TheCase>> arcs,
                                      std::vector<BasicEvent<TheCase>> events, Ending ending,
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

template <class TheCase>
typename BasicSolution<TheCase>::Place BasicSolution<TheCase>::place(const Real& time) const {
  if (!(time >= 0 && time <= end_time())) {
    throw std::out_of_range("time " + std::to_string(static_cast<double>(time)) +
                            " is outside the solution, which ends at " +
                            std::to_string(static_cast<double>(end_time())));
  }
  Real in_period = time;
  double periods = 0.0;
  if (repetition_ && time > arcs_.back().end) {
    const Real& start = arcs_[repetition_->first].start;
    periods = std::floor(static_cast<double>(Real((time - start) / repetition_->period)));
    // up to rounding, which may put it just before the period or behind it
    in_period = max(start, min(arcs_.back().end, Real(time - periods * repetition_->period)));
  }
  // the last arc that starts at or before it: after an event, not before it
  const auto next =
      std::upper_bound(arcs_.begin(), arcs_.end(), in_period,
                       [](const Real& t, const BasicArc<TheCase>& arc) { return t < arc.start; });
  const auto index = static_cast<std::size_t>(std::distance(arcs_.begin(), next)) - 1;
  return {index, in_period - arcs_[index].start, periods};
}

template <class TheCase>
StateOf<TheCase> BasicSolution<TheCase>::at(const Real& time) const {
  const Place found = place(time);
  StateOf<TheCase> state = arcs_[found.arc].after(found.dt, gravity());
  if (found.periods > 0.0) {
    PosesOf<TheCase> none;
    add_turns(state, none, found.periods * repetition_->turn);
  }
  return state;
}

template <class TheCase>
std::vector<BasicArc<TheCase>> BasicSolution<TheCase>::arcs_until(const Real& time) const {
  std::vector<BasicArc<TheCase>> result;
  const auto add = [&](BasicArc<TheCase> arc, const Real& later, const Real& turned) {
    arc.start = result.empty() ? arc.start : result.back().end;
    arc.end = min(time, Real(arc.end + later));
    add_turns(arc.initial, arc.series, turned);
    result.push_back(std::move(arc));
    return result.back().end < time;
  };
  for (const BasicArc<TheCase>& arc : arcs_) {
    if (!result.empty() && arc.start > time) {
      return result;
    }
    add(arc, Real(0), Real(0));
  }
  if (repetition_) {
    for (double periods = 1.0; result.back().end < time; periods += 1.0) {
      for (std::size_t index = repetition_->first; index < arcs_.size(); ++index) {
        if (!add(arcs_[index], Real(periods * repetition_->period),
                 Real(periods * repetition_->turn))) {
          return result;
        }
      }
    }
  }
  return result;
}

template <class TheCase>
BasicCableVector<RealOf<TheCase>> BasicSolution<TheCase>::tensions(const Real& time) const {
  const Place found = place(time);
  return tensions(arcs_[found.arc], found.dt);
}

template <class TheCase>
BasicCableVector<RealOf<TheCase>> BasicSolution<TheCase>::tensions(const BasicArc<TheCase>& arc,
                                                                   const Real& dt) const {
  BasicCableVector<Real> result =
      BasicCableVector<Real>::Zero(static_cast<Eigen::Index>(system_.cables.size()));
  if constexpr (TheCase::has_several_bodies) {
    for (const std::size_t index : arc.initial.elastic.pulling()) {
      const Real tension = elastic_tension(system_, index, arc.after(dt, gravity()));
      const bool may_push = system_.cables[index].elasticity->cut != ElasticCut::force;
      result[static_cast<Eigen::Index>(index)] = may_push ? tension : max(Real(0), tension);
    }
  }
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

template struct BasicArc<InstanceCase>;
template class BasicSolution<InstanceCase>;

#ifdef TAUTLINE_FIRST

std::string_view to_string(EventKind kind) {
  switch (kind) {
    case EventKind::impact:
      return "impact";
    case EventKind::taut:
      return "taut";
    case EventKind::slack:
      return "slack";
    case EventKind::entry:
      return "entry";
    case EventKind::exit:
      return "exit";
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
