#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/data/describer.hpp"
#include "bench/data/reader.hpp"
#include "bench/data/writer.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/report.hpp"

// The values of a report that are neither numbers nor rows: as JSON, from it, and in its schema.

namespace tautline::bench {

/// The list of metrics, with what each means.
[[nodiscard]] inline Json metrics_json() {
  Json list = Json::array();
  for (const Metric& metric : metric_list()) {
    list.push_back({{"name", metric.name}, {"unit", metric.unit}, {"meaning", metric.meaning}});
  }
  return list;
}

/// A list with a value for every metric of `metric_list`, in its order; an object in JSON.
template <class Values>
struct ByMetric {
  Values& values;
};

template <>
struct Words<Status> {
  static constexpr std::array all = {Status::finished, Status::stopped, Status::diverged,
                                     Status::failed, Status::unsupported};
};
template <>
struct Words<Rebound> {
  static constexpr std::array all = {Rebound::kept,       Rebound::off,      Rebound::lost_below,
                                     Rebound::loses_some, Rebound::scatters, Rebound::none,
                                     Rebound::too_few,    Rebound::elastic};
};
template <>
struct Words<Course> {
  static constexpr std::array all = {Course::exact,     Course::as_good,
                                     Course::converges, Course::does_not_converge,
                                     Course::off,       Course::untold};
};
template <>
struct Words<Barrier> {
  static constexpr std::array all = {Barrier::end, Barrier::effort, Barrier::growth, Barrier::fork};
};
template <>
struct Words<Maker> {
  static constexpr std::array all = {Maker::engine, Maker::by_hand, Maker::tautline};
};
template <>
struct Words<Cables> {
  static constexpr std::array all = {Cables::inextensible, Cables::elastic, Cables::any};
};
template <>
struct Words<Origin> {
  static constexpr std::array all = {Origin::engine_default, Origin::engine_demo, Origin::ours};
};
template <>
struct Words<Word> {
  static constexpr const auto& all = all_words;
};

/// The members of the parts of an error by its causes.
template <class Visitor>
void fields(Visitor& visit, CauseParts& parts) {
  for (std::size_t index = 0; index + 1 < causes.size(); ++index) {
    visit(std::string(to_string(causes[index])), parts[index], meaning_of(causes[index]));
  }
  const std::string last(to_string(causes.back()));
  std::optional<double> part;  // of systems alone
  if (causes_of(parts).size() == causes.size()) {
    part = parts.back();
  }
  visit.unless_missing(last, part, [&](auto& inside, double& size) {
    inside(last, size, meaning_of(causes.back()));
  });
  if (part) {
    parts.back() = *part;
  }
}

/// Writes a count as an integer. A report that was read may have any number in its place.
inline Json json_of(const Metric& metric, const std::optional<double>& value) {
  constexpr double most = 0x1p53;  // up to here a double holds every whole number
  const bool counts = metric.digits.kind == Digits::Kind::shortest && value && *value >= 0.0 &&
                      *value <= most && std::trunc(*value) == *value;
  return counts ? Json(static_cast<std::size_t>(*value)) : json_of(value);
}

inline Json json_of(const Metric& /*metric*/, const std::optional<MedianAndWorst>& value) {
  return json_of(value);
}

template <class Value>
Json json_of(const ByMetric<std::vector<Value>>& metrics) {
  Json object = Json::object();
  for (std::size_t place = 0; place < metrics.values.size(); ++place) {
    const Metric& metric = metric_list()[place];
    object[std::string(metric.name)] = json_of(metric, metrics.values[place]);
  }
  return object;
}

template <class Value>
void read(const Json& json, ByMetric<std::vector<Value>>& metrics) {
  metrics.values.clear();
  for (const Metric& metric : metric_list()) {
    read(json.at(std::string(metric.name)), metrics.values.emplace_back());
  }
}

template <class Value>
Json schema_of(const ByMetric<std::vector<Value>>& /*metrics*/) {
  Describer members;
  for (const Metric& metric : metric_list()) {
    members(std::string(metric.name), Value(),
            fmt::format("{} [{}]", metric.meaning, metric.unit).c_str());
  }
  return std::move(members).schema();
}

template <class Values>
Json json_of(const ByMetric<std::optional<Values>>& metrics) {
  return metrics.values ? json_of(ByMetric<Values>{*metrics.values}) : Json(nullptr);
}

template <class Values>
void read(const Json& json, ByMetric<std::optional<Values>>& metrics) {
  metrics.values.reset();
  if (!json.is_null()) {
    ByMetric<Values> inside{metrics.values.emplace()};
    read(json, inside);
  }
}

template <class Values>
Json schema_of(const ByMetric<std::optional<Values>>& /*metrics*/) {
  Values values;
  return or_nothing(schema_of(ByMetric<Values>{values}));
}

inline void require_agreement(const ImpactColumns& impacts) {
  require_one_length({impacts.time.size(), impacts.cable.size(), impacts.requested.size(),
                      impacts.rate_before.size(), impacts.rate_after.size(), impacts.arm.size(),
                      impacts.tangential_error.size(), impacts.angular_error.size(),
                      impacts.steps.size()});
}
inline void require_agreement(const EventColumns& events) {
  require_one_length(
      {events.time.size(), events.kind.size(), events.cables.size(), events.rate.size()});
}
inline void require_agreement(const Path& path) {
  const std::size_t knots = path.time.steps.size();
  const std::size_t bends = knots < 2 ? 0 : 2 * (knots - 1);
  require_one_length({knots, path.x.steps.size(), path.y.steps.size(), path.angle.steps.size()});
  require_one_length(
      {bends, path.x_bends.steps.size(), path.y_bends.steps.size(), path.angle_bends.steps.size()});
  require_one_length({path.energy_time.steps.size(), path.energy.steps.size()});
}
inline void require_agreement(const BodyPath& path) {
  const std::size_t knots = path.time.steps.size();
  const std::size_t bends = knots < 2 ? 0 : 2 * (knots - 1);
  for (std::size_t k = 0; k < path.places.size(); ++k) {
    require_one_length({knots, path.places[k].steps.size()});
    require_one_length({bends, path.bends[k].steps.size()});
  }
}
inline void require_agreement(const Line& line) {
  require_one_length({line.time.steps.size(), line.value.steps.size()});
}
inline void require_agreement(const TautColumns& taut) {
  require_one_length({taut.gap_times.steps.size(), taut.gap.size()});
}

/// Gives engines that were read the name that stands once in their files.
inline void complete(EngineRow& engine) {
  if (engine.info) {
    engine.info->name = engine.name;
  }
}

}  // namespace tautline::bench
