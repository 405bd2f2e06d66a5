#include "bench/program/common.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>

namespace tautline::bench {
namespace {

std::map<std::string, ImpactLaw> law_names() {
  std::map<std::string, ImpactLaw> names;
  for (const ImpactLaw law : impact_laws) {
    names.emplace(to_string(law), law);
  }
  return names;
}

}  // namespace

void add_law(CLI::App& command, ImpactLaw& law, const std::string& help) {
  command
      .add_option_function<std::string>(
          "--law", [&law](const std::string& name) { law = law_names().at(name); }, help)
      ->option_text("LAW")
      ->check(CLI::IsMember(law_names()))
      ->default_str("simultaneous");
}

CLI::Option* add_target(CLI::App& command, const std::string& option, std::string& file,
                        const std::string& help) {
  return command.add_option(option, file, help + " to this file, or to stdout: -")
      ->option_text("FILE")
      ->check([](const std::string& name) {
        return std::string(name.empty() ? "must be the name of a file, or -" : "");
      });
}

void add_schema(CLI::App& command, std::string (*schema)()) {
  command.add_flag_callback(
      "--schema",
      [schema] {
        fmt::print("{}", schema());
        throw CLI::Success();  // as --help ends
      },
      "print the JSON schema of what it writes, and end");
}

}  // namespace tautline::bench
