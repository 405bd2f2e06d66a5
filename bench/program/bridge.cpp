// `tautline bridge`: how far the motion on elastic cables is from that on inextensible ones, over
// the stiffness.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/page/page_assets.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/tools/bridge/bridge.hpp"

namespace tautline::bench {
namespace {

/// The words of a command line of `tautline bridge`.
struct BridgeCommand {
  std::string the_case;
  std::optional<double> until;           // [s], instead of the case's duration
  std::optional<std::string> stiffness;  // [N/m], "1e4..1e8"; none: chosen
  std::int64_t impacts = static_cast<std::int64_t>(BridgeOptions().impacts);
  std::string json;
  std::string html;
};

/// More impacts have no order that a soft cable keeps.
constexpr std::int64_t most_compared = 1000;

/// The one case or system that `command` means; none, after complaining, if that is not one.
std::optional<AnyCase> wanted_case(const BridgeCommand& command) {
  CaseSelection selection = select_cases({&command.the_case, 1}, {}, Kinds::cases_and_systems);
  std::vector<AnyCase> meant;
  std::move(selection.cases.begin(), selection.cases.end(), std::back_inserter(meant));
  std::move(selection.systems.begin(), selection.systems.end(), std::back_inserter(meant));
  std::move(selection.in_space.begin(), selection.in_space.end(), std::back_inserter(meant));
  if (meant.size() > 1) {
    selection.problems.push_back(fmt::format("{} means {} cases; this command takes one",
                                             printable(command.the_case), meant.size()));
  }
  if (complain(selection.problems)) {
    return std::nullopt;
  }
  complain(selection.notes);
  if (command.until) {
    std::visit([&](auto& one) { one.duration = *command.until; }, meant.front());
  }
  return complain(problems(meant.front())) ? std::nullopt : std::optional(meant.front());
}

std::vector<std::string> bridge_problems(const BridgeCommand& command) {
  std::vector<std::string> broken = missing_folder("--json", command.json);
  append(broken, missing_folder("--html", command.html));
  if (command.json == "-" && command.html == "-") {
    broken.emplace_back("--json -, --html -: only one of them can go to stdout");
  }
  if (command.impacts < 1 || command.impacts > most_compared) {
    broken.push_back(fmt::format("--impacts {}: must be 1 to {}", command.impacts, most_compared));
  }
  if (command.stiffness) {
    const auto range = positive_range(*command.stiffness);
    constexpr double rounding = 1e-9;  // of a logarithm
    const double decades = range ? std::log10(range->second / range->first) : 0.0;
    if (!range) {
      broken.push_back("--stiffness " + printable(*command.stiffness) +
                       " is no range of stiffnesses above 0 N/m, such as 1e4..1e8");
    } else if (!(decades >= 1.0 - rounding && decades <= most_decades)) {
      broken.push_back(fmt::format("--stiffness {}: the last must be 10 to 1e{:g} times the first",
                                   printable(*command.stiffness), most_decades));
    }
  }
  return broken;
}

int bridge_command(const BridgeCommand& command) {
  if (complain(bridge_problems(command))) {
    return exit_usage;
  }
  const std::optional<AnyCase> any = wanted_case(command);
  if (!any) {
    return exit_usage;
  }
  BridgeOptions options;
  options.impacts = static_cast<std::size_t>(command.impacts);
  if (command.stiffness) {
    std::tie(options.softest, options.stiffest) = positive_range(*command.stiffness).value();
  }
  const BridgeReading reading = bridge_of(*any, options);
  if (!reading.bridge) {
    complain({printable(name_of(*any)) + ": " + reading.problem});
    return exit_usage;
  }
  if (command.json != "-" && command.html != "-") {
    fmt::print("{}", bridge_text(*reading.bridge, output_style()));
  }
  if (!command.json.empty()) {
    write_output(command.json, bridge_json(*reading.bridge));
  }
  if (!command.html.empty()) {
    write_output(command.html, bridge_html(*reading.bridge, page_assets()));
  }
  return exit_done;
}

}  // namespace

void add_bridge(CLI::App& app, int& code) {
  CLI::App* const command = app.add_subcommand(
      "bridge", "How elastic cables become inextensible ones as they get stiffer");
  const auto asked = std::make_shared<BridgeCommand>();
  command->add_option("CASE", asked->the_case, case_help)->required();
  command
      ->add_option("--stiffness", asked->stiffness,
                   "make all cables elastic, with stiffnesses from the first on by factors of ten "
                   "[N/m] (default: four powers of ten that suit the case)")
      ->option_text("FROM..TO");
  command->add_option("--impacts", asked->impacts, "compare this many impacts, from the first on")
      ->option_text("COUNT")
      ->capture_default_str();
  command
      ->add_option("--until", asked->until,
                   "end at this time [s], before or after the case's own duration")
      ->option_text("SECONDS");
  add_target(*command, "--json", asked->json, "write everything as JSON");
  add_schema(*command, bridge_schema_json);
  add_target(*command, "--html", asked->html, "write it as a page, with a picture,");
  command->footer(
      "tautline bridge breakwater/1910121100\n"
      "tautline bridge bouncing-ball --stiffness 1e5..1e9 --html bridge.html");
  command->callback([asked, &code] { code = bridge_command(*asked); });
}

}  // namespace tautline::bench
