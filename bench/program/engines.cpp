#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/engine_json.hpp"
#include "bench/run/registry.hpp"

namespace tautline::bench {
namespace {

/// What `tautline engines` was asked.
struct EnginesCommand {
  std::string json;
};

void print_engine(const RegisteredEngine& engine, const TerminalStyle& style) {
  if (!engine.info) {
    const std::string why =
        engine.missing.empty() ? engine.failure : "not available: " + engine.missing;
    const std::string package =
        engine.missing.empty() || engine.package.empty() ? "" : " (package " + engine.package + ")";
    fmt::print("{}\n", wrapped_lines(engine.name + "  " + printable(why) + package, style.text, 2));
    return;
  }
  fmt::print("{}  version {}, {}\n", engine.info->name, printable(engine.info->version),
             engine.info->precision);
  Table models({"  model", "what it is"}, 2);
  std::vector<std::string> in_space;
  std::vector<std::string> elastic;
  for (const Model& model : engine.info->models) {
    models.add({"  " + model.name, printable(model.sentence, 1000)});
    if (model.in_space) {
      in_space.push_back(model.name);
    }
    if (model.cables != Cables::inextensible) {
      elastic.push_back(model.name);
    }
  }
  const auto print_names = [&](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) {
      fmt::print("{}", wrapped_lines(fmt::format("  {}: {}\n", what, fmt::join(names, ", ")),
                                     style.text, 2));
    }
  };
  print_names("also systems in space", in_space);
  print_names("systems with elastic cables", elastic);
  const std::string text = models.plain(style);
  fmt::print("{}\n", text.substr(text.find('\n') + 1));  // without the headings
}

int engines_command(const EnginesCommand& command) {
  if (complain(missing_folder("--json", command.json))) {
    return exit_usage;
  }
  const auto engines = registered_engines(Asked::all);
  if (!command.json.empty()) {
    write_output(command.json, engines_json(engines));
    return exit_done;
  }
  for (const RegisteredEngine& engine : engines) {
    print_engine(engine, output_style());
  }
  return exit_done;
}

}  // namespace

void add_engines(CLI::App& app, int& code) {
  CLI::App* const command =
      app.add_subcommand("engines", "The installed engines, their models, and those missing");
  const auto asked = std::make_shared<EnginesCommand>();
  add_target(*command, "--json", asked->json, "write the list as JSON");
  add_schema(*command, engines_schema_json);
  command->callback([asked, &code] { code = engines_command(*asked); });
}

}  // namespace tautline::bench
