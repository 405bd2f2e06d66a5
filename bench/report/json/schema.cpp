// The schema of a report, from the members by which it is written and read.

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/report/json/fields.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/json/reader.hpp"
#include "bench/report/json/writer.hpp"

namespace tautline::bench {
namespace {

Json schema_of(const double& /*value*/) { return {{"type", "number"}}; }
Json schema_of(const std::size_t& /*value*/) { return {{"type", "integer"}, {"minimum", 0}}; }
Json schema_of(const std::int32_t& /*value*/) { return {{"type", "integer"}}; }
Json schema_of(const bool& /*value*/) { return {{"type", "boolean"}}; }
Json schema_of(const std::string& /*value*/) { return {{"type", "string"}}; }
Json schema_of(const Holds& /*value*/) { return {{"type", {"boolean", "null"}}}; }

/// Of an enumeration: the words for its enumerators.
template <class Enum, std::size_t count>
Json schema_of_words(const std::array<Enum, count>& all) {
  Json words = Json::array();
  for (const Enum one : all) {
    words.push_back(to_string(one));
  }
  return {{"enum", std::move(words)}};
}
Json schema_of(const Status& /*value*/) { return schema_of_words(statuses); }
Json schema_of(const Maker& /*value*/) { return schema_of_words(makers); }
Json schema_of(const Word& /*value*/) { return schema_of_words(all_words); }

Json list_of(Json one) { return {{"type", "array"}, {"items", std::move(one)}}; }
Json schema_of(const CableSet& /*value*/) { return list_of(schema_of(std::size_t())); }
Json schema_of(const Vec2& /*value*/) {
  Json schema = list_of(schema_of(double()));
  schema["minItems"] = 2;
  schema["maxItems"] = 2;
  return schema;
}

Json or_nothing(Json schema) {
  schema["type"] = {schema["type"], "null"};
  return schema;
}

Json schema_of(const CauseParts& parts);
template <class Value>
Json schema_of(const std::optional<Value>& /*value*/);
template <class Value>
Json schema_of(const std::vector<Value>& /*values*/);
template <class Row>
Json schema_of(const Row& /*row*/);

/// Adds to the schema of a member what is said of it.
void add(const Says& says, Json& schema) {
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
  void by_metric(const std::string& key, const std::vector<Value>& /*values*/, const Says& says) {
    add_member(key, of_metrics<Value>(), says);
  }

  template <class Value>
  void by_metric(const std::string& key, const std::optional<std::vector<Value>>& /*values*/,
                 const Says& says) {
    add_member(key, or_nothing(of_metrics<Value>()), says);
  }

  template <class Value, class Members>
  void unless_missing(const char* /*first*/, const std::optional<Value>& /*value*/,
                      const Members& members) {
    required_ = false;
    Value value;
    members(*this, value);
    required_ = true;
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
  template <class Value>
  static Json of_metrics() {
    Describer metrics;
    for (const Metric& metric : metric_list()) {
      metrics(std::string(metric.name), Value(),
              fmt::format("{} [{}]", metric.meaning, metric.unit).c_str());
    }
    return std::move(metrics).schema();
  }

  Json members_ = Json::object();
  Json all_ = Json::array();  // names of the members that may not be missing
  Says meaning_;
  bool required_ = true;
};

Json schema_of(const CauseParts& parts) {
  Describer describer;
  for (std::size_t index = 0; index < causes.size(); ++index) {
    describer(std::string(to_string(causes[index])), parts[index], meaning_of(causes[index]));
  }
  return std::move(describer).schema();
}

template <class Value>
Json schema_of(const std::optional<Value>& /*value*/) {
  return or_nothing(schema_of(Value()));
}

template <class Value>
Json schema_of(const std::vector<Value>& /*values*/) {
  return list_of(schema_of(Value()));
}

template <class Row>
Json schema_of(const Row& /*row*/) {
  Describer describer;
  Row row;
  fields(describer, row);
  return std::move(describer).schema();
}

}  // namespace

std::string report_schema_json() {
  Describer program;
  program.add_member("name", {{"const", "tautline"}});
  program("version", std::string());
  Describer metric;
  metric("name", std::string());
  metric("unit", std::string(), "1 for a ratio or a count");
  metric("meaning", std::string());

  Describer members;
  members.add_member("schema", {{"const", report_schema}});
  members.add_member("program", std::move(program).schema());
  members.add_member("metrics", list_of(std::move(metric).schema()),
                     "what a run is measured by; the smaller, the better");
  Report report;
  fields(members, report);
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Report of `tautline bench`"},
                 {"description",
                  "Two runs of one suite on one program give the same text but for the last key, "
                  "context."}};
  schema.update(std::move(members).schema());
  return schema.dump(2) + "\n";
}

}  // namespace tautline::bench
