// The schemas of the files that people write, from the code that reads them.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "bench/base/form.hpp"
#include "bench/base/listed.hpp"
#include "bench/cases/case_form.hpp"
#include "bench/check/contract.hpp"
#include "bench/data/describer.hpp"
#include "bench/ensemble/spec_file.hpp"
#include "bench/gate/listed_problems.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/run/protocol/engine_file.hpp"

namespace tautline::bench {
namespace {

struct WrittenFile {
  const char* name;
  const char* title;
  const char* description;
  Form (*form)();
};

constexpr std::array written_files = {
    WrittenFile{"case", "A case file of tautline",
                "A rigid body on slack cables, as TOML or JSON; docs/reference/case-file.md",
                case_form},
    WrittenFile{"spec", "A spec of tautline ensemble",
                "Which samples of a case are compared; docs/guides/ensembles.md", spec_form},
    WrittenFile{"problems", "A problems file of tautline bench --gate",
                "The problems that runs are known to have; docs/guides/ci-recipe.md",
                problems_form},
    WrittenFile{"engine", "An engine.toml",
                "How tautline starts an engine in a process of its own; engines/protocol/README.md",
                engine_form},
    WrittenFile{"contract", "A contract.toml",
                "The claims that an engine is known not to keep; docs/guides/check.md",
                contract_form},
};

Json schema_of_keys(const Form& table);

/// A whole number as one: 2, not 2.0.
Json number_of(double value, bool whole) {
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

void add_range(const Range& range, Json& schema) {
  schema["type"] = range.whole ? "integer" : "number";
  if (range.whole && range.least && range.least == range.most) {
    schema["const"] = number_of(*range.least, true);
    return;
  }
  if (range.least) {
    schema[range.above ? "exclusiveMinimum" : "minimum"] = number_of(*range.least, range.whole);
  }
  if (range.most) {
    schema["maximum"] = number_of(*range.most, range.whole);
  }
}

Json schema_of_short(const Form& table);

Json schema_of_form(const Form& form) {
  Json schema = Json::object();
  if (!form.meaning.empty()) {
    schema["description"] = form.meaning;
  }
  if (!form.also.empty()) {
    Form alone = form;
    alone.also.clear();
    alone.meaning.clear();
    schema["anyOf"] = {schema_of_form(alone), schema_of_form(form.also.front())};
    return schema;
  }
  switch (form.kind) {
    case Form::Kind::text:
      schema["type"] = "string";
      if (const auto other = std::find(form.words.begin(), form.words.end(), names_of_one);
          other != form.words.end()) {
        schema["anyOf"] = {{{"enum", std::vector(form.words.begin(), other)}},
                           {{"pattern", "[.]|_[0-9]+$"}}};
      } else if (!form.words.empty()) {
        schema["enum"] = form.words;
      } else if (form.not_empty) {
        schema["minLength"] = 1;
      }
      break;
    case Form::Kind::flag:
      schema["type"] = "boolean";
      break;
    case Form::Kind::number:
      add_range(form.range, schema);
      break;
    case Form::Kind::array:
      schema["type"] = "array";
      schema["minItems"] = form.least;
      if (form.most) {
        schema["maxItems"] = *form.most;
      }
      schema["items"] = schema_of_form(form.inside.front());
      break;
    case Form::Kind::table:
      if (form.instead.empty()) {
        schema.update(schema_of_keys(form));
      } else {
        schema["anyOf"] = {schema_of_short(form), schema_of_keys(form)};
      }
      break;
  }
  return schema;
}

/// For the value that may be there instead of a table.
Json schema_of_short(const Form& table) {
  Form value = *find_by(table.inside, &Form::key, table.instead);
  value.meaning = "";
  (value.kind == Form::Kind::array ? value.inside.front() : value).range = table.range;
  return schema_of_form(value);
}

bool is_required(const Form& key) {
  const auto& inside = key.inside;
  // a table whose keys may all be missing may be missing itself
  return key.required && key.with.empty() &&
         (key.kind != Form::Kind::table || !key.instead.empty() ||
          std::any_of(inside.begin(), inside.end(), is_required));
}

/// A schema for each of `keys` that a table may have.
Json any_of_keys(const std::vector<std::string>& keys) {
  Json result = Json::array();
  for (const std::string& key : keys) {
    result.push_back({{"required", {key}}});
  }
  return result;
}

Json schema_of_keys(const Form& table) {
  Json properties = Json::object();
  Json required = Json::array();
  Json together = Json::object();
  Json any_of = Json::array();
  for (const Form& key : table.inside) {
    properties[key.key] = schema_of_form(key);
    if (is_required(key) && !key.unless.empty()) {
      any_of.push_back({{"required", {key.key}}});
      for (const Json& one : any_of_keys(key.unless)) {
        any_of.push_back(one);
      }
    } else if (is_required(key)) {
      required.push_back(key.key);
    }
    if (!key.needs.empty()) {
      together[key.key]["anyOf"] = any_of_keys(key.needs);
    }
    if (!key.not_beside.empty()) {
      together[key.key]["not"]["anyOf"] = any_of_keys(key.not_beside);
    }
    if (!key.with.empty()) {
      together[key.key]["required"].push_back(key.with);
      if (key.required) {
        together[key.with]["required"].push_back(key.key);
      }
    }
  }
  Json schema = {{"type", "object"}, {"additionalProperties", false}};
  Json one_of = Json::array();
  for (const std::string& key : table.either) {
    one_of.push_back({{"required", {key}}});
  }
  if (table.least > 0) {
    schema["minProperties"] = table.least;
  }
  if (!one_of.empty()) {
    schema["oneOf"] = std::move(one_of);
  }
  if (!any_of.empty()) {
    schema["anyOf"] = std::move(any_of);
  }
  if (!together.empty()) {
    schema["dependencies"] = std::move(together);
  }
  if (table.each) {  // the table and the entry say together what is required
    const Json entry = {
        {"type", "object"}, {"additionalProperties", false}, {"properties", properties}};
    properties["each"] = {{"description", "what tells each entry from the others of this table"},
                          {"type", "array"},
                          {"minItems", 1},
                          {"maxItems", *table.each},
                          {"items", entry}};
    schema["anyOf"] = {{{"required", std::move(required)}}, {{"required", {"each"}}}};
  } else {
    schema["required"] = std::move(required);
  }
  schema["properties"] = std::move(properties);
  return schema;
}

}  // namespace

void add_schema_command(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("schema", "The JSON schema of a file that you write, for an editor");
  const auto asked = std::make_shared<std::string>();
  command->add_option("FILE", *asked, "the kind of file")
      ->required()
      ->check(CLI::IsMember(listed<std::string>(written_files, &WrittenFile::name)));
  command->footer("tautline schema case > case.schema.json    then #:schema ./case.schema.json");
  command->callback([asked] {
    const WrittenFile& file = *find_by(written_files, &WrittenFile::name, *asked);
    fmt::print("{}", text_of(headed(file.title, file.description, schema_of_form(file.form()))));
  });
}

}  // namespace tautline::bench
