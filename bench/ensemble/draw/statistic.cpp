#include "bench/ensemble/draw/statistic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cassert>
#include <cmath>

#include "bench/measure/impact_match.hpp"
#include "bench/measure/settling_match.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// A counted impact of either side on one cable.
struct Impact {
  double time;         // [s]
  std::size_t cable;   //
  double speed;        // [m/s], of closing
  double energy_lost;  // [J]
};

/// What the impulse on one cable takes [J]: the work of the mean rate. Summed over the cables of an
/// impact it is the whole loss, as 1/2 (v+ + v-) . M (v+ - v-) = 1/2 (v+ + v-) . J^T impulse.
double work_of(double impulse, double rate_before, double rate_after) {
  return -0.5 * impulse * (rate_before + rate_after);
}

std::vector<Impact> impacts_of(const Case& the_case, const Solution& solution, double slowest) {
  std::vector<Impact> result;
  for (const Event& event : solution.events()) {
    Eigen::Index place = 0;
    for (const std::size_t cable : event.cables) {
      const double before = gap_rate(the_case.cables[cable], event.before);
      if (event.kind == EventKind::impact && -before > slowest) {
        const double after = gap_rate(the_case.cables[cable], event.after);
        result.push_back(
            {event.time, cable, -before, work_of(event.impulses[place], before, after)});
      }
      ++place;
    }
  }
  return result;
}

std::vector<Impact> impacts_of(const Trajectory& run, double slowest) {
  std::vector<Impact> result;
  for (const RecordedImpact* impact : counted(run, slowest)) {
    result.push_back({impact->time, impact->cable, -impact->rate_before,
                      work_of(impact->impulse, impact->rate_before, impact->rate_after)});
  }
  return result;
}

/// The largest |angle| of an exact motion: at an end of an arc, or where the spin changes its sign
/// on one of those on taut cables, which are far shorter than a swing.
double largest_angle(const Solution& solution) {
  double largest = 0.0;
  for (const Arc& arc : solution.arcs()) {
    const auto state = [&](double dt) { return arc.after(dt, solution.gravity()); };
    const double length = arc.end - arc.start;
    const State end = state(length);
    largest = std::max({largest, std::abs(arc.initial.angle), std::abs(end.angle)});
    if (arc.initial.spin * end.spin < 0.0) {
      const boost::math::tools::eps_tolerance<double> half_of_digits(
          26);                    // the angle is flat there
      std::uintmax_t most = 100;  // bisection alone needs no more
      const auto [low, high] =
          boost::math::tools::toms748_solve([&](double dt) { return state(dt).spin; }, 0.0, length,
                                            arc.initial.spin, end.spin, half_of_digits, most);
      largest = std::max(largest, std::abs(state(0.5 * (low + high)).angle));
    }
  }
  return largest;
}

double largest_angle(const Trajectory& run) {
  double largest = 0.0;
  for (const Point& point : run.points) {
    largest = std::max(largest, std::abs(point.state.angle));
  }
  for (const RecordedImpact& impact : run.impacts) {  // in flight it is at an impact, in a step
    largest = std::max({largest, std::abs(impact.before.angle), std::abs(impact.after.angle)});
  }
  return largest;
}

/// What the impacts of either side say; the rest of the values is none.
StatisticValues impact_statistics(const EnsembleSpec& spec, const std::vector<Impact>& impacts) {
  const std::vector<Statistic> all = statistics_of(spec);
  StatisticValues values(all.size());
  const auto value = [&](const std::string& name) -> std::optional<double>& {
    return values[place_of_statistic(all, name)];
  };
  std::vector<double> lost(spec.the_case.cables.size(), 0.0);
  double count = 0.0;
  double sum = 0.0;
  for (const Impact& impact : impacts) {
    value("settled_slow") = impact.time;
    if (impact.speed > spec.speeds[0]) {
      value("settled_fast") = impact.time;
      count += 1.0;
    }
    lost[impact.cable] += impact.energy_lost;
    sum += impact.energy_lost;
  }
  value("impacts") = count;
  if (!impacts.empty()) {
    value("first_cable") = static_cast<double>(impacts.front().cable);
  }
  for (std::size_t cable = 0; cable < lost.size() && sum > 0.0; ++cable) {
    value(fmt::format("loss_{}", cable)) = lost[cable] / sum;
  }
  return values;
}

}  // namespace

std::vector<Statistic> statistics_of(const EnsembleSpec& spec) {
  const auto& [fast, slow] = spec.speeds;
  std::vector<Statistic> all = {
      {"settled_fast", fmt::format("last impact > {:g} m/s", fast), "s", fixed(4), true, true, true,
       "the last impact faster than the first speed: settling time"},
      {"settled_slow", fmt::format("last impact > {:g} m/s", slow), "s", fixed(4), true, true, true,
       "the last impact faster than the second speed"},
      {"lock", "lock", "s", fixed(4), true, true, false,
       "from which on the last cables stay taut; of an engine's run none is known"},
      {"impacts", fmt::format("impacts > {:g} m/s", fast), "", as_count, true, true, true,
       "impacts faster than the first speed, one a cable"},
      {"swing_energy", "swing energy", "J", fixed(5), true, true, true,
       "above the equilibrium, in the last period; none before the motion is locked"},
      {"swing_amplitude", "swing amplitude", "rad", fixed(4), true, true, true,
       "half the range of the angle in the last period"},
      {"largest_angle", "largest |angle|", "rad", fixed(4), true, true, true,
       "of the whole motion"},
  };
  for (std::size_t cable = 0; cable < spec.the_case.cables.size(); ++cable) {
    all.push_back({fmt::format("loss_{}", cable), fmt::format("loss in cable {}", cable), "",
                   fixed(4), true, true, true,
                   "share of the energy that impacts faster than the second speed lose"});
  }
  all.push_back(
      {"overstretch", "overstretch", "m", as_error, false, false, true, "the largest of the run"});
  all.push_back({"captured", "captured", "", as_count, false, true, false,
                 "1 where the cables that are taut in the end are never let go, else 0"});
  all.push_back({"first_cable", "first cable", "", as_count, false, true, true,
                 "the cable of the first impact that is counted"});
  return all;
}

std::size_t place_of_statistic(const std::vector<Statistic>& all, const std::string& name) {
  const auto place =
      std::find_if(all.begin(), all.end(), [&](const Statistic& one) { return one.name == name; });
  assert(place != all.end() && "a name of statistics_of");
  return static_cast<std::size_t>(place - all.begin());
}

StatisticValues exact_statistics(const EnsembleSpec& spec, const ReferenceCase& reference) {
  const auto& [the_case, solution, settled, horizon, law] = reference;
  StatisticValues values = impact_statistics(spec, impacts_of(the_case, solution, spec.speeds[1]));
  const std::vector<Statistic> all = statistics_of(spec);
  const auto value = [&](const std::string& name) -> std::optional<double>& {
    return values[place_of_statistic(all, name)];
  };
  value("largest_angle") = largest_angle(solution);
  value("captured") = settled.lock && settled.lock->permanent ? 1.0 : 0.0;
  if (settled.lock) {
    value("lock") = settled.lock->time;
  }
  if (const auto swing = measured_swing(solution, settled)) {
    value("swing_energy") = swing->energy;
    value("swing_amplitude") = swing->amplitude;
  }
  return values;
}

StatisticValues run_statistics(const EnsembleSpec& spec, const ReferenceCase& reference,
                               const Trajectory& run) {
  StatisticValues values = impact_statistics(spec, impacts_of(run, spec.speeds[1]));
  const std::vector<Statistic> all = statistics_of(spec);
  const auto value = [&](const std::string& name) -> std::optional<double>& {
    return values[place_of_statistic(all, name)];
  };
  value("largest_angle") = largest_angle(run);
  value("overstretch") = run.overstretch;
  if (const auto swing =
          match_swing(reference.the_case, reference.solution, reference.settling, run)) {
    value("swing_energy") = swing->energy.found;
    value("swing_amplitude") = swing->amplitude.found;
  }
  return values;
}

}  // namespace tautline::bench
