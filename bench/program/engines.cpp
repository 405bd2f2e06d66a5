#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/base/text.hpp"
#include "bench/program/commands.hpp"
#include "bench/run/registry.hpp"
#include "bench/run/wire.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

void print_engine(const RegisteredEngine& engine) {
  if (!engine.info) {
    const std::string why = engine.missing.empty() ? engine.failure : "not here: " + engine.missing;
    const std::string package =
        engine.missing.empty() || engine.package.empty() ? "" : " (package " + engine.package + ")";
    fmt::print("{}  {}{}\n\n", engine.name, printable(why), package);
    return;
  }
  fmt::print("{}  version {}, {}\n", engine.info->name, printable(engine.info->version),
             engine.info->precision);
  std::size_t longest = 0;
  for (const Model& model : engine.info->models) {
    longest = std::max(longest, model.name.size());
  }
  for (const Model& model : engine.info->models) {
    fmt::print("  {:<{}}  {}\n", model.name, longest, printable(model.sentence, 1000));
  }
  fmt::print("\n");
}

}  // namespace

int engines_command(const EnginesCommand& command) {
  const auto engines = registered_engines();
  if (command.json.empty()) {
    for (const RegisteredEngine& engine : engines) {
      print_engine(engine);
    }
    return exit_done;
  }
  ordered_json list = ordered_json::array();
  for (const RegisteredEngine& engine : engines) {
    ordered_json row =
        engine.info ? engine_json(*engine.info) : ordered_json{{"name", engine.name}};
    row["plugin"] = engine.plugin.string();
    row["failure"] = printable(engine.failure);
    row["missing"] = engine.missing;
    row["package"] = engine.package;
    list.push_back(std::move(row));
  }
  write_output(command.json,
               ordered_json{{"schema", 1}, {"engines", std::move(list)}}.dump(2) + "\n");
  return exit_done;
}

}  // namespace tautline::bench
