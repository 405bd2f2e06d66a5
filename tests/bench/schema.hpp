#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tests/bench/support.hpp"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace tautline::test {

/// True where what the program wrote is as the JSON schema of this file says.
[[nodiscard]] inline bool keeps_the_schema(const nlohmann::json& written, const std::string& file) {
  const auto text = nlohmann::json::parse(bench::test::content_of(file));
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  valijson::Validator validator;
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(written), nullptr);
}

}  // namespace tautline::test
