#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/data/says.hpp"
#include "tautline/cable_set.hpp"
#include "tautline/geometry.hpp"

// From JSON back to a row by its `fields`. Throws nlohmann's exceptions where it is no such JSON.

namespace tautline::bench {

using Json = nlohmann::ordered_json;

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
inline void read(const Json& json, Vec2& value) {
  value = {json.at(0).get<double>(), json.at(1).get<double>()};
}

inline void read(const Json& json, CableSet& value) {
  value = CableSet();
  for (const Json& index : json) {
    std::size_t cable = 0;
    read(index, cable);
    if (cable >= max_cables) {
      throw Json::other_error::create(501, "a case has fewer cables", nullptr);
    }
    value.insert(cable);
  }
}

/// The enumerator of a word.
template <Enumeration Enum>
void read(const Json& json, Enum& value) {
  const std::string word = json.get<std::string>();
  const auto* const found = std::find_if(Words<Enum>::all.begin(), Words<Enum>::all.end(),
                                         [&](Enum one) { return to_string(one) == word; });
  if (found == Words<Enum>::all.end()) {
    throw Json::other_error::create(501, "unknown word " + printable(word), nullptr);
  }
  value = *found;
}
template <class Value>
void read(const Json& json, std::optional<Value>& value);
template <class Value>
void read(const Json& json, std::vector<Value>& values);
template <class Row>
void read(const Json& json, Row& row);

/// `json`, which must be a list.
inline const Json& list_in(const Json& json) {
  if (!json.is_array()) {
    throw Json::other_error::create(501, "a list must be an array", nullptr);
  }
  return json;
}

/// Fills the members that `fields` shows it from an object.
class Reader {
 public:
  explicit Reader(const Json& object) : object_(object) {}

  template <class Value>
  void operator()(const std::string& key, Value& value, const Says& /*says*/ = {}) {
    read(object_.at(key), value);
  }

  template <class Members>
  void group(const std::string& key, const Says& /*says*/, const Members& members) {
    Reader inside(object_.at(key));
    members(inside);
  }

  template <class Row, class Drawn>
  void drawn(const std::string& key, std::vector<Row>& rows, std::vector<Drawn>& drawn) {
    rows.clear();
    drawn.clear();
    for (const Json& one : list_in(object_.at(key))) {
      Reader inside(one);
      fields(inside, rows.emplace_back(), drawn.emplace_back());
    }
  }

  template <class Value, class Members>
  void unless_missing(const std::string& first, std::optional<Value>& value,
                      const Members& members) {
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
  for (const Json& one : list_in(json)) {
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
template <class Row>
void read(const Json& json, Row& row) {
  Reader reader(json);
  fields(reader, row);
  require_agreement(row);
}

}  // namespace tautline::bench
