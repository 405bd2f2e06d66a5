#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/report/json/fields.hpp"

// From JSON back to the rows of a report. Throws nlohmann's exceptions where it is no such JSON.

namespace tautline::bench {

using Json = nlohmann::ordered_json;

/// The words that stand for an enumerator.
template <class Enum, std::size_t count>
Enum from_word(const std::array<Enum, count>& all, const std::string& word) {
  for (const Enum one : all) {
    if (to_string(one) == word) {
      return one;
    }
  }
  throw Json::other_error::create(501, "unknown word " + printable(word), nullptr);
}
inline constexpr std::array statuses = {Status::finished, Status::stopped, Status::diverged,
                                        Status::failed};
inline constexpr std::array makers = {Maker::engine, Maker::by_hand, Maker::tautline};

inline void read(const Json& json, double& value) {
  value = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}
inline void read(const Json& json, std::size_t& value) {
  if (!json.is_number_unsigned()) {
    throw Json::other_error::create(501, "a count must be a whole number, 0 or above", nullptr);
  }
  value = json.get<std::size_t>();
}
inline void read(const Json& json, std::int32_t& value) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  const std::int64_t whole = json.is_number_integer() ? json.get<std::int64_t>() : most + 1;
  if (whole < -most || whole > most) {
    throw Json::other_error::create(501, "a step on a grid must be a whole number below 2^31",
                                    nullptr);
  }
  value = static_cast<std::int32_t>(whole);
}
inline void read(const Json& json, bool& value) { value = json.get<bool>(); }
inline void read(const Json& json, std::string& value) { value = json.get<std::string>(); }
inline void read(const Json& json, Status& value) {
  value = from_word(statuses, json.get<std::string>());
}
inline void read(const Json& json, Maker& value) {
  value = from_word(makers, json.get<std::string>());
}
inline void read(const Json& json, Word& value) {
  value = from_word(all_words, json.get<std::string>());
}
inline void read(const Json& json, Holds& value) {
  value = json.is_null() ? Holds::not_measured : json.get<bool>() ? Holds::yes : Holds::no;
}
inline void read(const Json& json, Vec2& value) {
  value = {json.at(0).get<double>(), json.at(1).get<double>()};
}

inline void read(const Json& json, CableSet& value) {
  value = CableSet();
  for (const Json& index : json) {
    std::size_t cable = 0;
    read(index, cable);
    if (cable >= max_cables) {
      throw Json::other_error::create(501, "no case has so many cables", nullptr);
    }
    value.insert(cable);
  }
}

inline void read(const Json& json, CauseParts& parts) {
  for (std::size_t index = 0; index < causes.size(); ++index) {
    read(json.at(std::string(to_string(causes[index]))), parts[index]);
  }
}

template <class Value>
void read(const Json& json, std::optional<Value>& value);
template <class Value>
void read(const Json& json, std::vector<Value>& values);
template <class Row>
void read(const Json& json, Row& row);

/// Fills the members that `fields` shows it from an object.
class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) {}

  template <class Value>
  void operator()(const char* key, Value& value, const Says& /*says*/ = {}) {
    read(object_.at(key), value);
  }

  template <class Members>
  void group(const char* key, const Says& /*says*/, const Members& members) {
    Reader inside(object_.at(key));
    members(inside);
  }

  template <class Value>
  void by_metric(const char* key, std::vector<Value>& values, const Says& /*says*/ = {}) {
    values.clear();
    for (const Metric& metric : metric_list()) {
      read(object_.at(key).at(std::string(metric.name)), values.emplace_back());
    }
  }

  template <class Value>
  void by_metric(const char* key, std::optional<std::vector<Value>>& values, const Says& /*says*/) {
    values.reset();
    if (!object_.at(key).is_null()) {
      by_metric(key, values.emplace());
    }
  }

  template <class Value, class Members>
  void unless_missing(const char* first, std::optional<Value>& value, const Members& members) {
    value.reset();
    if (object_.contains(first)) {
      members(*this, value.emplace());
    }
  }

  static void means(const char* /*meaning*/) {}

 private:
  const Json& object_;
};

template <class Value>
void read(const Json& json, std::optional<Value>& value) {
  value.reset();
  if (!json.is_null()) {
    read(json, value.emplace());
  }
}

template <class Value>
void read(const Json& json, std::vector<Value>& values) {
  values.clear();
  if (!json.is_array()) {
    throw Json::other_error::create(501, "a list must be an array", nullptr);
  }
  for (const Json& one : json) {
    read(one, values.emplace_back());
  }
}

/// Throws unless all columns have one length, which every user of them relies on.
inline void require_one_length(std::initializer_list<std::size_t> lengths) {
  if (std::any_of(lengths.begin(), lengths.end(),
                  [&](std::size_t one) { return one != *lengths.begin(); })) {
    throw Json::other_error::create(501, "columns must be of one length", nullptr);
  }
}

/// Throws if the members of a row contradict each other. Members of most rows cannot.
template <class Row>
void require_agreement(const Row& /*row*/) {}
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
inline void require_agreement(const TautColumns& taut) {
  require_one_length({taut.gap_times.steps.size(), taut.gap.size()});
}

template <class Row>
void read(const Json& json, Row& row) {
  Reader reader(json);
  fields(reader, row);
  require_agreement(row);
}

/// Gives engines that were read the name that stands once in their files.
inline void complete(EngineRow& engine) {
  if (engine.info) {
    engine.info->name = engine.name;
  }
}

}  // namespace tautline::bench
