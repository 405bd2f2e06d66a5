#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/data/says.hpp"
#include "tautline/cable_set.hpp"
#include "tautline/case.hpp"
#include "tautline/geometry.hpp"

// From a row to JSON by its `fields`. JSON has no number that is not finite: it becomes null.

namespace tautline::bench {

using Json = nlohmann::ordered_json;

[[nodiscard]] inline std::string on_one_line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

inline Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
inline Json json_of(std::size_t value) { return value; }
inline Json json_of(std::int32_t value) { return value; }
inline Json json_of(bool value) { return value; }
inline Json json_of(const std::string& value) { return value; }
template <int N>
requires(N > 0) Json json_of(const Eigen::Matrix<double, N, 1>& value) {
  return Json(std::vector<double>(value.begin(), value.end()));
}
inline Json json_of(CableSet value) { return value.indices(); }
inline Json json_of(const CableVector& values) {
  Json list = Json::array();
  for (const double value : values) {
    list.push_back(json_of(value));
  }
  return list;
}

template <Enumeration Enum>
Json json_of(const Enum& value) {
  return to_string(value);
}
template <class Value>
Json json_of(const std::optional<Value>& value);
template <class Value>
Json json_of(const std::vector<Value>& values);
template <class Value>
Json json_of(const ByName<Value>& values);
template <class Row>
Json json_of(const Row& row);
template <class... Rows>
Json object_of(const Rows&... rows);

/// Makes an object of the members that `fields` shows it.
class Writer {
 public:
  template <class Value>
  void operator()(const std::string& key, const Value& value, const Says& /*says*/ = {}) {
    object_[key] = json_of(value);
  }

  template <class Members>
  void group(const std::string& key, const Says& /*says*/, const Members& members) {
    Writer inside;
    members(inside);
    object_[key] = std::move(inside.object_);
  }

  /// A member that is missing where there is no `value`.
  template <class Value>
  void if_any(const std::string& key, const std::optional<Value>& value, const Says& says = {}) {
    if (value) {
      (*this)(key, *value, says);
    }
  }

  template <class Value, class Members>
  void unless_missing(const std::string& /*first*/, std::optional<Value>& value,
                      const Members& members) {
    if (value) {
      members(*this, *value);
    }
  }

  template <class Row, class Drawn>
  void drawn(const std::string& key, const std::vector<Row>& rows,
             const std::vector<Drawn>& drawn) {
    Json array = Json::array();
    for (std::size_t place = 0; place < rows.size(); ++place) {
      array.push_back(object_of(rows[place], drawn.at(place)));
    }
    object_[key] = std::move(array);
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

/// The object that the `fields` of rows make together.
template <class... Rows>
Json object_of(const Rows&... rows) {
  Writer writer;
  fields(writer, const_cast<Rows&>(rows)...);  // NOLINT: a writer only looks
  return std::move(writer).object();
}

template <class Row>
Json json_of(const Row& row) {
  return object_of(row);
}

/// `object` with a line for each of its values, and for each element where that is a list: an event
/// by itself is read at a glance, and indents would nearly double what a long motion takes.
[[nodiscard]] inline std::string in_lines(const Json& object) {
  std::string result;
  for (const auto& [key, value] : object.items()) {
    result += (result.empty() ? "{\n  " : ",\n  ") + Json(key).dump() + ": ";
    if (!value.is_array() || value.empty()) {
      result += value.dump();
      continue;
    }
    const char* before = "[\n    ";
    for (const Json& element : value) {
      result += before + element.dump();
      before = ",\n    ";
    }
    result += "\n  ]";
  }
  return result + "\n}\n";
}

}  // namespace tautline::bench
