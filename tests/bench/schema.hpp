#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tests/bench/program.hpp"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace tautline::test {

/// True where what `command` wrote is as the schema says that it prints.
[[nodiscard]] inline bool keeps_the_schema(const nlohmann::json& written,
                                           const std::string& command) {
  const auto text = nlohmann::json::parse(program({command, "--schema"}).output);
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  valijson::Validator validator;
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(written), nullptr);
}

}  // namespace tautline::test
