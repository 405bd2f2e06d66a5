#include "bench/measure/tension_match.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bench/measure/impact_match.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// So many steps on either side of an event of the exact motion do not count: a fixed step puts an
/// impact into the next step, spreads it over a few, and has an impulse in it that is no tension.
constexpr double steps_around_events = 5.0;

/// Less than this part of the largest pull of a cable is the rounding of a step, not a pull [-].
constexpr double least_pull = 1e-9;

/// True where one pose and one motion have one set of tensions: no more cables than the ways in
/// which the body moves, and none that the others could replace.
template <class TheCase>
bool statics_determine(const TheCase& the_case, const StateOf<TheCase>& state, CableSet taut) {
  Eigen::MatrixXd pulls(static_cast<Eigen::Index>(freedoms_of(the_case)),
                        static_cast<Eigen::Index>(taut.size()));
  Eigen::Index column = 0;
  for (const std::size_t index : taut) {
    pulls.col(column++) = gap_gradient(the_case.cables[index], state);
  }
  return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(pulls).rank() == pulls.cols();
}

/// The recorded tension of a cable before each point, and where it stands.
template <class TheCase>
class RecordedTensions {
 public:
  RecordedTensions(const TheCase& the_case, const BasicTrajectory<TheCase>& run)
      : run_(run), cables_(the_case.cables.size()) {}

  [[nodiscard]] double before(std::size_t point, std::size_t cable) const {
    return run_.tensions[point * cables_ + cable];
  }

  /// The mean of `cable` [N] from the first point at or after `from` on to the last one up to
  /// `until` [s]; none where there are no two.
  [[nodiscard]] std::optional<double> mean(std::size_t cable, double from, double until) const {
    double impulse = 0.0;
    double length = 0.0;
    for (std::size_t point = 1; point < run_.points.size(); ++point) {
      const double start = run_.points[point - 1].time;
      const double stop = run_.points[point].time;
      if (start >= from && stop <= until) {
        impulse += before(point, cable) * (stop - start);
        length += stop - start;
      }
    }
    return length > 0.0 && std::isfinite(impulse) ? std::optional(impulse / length) : std::nullopt;
  }

 private:
  const BasicTrajectory<TheCase>& run_;
  std::size_t cables_;
};

/// True where a cable of `event` closes faster than `speed` [m/s].
template <class TheCase>
bool closes_faster(const TheCase& the_case, const BasicEvent<TheCase>& event, double speed) {
  for (const std::size_t cable : event.cables) {
    if (-gap_rate(the_case.cables[cable], event.before) > speed) {
      return true;
    }
  }
  return false;
}

template <class TheCase>
std::optional<ExactAndFound> tension_at_rest(const TheCase& the_case,
                                             const BasicSolution<TheCase>& solution,
                                             const BasicTrajectory<TheCase>& run) {
  const bool rests =
      solution.ending() == Ending::rest || solution.ending() == Ending::unstable_rest;
  const BasicArc<TheCase>& last = solution.arcs().back();
  if (!rests || last.taut.empty() || !statics_determine(the_case, last.initial, last.taut)) {
    return std::nullopt;
  }
  const double end = solution.end_time();
  const double from = last.start + 0.5 * (end - last.start);  // errors of the way there die out
  const CableVector exact = solution.tensions(end);
  const RecordedTensions<TheCase> recorded(the_case, run);
  std::optional<ExactAndFound> worst;
  for (const std::size_t cable : last.taut) {
    const std::optional<double> found = recorded.mean(cable, from, end);
    if (!found) {
      return std::nullopt;
    }
    const double right = exact[static_cast<Eigen::Index>(cable)];
    if (!worst || std::abs(*found - right) > std::abs(worst->found - worst->exact)) {
      worst = {right, *found};
    }
  }
  return worst;
}

/// The instants at which the exact motion changes or the run has an impact, in rising time [s].
template <class TheCase>
std::vector<double> changes_of(const BasicSolution<TheCase>& solution,
                               const BasicTrajectory<TheCase>& run) {
  std::vector<double> times = {0.0};
  for (const auto& impact : run.impacts) {
    times.push_back(impact.time);
  }
  for (const auto& event : solution.events()) {
    times.push_back(event.time);
  }
  times.push_back(solution.end_time());
  std::sort(times.begin(), times.end());
  return times;
}

double lightest(const Case& the_case) { return the_case.body.mass; }
double lightest(const SpatialSystem& system) {
  const auto lighter = [](const SpatialBody& a, const SpatialBody& b) { return a.mass < b.mass; };
  return std::min_element(system.bodies.begin(), system.bodies.end(), lighter)->mass;
}

template <class TheCase>
std::optional<ExactAndFound> largest_tension(const TheCase& the_case,
                                             const BasicSolution<TheCase>& solution,
                                             const BasicTrajectory<TheCase>& run, double end) {
  const std::vector<double> changes = changes_of(solution, run);
  auto next = changes.begin();  // the first change that is not before the step
  double exact = 0.0;
  double found = 0.0;
  for (std::size_t point = 1; point < run.points.size() && run.points[point].time <= end; ++point) {
    const double start = run.points[point - 1].time;
    const double stop = run.points[point].time;
    const double margin = steps_around_events * run.step * static_cast<double>(run.stride);
    while (next != changes.end() && *next < start - margin) {
      ++next;
    }
    const bool near_a_change = next != changes.end() && *next <= stop + margin;
    if (near_a_change) {
      continue;
    }
    // their mean over the step, by Simpson's rule
    const CableVector tensions = (solution.tensions(start) + solution.tensions(stop) +
                                  4.0 * solution.tensions(0.5 * (start + stop))) /
                                 6.0;
    for (std::size_t cable = 0; cable < the_case.cables.size(); ++cable) {
      const double right = tensions[static_cast<Eigen::Index>(cable)];
      const double told = run.tensions[point * the_case.cables.size() + cable];
      if (right > 0.0 && std::isfinite(told)) {
        exact = std::max(exact, right);
        found = std::max(found, told);
      }
    }
  }
  return exact > least_pull * lightest(the_case) ? std::optional(ExactAndFound{exact, found})
                                                 : std::nullopt;
}

}  // namespace

template <class TheCase>
TensionMatch match_tensions(const TheCase& the_case, const BasicSolution<TheCase>& solution,
                            const BasicTrajectory<TheCase>& run, double end) {
  if (run.tensions.empty()) {
    return {};
  }
  return {tension_at_rest(the_case, solution, run), largest_tension(the_case, solution, run, end)};
}

std::optional<double> largest_tension(const Trajectory& run) {
  if (run.tensions.empty()) {
    return std::nullopt;
  }
  const std::size_t cables = run.tensions.size() / run.points.size();
  const double margin = steps_around_events * run.step * static_cast<double>(run.stride);
  auto next = run.impacts.begin();
  double acts_until = 0.0;  // [s], an impact in the steps
  double largest = 0.0;
  for (std::size_t point = 1; point < run.points.size(); ++point) {
    for (; next != run.impacts.end() && next->time < run.points[point].time; ++next) {
      if (next->steps > 0) {  // one that is located has no part in the tensions
        acts_until = std::max(acts_until, next->time + margin);
      }
    }
    if (acts_until > run.points[point - 1].time) {
      continue;
    }
    for (std::size_t cable = 0; cable < cables; ++cable) {
      const double tension = run.tensions[point * cables + cable];
      if (tension > largest) {  // no number is not
        largest = tension;
      }
    }
  }
  return largest;
}

template <class TheCase>
std::optional<ExactAndFound> match_first_impulse(const TheCase& the_case,
                                                 const BasicSolution<TheCase>& solution,
                                                 const BasicTrajectory<TheCase>& run,
                                                 double count_speed, double end) {
  const auto first =
      std::find_if(solution.events().begin(), solution.events().end(), [&](const auto& event) {
        return event.kind == EventKind::impact && closes_faster(the_case, event, count_speed);
      });
  if (first == solution.events().end() || first->time > end || first->cables.size() != 1) {
    return std::nullopt;
  }
  const auto found = counted(run, count_speed);
  if (found.empty() || found.front()->shared || found.front()->cable != *first->cables.begin()) {
    return std::nullopt;
  }
  return ExactAndFound{first->impulses[0], found.front()->snap};
}

template TensionMatch match_tensions(const Case&, const Solution&, const Trajectory&, double);
template TensionMatch match_tensions(const SpatialSystem&, const BasicSolution<SpatialSystem>&,
                                     const SystemTrajectory&, double);
template std::optional<ExactAndFound> match_first_impulse(const Case&, const Solution&,
                                                          const Trajectory&, double, double);
template std::optional<ExactAndFound> match_first_impulse(const SpatialSystem&,
                                                          const BasicSolution<SpatialSystem>&,
                                                          const SystemTrajectory&, double, double);

}  // namespace tautline::bench
