// The motions of a report, thinned to what can be drawn; nothing that happens is left out but the
// slowest of very many impacts.

#include "bench/report/replay_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The paths of all runs may take so many bytes, and one sample of one takes this many.
constexpr std::size_t path_budget = 4'000'000;
constexpr std::size_t sample_size = 40;
constexpr std::size_t least_path_samples = 40;  // fewer do not show an arc between two impacts

/// What a path is drawn with; its times have more, as those of impacts do [-].
constexpr int drawn_digits = 5;

/// A path, column by column.
class Path {
 public:
  explicit Path(const Case& the_case) : case_(the_case) {}

  /// The body at `time` [s], and the energy of `moving` there.
  void add(double time, const State& state, const State& moving) {
    const double energy_there = energy(case_, moving);
    if (!std::isfinite(energy_there) || !state.position.allFinite()) {
      return;  // the last of a run that diverged
    }
    time_.push_back(rounded(time));
    x_.push_back(rounded(state.position.x(), drawn_digits));
    y_.push_back(rounded(state.position.y(), drawn_digits));
    angle_.push_back(rounded(state.angle, drawn_digits));
    energy_.push_back(rounded(energy_there, drawn_digits));
  }

  [[nodiscard]] ordered_json json() const {
    return {{"time", time_}, {"x", x_}, {"y", y_}, {"angle", angle_}, {"energy", energy_}};
  }

 private:
  const Case& case_;
  ordered_json time_ = ordered_json::array();
  ordered_json x_ = ordered_json::array();
  ordered_json y_ = ordered_json::array();
  ordered_json angle_ = ordered_json::array();
  ordered_json energy_ = ordered_json::array();
};

/// The `index`-th of `count` indices spread evenly over 0 .. size - 1, ends included.
std::size_t spread(std::size_t index, std::size_t count, std::size_t size) {
  return count < 2 ? 0 : index * (size - 1) / (count - 1);
}

/// Leaves the `most_impacts` of `events` that are largest by `speed`, in the order they had.
template <class Event, class Speed>
void keep_fastest(std::vector<Event>& events, const Speed& speed) {
  if (events.size() <= most_impacts) {
    return;
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t index = 0; index < events.size(); ++index) {
    order.emplace_back(-speed(events[index]), index);
  }
  std::sort(order.begin(), order.end());
  order.resize(most_impacts);
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<Event> kept;
  kept.reserve(order.size());
  for (const auto& entry : order) {
    kept.push_back(events[entry.second]);
  }
  events = std::move(kept);
}

/// Closing speed of the fastest cable of an impact [m/s]; none of another event.
std::optional<double> closing_speed(const Case& the_case, const Event& event) {
  if (event.kind != EventKind::impact) {
    return std::nullopt;
  }
  double fastest = 0.0;
  for (const std::size_t index : event.cables) {
    fastest = std::max(fastest, -gap_rate(the_case.cables[index], event.before));
  }
  return fastest;
}

ordered_json exact_path_json(const Case& the_case, const Solution& solution,
                             const std::vector<const Event*>& events) {
  Path path(the_case);
  auto event = events.begin();
  for (std::size_t index = 0; index < most_path_samples; ++index) {
    const double time = index + 1 == most_path_samples
                            ? solution.end_time()
                            : solution.end_time() * static_cast<double>(index) /
                                  static_cast<double>(most_path_samples - 1);
    for (; event != events.end() && (*event)->time <= time; ++event) {
      path.add((*event)->time, (*event)->after, (*event)->after);
    }
    const State state = solution.at(time);
    path.add(time, state, state);
  }
  return path.json();
}

ordered_json events_json(const Case& the_case, const std::vector<const Event*>& events) {
  ordered_json time = ordered_json::array();
  ordered_json kind = ordered_json::array();
  ordered_json cables = ordered_json::array();
  ordered_json rate = ordered_json::array();
  for (const Event* event : events) {
    const std::optional<double> speed = closing_speed(the_case, *event);
    time.push_back(rounded(event->time));
    kind.push_back(to_string(event->kind));
    cables.push_back(event->cables.indices());
    rate.push_back(speed ? rounded(*speed) : ordered_json(nullptr));
  }
  return {{"time", time}, {"kind", kind}, {"cables", cables}, {"rate", rate}};
}

ordered_json geometry_json(const Case& the_case) {
  ordered_json geometry = ordered_json::array();
  for (const Cable& cable : the_case.cables) {
    geometry.push_back(
        {{"anchor", {cable.anchor.x(), cable.anchor.y()}},
         {"attachment", {cable.attachment.x(), cable.attachment.y()}},
         {"length", cable.length},
         {"restitution",
          depends_on_speed(cable) ? ordered_json(nullptr) : ordered_json(cable.restitution)}});
  }
  return geometry;
}

}  // namespace

std::size_t path_samples(std::size_t runs) {
  return std::clamp(path_budget / std::max<std::size_t>(runs, 1) / sample_size, least_path_samples,
                    most_path_samples);
}

ordered_json rounded(double value, int digits) {
  if (!std::isfinite(value)) {
    return nullptr;
  }
  return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

std::vector<const RecordedImpact*> kept_impacts(const Trajectory& run, double count_speed) {
  std::vector<const RecordedImpact*> impacts;
  for (const RecordedImpact& impact : run.impacts) {
    if (-impact.rate_before > count_speed) {
      impacts.push_back(&impact);
    }
  }
  keep_fastest(impacts, [](const RecordedImpact* impact) { return -impact->rate_before; });
  return impacts;
}

ordered_json run_path_json(const Case& the_case, const Trajectory& run, std::size_t samples,
                           double count_speed) {
  const auto impacts = kept_impacts(run, count_speed);
  const std::size_t count = std::min(samples, run.points.size());
  Path path(the_case);
  auto impact = impacts.begin();
  double latest = -1.0;  // [s], of an impact
  for (std::size_t index = 0; index < count; ++index) {
    const auto& [time, state] = run.points[spread(index, count, run.points.size())];
    for (; impact != impacts.end() && (*impact)->time <= time && index > 0; ++impact) {
      // a push over several steps ends elsewhere: there is no state after it at its time
      const bool jumps = (*impact)->steps <= 1;
      if ((*impact)->time != latest) {
        path.add((*impact)->time, (*impact)->before, jumps ? (*impact)->after : (*impact)->before);
        latest = (*impact)->time;
      }
    }
    if (time != latest || index + 1 == count) {
      path.add(time, state, state);
    }
  }
  return path.json();
}

ordered_json run_impacts_json(const Case& the_case, const Trajectory& run, double count_speed) {
  ordered_json columns;
  for (const char* name : {"time", "cable", "requested", "rate_before", "rate_after", "arm",
                           "tangential_error", "angular_error", "steps"}) {
    columns[name] = ordered_json::array();
  }
  const auto impacts = kept_impacts(run, count_speed);
  for (const RecordedImpact* impact : impacts) {
    const Cable& cable = the_case.cables[impact->cable];
    const Eigen::Vector3d pull = gap_gradient(cable, impact->before);
    const Vec2 along = pull.head<2>();
    columns["time"].push_back(rounded(impact->time));
    columns["cable"].push_back(impact->cable);
    columns["requested"].push_back(rounded(restitution(cable, impact->rate_before)));
    columns["rate_before"].push_back(rounded(impact->rate_before));
    columns["rate_after"].push_back(rounded(impact->rate_after));
    columns["arm"].push_back(rounded(pull[2]));
    columns["tangential_error"].push_back(
        rounded(perpendicular(along).dot(Vec2(impact->stray.head<2>()))));
    columns["angular_error"].push_back(rounded(impact->stray[2]));
    columns["steps"].push_back(impact->steps);
  }
  const auto counted = std::count_if(
      run.impacts.begin(), run.impacts.end(),
      [count_speed](const RecordedImpact& impact) { return -impact.rate_before > count_speed; });
  columns["left_out"] = static_cast<std::size_t>(counted) - impacts.size();
  return columns;
}

void add_exact_motion(const Case& the_case, const Solution& solution, ordered_json& row) {
  std::vector<const Event*> events;
  for (const Event& event : solution.events()) {
    events.push_back(&event);
  }
  keep_fastest(events, [&](const Event* event) {
    // what is no impact is rare and always kept
    return closing_speed(the_case, *event).value_or(std::numeric_limits<double>::infinity());
  });
  row["body"] = {{"mass", the_case.body.mass}, {"inertia", the_case.body.inertia}};
  row["gravity"] = {the_case.gravity.x(), the_case.gravity.y()};
  row["geometry"] = geometry_json(the_case);
  row["path"] = exact_path_json(the_case, solution, events);
  row["events"] = events_json(the_case, events);
}

}  // namespace tautline::bench
