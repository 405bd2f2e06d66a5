#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/data/writer.hpp"

// The schema of what is written as JSON, from the members by which it is written.

namespace tautline::bench {

inline Json schema_of(const double& /*value*/) { return {{"type", "number"}}; }
inline Json schema_of(const std::size_t& /*value*/) {
  return {{"type", "integer"}, {"minimum", 0}};
}
inline Json schema_of(const std::int32_t& /*value*/) { return {{"type", "integer"}}; }
inline Json schema_of(const bool& /*value*/) { return {{"type", "boolean"}}; }
inline Json schema_of(const std::string& /*value*/) { return {{"type", "string"}}; }

inline Json list_of(Json one) { return {{"type", "array"}, {"items", std::move(one)}}; }
inline Json schema_of(const CableSet& /*value*/) { return list_of(schema_of(std::size_t())); }
inline Json schema_of(const CableVector& /*values*/) { return list_of(schema_of(double())); }
inline Json schema_of_numbers(int count) {
  Json schema = list_of(schema_of(double()));
  schema["minItems"] = count;
  schema["maxItems"] = count;
  return schema;
}
template <int N>
requires(N > 0) Json schema_of(const Eigen::Matrix<double, N, 1>& /*value*/) {
  return schema_of_numbers(N);
}
template <int N>
requires(N > 0) Json schema_of(const std::vector<Eigen::Matrix<double, N, 1>>& /*values*/) {
  return list_of(schema_of_numbers(N));
}

inline Json or_nothing(Json schema) {
  schema["type"] = {schema["type"], "null"};
  return schema;
}

/// The words for the enumerators.
template <Enumeration Enum>
Json schema_of(const Enum& /*value*/) {
  Json words = Json::array();
  for (const Enum one : Words<Enum>::all) {
    words.push_back(to_string(one));
  }
  return {{"enum", std::move(words)}};
}
template <class Value>
Json schema_of(const std::optional<Value>& /*value*/);
template <class Value>
Json schema_of(const std::vector<Value>& /*values*/);
template <class Value>
Json schema_of(const ByName<Value>& /*values*/);
template <class Row>
Json schema_of(const Row& /*row*/);

/// Adds to the schema of a member what is said of it.
inline void add(const Says& says, Json& schema) {
  Json* one = &schema;  // of the members of lists, and of lists of them
  while (one->contains("items")) {
    one = &one->at("items");
  }
  if (!says.words.empty()) {
    *one = {{"enum", says.words}};
  }
  if (says.or_null) {
    *one = or_nothing(*one);
  }
  if (says.least) {
    (*one)[says.exclusive ? "exclusiveMinimum" : "minimum"] = *says.least;
  }
  if (says.most) {
    (*one)["maximum"] = *says.most;
  }
  if (says.some) {
    schema["minItems"] = 1;
  }
  if (says.count) {
    schema["minItems"] = schema["maxItems"] = *says.count;
  }
  if (*says.meaning != '\0') {
    schema["description"] = says.meaning;
  }
}

/// Makes the schema of an object with the members that `fields` shows it, all of them and no other.
class Describer {
 public:
  template <class Value>
  void operator()(const std::string& key, const Value& value, const Says& says = {}) {
    add_member(key, schema_of(value), says);
  }

  template <class Members>
  void group(const std::string& key, const Says& says, const Members& members) {
    Describer inside;
    members(inside);
    add_member(key, std::move(inside).schema(), says);
  }

  template <class Value>
  void if_any(const std::string& key, const std::optional<Value>& /*value*/,
              const Says& says = {}) {
    required_ = false;
    (*this)(key, Value(), says);
    required_ = true;
  }

  template <class Value, class Members>
  void unless_missing(const std::string& /*first*/, const std::optional<Value>& /*value*/,
                      const Members& members) {
    required_ = false;
    Value value{};
    members(*this, value);
    required_ = true;
  }

  template <class Row, class Drawn>
  void drawn(const std::string& key, const std::vector<Row>& /*rows*/,
             const std::vector<Drawn>& /*all*/) {
    Describer inside;
    Row row{};
    Drawn its{};
    fields(inside, row, its);
    add_member(key, list_of(std::move(inside).schema()));
  }

  void means(const char* meaning) { meaning_ = meaning; }

  void add_member(const std::string& key, Json schema, const Says& says = {}) {
    add(says, schema);
    members_[key] = std::move(schema);
    if (required_) {
      all_.push_back(key);
    }
  }

  [[nodiscard]] Json schema() && {
    Json schema = {{"type", "object"}};
    add(meaning_, schema);
    schema["additionalProperties"] = false;
    schema["required"] = std::move(all_);
    schema["properties"] = std::move(members_);
    return schema;
  }

 private:
  Json members_ = Json::object();
  Json all_ = Json::array();  // names of the members that may not be missing
  Says meaning_;
  bool required_ = true;
};

template <class Value>
Json schema_of(const std::optional<Value>& /*value*/) {
  return or_nothing(schema_of(Value()));
}

template <class Value>
Json schema_of(const std::vector<Value>& /*values*/) {
  return list_of(schema_of(Value()));
}

template <class Value>
Json schema_of(const ByName<Value>& /*values*/) {
  return {{"type", "object"}, {"additionalProperties", schema_of(Value())}};
}

template <class Row>
Json schema_of(const Row& /*row*/) {
  Describer describer;
  Row row{};
  fields(describer, row);
  return std::move(describer).schema();
}

/// `schema` with what stands at the head of a schema.
[[nodiscard]] inline Json headed(const char* title, const char* description, const Json& schema) {
  Json head = {{"$schema", "http://json-schema.org/draft-07/schema#"},
               {"title", title},
               {"description", description}};
  head.update(schema);
  return head;
}

/// Indented, with a line break at its end.
[[nodiscard]] inline std::string text_of(const Json& json) { return json.dump(2) + "\n"; }

}  // namespace tautline::bench
