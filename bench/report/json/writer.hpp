#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/report/json/fields.hpp"

// From the rows of a report to JSON, which has no number that is not finite: it becomes null.

namespace tautline::bench {

using Json = nlohmann::ordered_json;

inline Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
inline Json json_of(std::size_t value) { return value; }
inline Json json_of(std::int32_t value) { return value; }
inline Json json_of(bool value) { return value; }
inline Json json_of(const std::string& value) { return value; }
inline Json json_of(Status value) { return to_string(value); }
inline Json json_of(Maker value) { return to_string(value); }
inline Json json_of(Word value) { return to_string(value); }
inline Json json_of(Holds value) {
  return value == Holds::not_measured ? Json(nullptr) : Json(value == Holds::yes);
}
inline Json json_of(const Vec2& value) { return Json::array({value.x(), value.y()}); }
inline Json json_of(CableSet value) { return value.indices(); }

inline Json json_of(const CauseParts& parts) {
  Json object = Json::object();
  for (std::size_t index = 0; index < causes.size(); ++index) {
    object[std::string(to_string(causes[index]))] = json_of(parts[index]);
  }
  return object;
}

template <class Value>
Json json_of(const std::optional<Value>& value);
template <class Value>
Json json_of(const std::vector<Value>& values);
template <class Value>
Json json_of(const ByName<Value>& values);
template <class Row>
Json json_of(const Row& row);

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

/// Makes an object of the members that `fields` shows it.
class Writer {
 public:
  template <class Value>
  void operator()(const char* key, const Value& value, const Says& /*says*/ = {}) {
    object_[key] = json_of(value);
  }

  template <class Members>
  void group(const char* key, const Says& /*says*/, const Members& members) {
    Writer inside;
    members(inside);
    object_[key] = std::move(inside.object_);
  }

  template <class Value>
  void by_metric(const char* key, const std::vector<Value>& values, const Says& /*says*/ = {}) {
    Json object = Json::object();
    for (std::size_t place = 0; place < values.size(); ++place) {
      const Metric& metric = metric_list()[place];
      object[std::string(metric.name)] = json_of(metric, values[place]);
    }
    object_[key] = std::move(object);
  }

  template <class Value>
  void by_metric(const char* key, const std::optional<std::vector<Value>>& values,
                 const Says& /*says*/) {
    values ? by_metric(key, *values) : void(object_[key] = nullptr);
  }

  template <class Value, class Members>
  void unless_missing(const char* /*first*/, std::optional<Value>& value, const Members& members) {
    if (value) {
      members(*this, *value);
    }
  }

  static void means(const char* /*meaning*/) {}

  [[nodiscard]] Json object() && { return std::move(object_); }

 private:
  Json object_ = Json::object();
};

template <class Value>
Json json_of(const std::optional<Value>& value) {
  return value ? json_of(*value) : Json(nullptr);
}

template <class Value>
Json json_of(const std::vector<Value>& values) {
  Json array = Json::array();
  for (const Value& value : values) {
    array.push_back(json_of(value));
  }
  return array;
}

template <class Value>
Json json_of(const ByName<Value>& values) {
  Json object = Json::object();
  for (const auto& [name, value] : values.rows) {
    object[name] = json_of(value);
  }
  return object;
}

template <class Row>
Json json_of(const Row& row) {
  Writer writer;
  fields(writer, const_cast<Row&>(row));  // NOLINT: a writer only looks
  return std::move(writer).object();
}

}  // namespace tautline::bench
