#include "bench/solution/taut_phases.hpp"

#include <algorithm>
#include <cmath>

#include "tautline/detail/projection.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/detail/tension_extremes.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// The error of the instant of an event; 0 for the start and the end of the solution.
double event_error(const Solution& solution, const Uncertainty& uncertainty, double time) {
  const auto& events = solution.events();
  const auto next = std::lower_bound(events.begin(), events.end(), time,
                                     [](const Event& event, double t) { return event.time < t; });
  if (next == events.end() || next->time != time) {  // exactly: arcs end at events
    return 0.0;
  }
  const auto& errors = uncertainty.events()[static_cast<std::size_t>(next - events.begin())];
  return errors ? errors->time : -1.0;
}

/// An extreme of an arc with its errors.
TensionAt with_errors(const Case& the_case, const Solution& solution,
                      const Uncertainty& uncertainty, const TautPhase& phase,
                      const TensionExtremes<Case>::Found& found) {
  const Arc& arc = *found.arc;
  const double from = phase.from.value;
  const double until = phase.until.value;
  const double time = arc.start + found.dt;
  const State state = arc.after(found.dt, solution.gravity());
  const double last = std::nextafter(until, 0.0);  // before the event at its end
  const auto tension = bounded_tensions(the_case, state, arc.taut, solution.tensions(arc, found.dt),
                                        uncertainty.at(std::clamp(time, from, last)));
  TensionAt result{tension[phase.cable], {time, -1.0}};
  if (result.tension.error < 0.0) {
    return result;
  }
  if (time <= from || time >= last) {
    result.time.error = event_error(solution, uncertainty, time <= from ? from : until);
    return result;
  }
  // T changes by half its curvature times dt^2: errors of up to e move its extreme by up to
  // 2 sqrt(e / curvature)
  constexpr double part = 0.05;  // [-], of an arc, over which the curvature is measured
  const double dt = std::min({part * (arc.end - arc.start), time - from, last - time});
  const auto at = [&](double when) {
    return solution.tensions(when)[static_cast<Eigen::Index>(phase.cable)];
  };
  const double bend = std::abs(at(time + dt) - 2.0 * at(time) + at(time - dt));  // times dt^2
  const double noise = 16.0 * epsilon<double>() * result.tension.value;
  result.time.error =
      bend > noise ? 2.0 * dt * std::sqrt(result.tension.error / bend) : until - from;
  return result;
}

}  // namespace

std::vector<TautPhase> taut_phases(const Case& the_case, const Solution& solution,
                                   const Uncertainty& uncertainty) {
  std::vector<TautPhase> result;
  const auto& arcs = solution.arcs();
  for (std::size_t cable = 0; cable < the_case.cables.size(); ++cable) {
    for (std::size_t first = 0; first < arcs.size();) {
      if (!arcs[first].taut.contains(cable)) {
        ++first;
        continue;
      }
      std::size_t last = first;
      bool indeterminate = false;
      TensionExtremes<Case> extremes(solution, cable);
      CableSet seen;
      for (; last < arcs.size() && arcs[last].taut.contains(cable); ++last) {
        extremes.look_at(arcs[last]);
        if (arcs[last].taut != seen) {
          seen = arcs[last].taut;
          indeterminate = indeterminate || !independent(the_case, arcs[last].initial, seen);
        }
      }
      // what repeats goes on to the end
      const double until = last < arcs.size() ? arcs[last - 1].end : solution.end_time();
      TautPhase phase{cable, {arcs[first].start}, {until}, {}, {}, indeterminate};
      phase.from.error = event_error(solution, uncertainty, phase.from.value);
      phase.until.error = event_error(solution, uncertainty, phase.until.value);
      if (phase.until.value > phase.from.value) {
        phase.least = with_errors(the_case, solution, uncertainty, phase, extremes.least());
        phase.largest = with_errors(the_case, solution, uncertainty, phase, extremes.largest());
        result.push_back(phase);
      }
      first = last;
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const TautPhase& a, const TautPhase& b) {
    return a.from.value < b.from.value;
  });
  return result;
}

std::vector<PeriodTension> period_tensions(const Case& the_case, const State& state,
                                           CableSet cables, const Swing& swing,
                                           double energy_error) {
  const auto over_period = [&](double faster) {
    Case period = the_case;
    period.initial = projected(the_case, state, cables);
    period.initial.velocity *= faster;
    period.initial.spin *= faster;
    period.duration = swing.period;
    return period;
  };
  const auto solved = [](const Case& period) {
    const Solution solution = solve(period);
    return std::pair(taut_phases(period, solution, Uncertainty(period, solution)),
                     energy(period, period.initial));
  };
  const Case faster = over_period(1.001);
  std::vector<PeriodTension> result;
  if (!problems(faster).empty()) {  // such as an angle beyond what a start may have
    return result;
  }
  const auto [phases, energy] = solved(over_period(1.0));
  const auto [others, more] = solved(faster);
  for (std::size_t index = 0; index < phases.size(); ++index) {
    PeriodTension found{phases[index].cable, phases[index].least.tension,
                        phases[index].largest.tension};
    if (energy_error < 0.0) {
      found.least.error = found.largest.error = -1.0;
    } else if (others.size() == phases.size() && more > energy) {
      const double part = energy_error / (more - energy);
      found.least.error += part * std::abs(others[index].least.tension.value - found.least.value);
      found.largest.error +=
          part * std::abs(others[index].largest.tension.value - found.largest.value);
    }
    result.push_back(found);
  }
  return result;
}

}  // namespace tautline::bench
