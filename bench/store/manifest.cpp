#include "bench/store/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "bench/base/atomic_file.hpp"
#include "bench/base/input_file.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/report/json/fields.hpp"
#include "bench/store/run_files.hpp"
#include "bench/store/source_commit.hpp"
#include "tautline/case_file.hpp"

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, Manifest::Program& program) {
  visit("version", program.version);
  visit("commit", program.commit);
  visit("hash", program.hash);
}

template <class Visitor>
void fields(Visitor& visit, Manifest::Engine& engine) {
  fields(visit, engine.row);
  visit("plugin", engine.plugin);
}

template <class Visitor>
void fields(Visitor& visit, Manifest& manifest) {
  visit("program", manifest.program);
  visit("shard", manifest.shard);
  visit("options", manifest.options);
  visit("models", manifest.models);
  visit("engines", manifest.engines);
  visit("cases", manifest.cases);
}

namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = "suite.json";

/// A longer one is none: ten thousand cases have some 6 MB [bytes].
constexpr std::size_t longest_manifest = std::size_t{1} << 26U;

std::string in_digits(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::uint64_t hash_from(const std::string& digits) {
  std::uint64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  return value;
}

ImpactLaw law_from(const std::string& name) {
  const auto found = std::find_if(impact_laws.begin(), impact_laws.end(),
                                  [&](ImpactLaw law) { return to_string(law) == name; });
  if (found == impact_laws.end()) {
    throw std::runtime_error("unknown law " + printable(name));
  }
  return *found;
}

RegisteredEngine engine_from(const EngineRow& row) {
  RegisteredEngine engine;
  engine.name = row.name;
  engine.info = row.info;
  (row.missing ? engine.missing : engine.failure) = row.problem.value_or("");
  return engine;
}

}  // namespace

std::string manifest_json(const Manifest& manifest) {
  Json json = {{"schema", manifest_schema}};
  json.update(json_of(manifest));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<Manifest> manifest_from(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    if (json.at("schema") != manifest_schema) {
      return std::nullopt;
    }
    Manifest manifest;
    read(json, manifest);
    for (Manifest::Engine& engine : manifest.engines) {
      complete(engine.row);
    }
    return manifest;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::vector<EngineRow> engine_rows(const std::vector<RegisteredEngine>& engines) {
  std::vector<EngineRow> rows;
  for (const RegisteredEngine& engine : engines) {
    EngineRow& row = rows.emplace_back();
    row.name = engine.info ? engine.info->name : engine.name;
    row.info = engine.info;
    if (!engine.info) {
      row.problem = printable(engine.failure.empty() ? engine.missing : engine.failure);
    }
    row.missing = !engine.missing.empty();
  }
  return rows;
}

ReportOptions report_options(const SuiteOptions& options) {
  return {options.steps,
          std::string(to_string(options.law)),
          options.compare.count_speed,
          options.compare.early_impacts,
          options.limits.time,
          static_cast<double>(options.limits.memory),
          options.certify};
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return printable(line.substr(colon + 2));
    }
  }
  return "unknown";
}

Manifest manifest_of(const SuiteOptions& options, const std::string& command,
                     const std::string& started) {
  Manifest manifest;
  manifest.program = {TAUTLINE_VERSION, std::string(source_commit()), in_digits(program_hash())};
  manifest.cases = listed(options.cases, written);
  const std::vector<EngineRow> rows = engine_rows(options.engines);
  for (std::size_t engine = 0; engine < rows.size(); ++engine) {
    manifest.engines.push_back({rows[engine], in_digits(plugin_hash(options, engine))});
  }
  manifest.models = options.models;
  manifest.options = report_options(options);
  manifest.shard = {options.shard.number,
                    options.shard.of,
                    printable(command, longest_command),
                    started,
                    0.0,
                    processor_name(),
                    std::thread::hardware_concurrency()};
  return manifest;
}

SuiteOptions options_of(const Manifest& manifest) {
  SuiteOptions options;
  for (const std::string& text : manifest.cases) {
    options.cases.push_back(bench_case_from(text, manifest_name));
  }
  for (const Manifest::Engine& engine : manifest.engines) {
    options.engines.push_back(engine_from(engine.row));
    options.plugins.push_back(hash_from(engine.plugin));
  }
  options.models = manifest.models;
  options.steps = manifest.options.steps;
  options.law = law_from(manifest.options.law);
  options.limits.time = manifest.options.time_limit;
  options.limits.memory = static_cast<std::size_t>(manifest.options.memory_limit);
  options.certify = manifest.options.certify;
  options.shard = {manifest.shard.number, manifest.shard.of};
  return options;
}

void write_manifest(const fs::path& out, const Manifest& manifest) {
  write_file(out / manifest_name, manifest_json(manifest));
}

std::optional<Manifest> read_manifest(const fs::path& tree) {
  const InputFile file = read_input_file(tree / manifest_name, longest_manifest);
  return file.problem ? std::nullopt : manifest_from(file.content);
}

}  // namespace tautline::bench
