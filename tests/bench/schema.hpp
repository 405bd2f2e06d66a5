#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tests/bench/program.hpp"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace tautline::test {

/// Every way in which `written` breaks `schema`, a line each; "" if none.
[[nodiscard]] inline std::string broken_rules(const nlohmann::json& written,
                                              const nlohmann::json& schema) {
  valijson::Schema rules;
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema), rules);
  valijson::ValidationResults results;
  valijson::Validator().validate(rules, valijson::adapters::NlohmannJsonAdapter(written), &results);
  std::string found;
  valijson::ValidationResults::Error error;
  while (results.popError(error)) {
    for (const std::string& place : error.context) {
      found += place;
    }
    found += ": " + error.description + "\n";
  }
  return found;
}

/// The same of what `command` wrote, by the schema that it prints.
[[nodiscard]] inline std::string broken_rules_of(const nlohmann::json& written,
                                                 const std::string& command) {
  return broken_rules(written, nlohmann::json::parse(program({command, "--schema"}).output));
}

[[nodiscard]] inline bool keeps_the_schema(const nlohmann::json& written,
                                           const std::string& command) {
  return broken_rules_of(written, command).empty();
}

}  // namespace tautline::test
