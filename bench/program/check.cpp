// `tautline check`: every model of one plug-in, each in a worker process of its own, compared with
// what every sound engine keeps.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/process.hpp"
#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/check/claims.hpp"
#include "bench/check/contract.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/engine_json.hpp"
#include "bench/run/registry.hpp"
#include "bench/run/worker.hpp"

namespace tautline::bench {
namespace {

/// What `tautline check` was asked.
struct CheckCommand {
  std::string engine;
  std::string model;  // or empty: all
  std::string json;
  double time_limit = 60.0;  // [s], for each model
};

std::string number_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.2g}", value) : "none";
}

std::string verdict_text(const SettledClaim& settled) {
  if (!settled.known.empty()) {
    return settled.holds ? "holds now" : "known";
  }
  return settled.holds ? "holds" : "does not hold";
}

std::string finding_text(const SettledClaim& settled) {
  std::string text = printable(settled.sentence, 1000);
  if (!settled.known.empty()) {
    text += (settled.holds ? "; delete it from contract.toml, which says: " : "; known: ") +
            printable(settled.known, 1000);
  }
  return text;
}

/// The claims of which `is_one` is true, by name.
template <class Predicate>
std::vector<std::string> claims_that(const CheckedModel& checked, Predicate is_one) {
  std::vector<std::string> names;
  for (const SettledClaim& settled : checked.claims) {
    if (is_one(settled)) {
      names.push_back(settled.claim);
    }
  }
  return names;
}

bool applies(const SettledClaim& settled) { return settled.applies; }
bool is_known(const SettledClaim& settled) {
  return settled.applies && !settled.known.empty() && !settled.holds;
}
bool holds_now(const SettledClaim& settled) {
  return settled.applies && !settled.known.empty() && settled.holds;
}
bool is_broken(const SettledClaim& settled) {
  return settled.applies && settled.known.empty() && !settled.holds;
}
bool is_listed_in_vain(const SettledClaim& settled) {
  return !settled.applies && !settled.known.empty();
}

/// Which claims do not apply to a model, and why: a sentence for each reason.
std::string not_applying(const CheckedModel& checked) {
  std::vector<std::string> reasons;
  for (const SettledClaim& settled : checked.claims) {
    if (!settled.applies &&
        std::find(reasons.begin(), reasons.end(), settled.sentence) == reasons.end()) {
      reasons.push_back(settled.sentence);
    }
  }
  std::string text;
  for (const std::string& reason : reasons) {
    const auto names = claims_that(checked, [&](const SettledClaim& settled) {
      return !settled.applies && settled.sentence == reason;
    });
    text += fmt::format(" Claims that do not apply: {}, as {}.", joined(names, "and"),
                        printable(reason, 1000));
  }
  return text;
}

/// The end of what is said of one model.
std::string verdict(const CheckedModel& checked) {
  const auto broken = claims_that(checked, is_broken);
  const auto known = claims_that(checked, is_known);
  const std::size_t count = claims_that(checked, applies).size();
  std::string text = broken.empty()
                         ? fmt::format("All {}{} claims hold.", known.empty() ? "" : "other ",
                                       count - known.size())
                         : fmt::format("{} of {} claims {} not hold: {}.", broken.size(), count,
                                       broken.size() == 1 ? "does" : "do", joined(broken, "and"));
  if (!known.empty()) {
    text += fmt::format(" Violations listed in contract.toml: {}.", joined(known, "and"));
  }
  if (const auto now = claims_that(checked, holds_now); !now.empty()) {
    text += fmt::format(" Listed in contract.toml as violated, but hold{}: {}.",
                        now.size() == 1 ? "s" : "", joined(now, "and"));
  }
  if (const auto vain = claims_that(checked, is_listed_in_vain); !vain.empty()) {
    text += fmt::format(" Listed in contract.toml as violated, but {} not apply: {}.",
                        vain.size() == 1 ? "does" : "do", joined(vain, "and"));
  }
  const std::size_t all = claims().size() + 1;  // and `quiet`
  if (checked.claims.size() < all) {
    text += fmt::format(" The other {} were not measured.", all - checked.claims.size());
  }
  return text + not_applying(checked);
}

void print_check(const EngineInfo& info, const CheckedModel& checked) {
  fmt::print("{} {}, {}, model {}\n\n", info.name, printable(info.version), info.precision,
             checked.name);
  Table table({"claim", "found", "limit", "verdict", "what was found"}, 1, 2);
  for (const SettledClaim& settled : checked.claims) {
    if (!settled.applies) {
      continue;
    }
    table.add({settled.claim, number_text(settled.found), number_text(settled.limit),
               verdict_text(settled), finding_text(settled)});
  }
  const TerminalStyle style = output_style();
  fmt::print("{}\n{}\n", table.plain(style), wrapped(verdict(checked), style.text));
}

/// The models of `info` that are checked: the claims are about inextensible cables.
std::vector<std::string> checked_models(const EngineInfo& info, bool checked = true) {
  std::vector<std::string> result;
  for (const Model& model : info.models) {
    if ((model.cables != Cables::elastic) == checked) {
      result.push_back(model.name);
    }
  }
  return result;
}

/// Which models are left out, and why; "" where none is.
std::string left_out(const EngineInfo& info) {
  const std::vector<std::string> names = checked_models(info, false);
  return names.empty() ? ""
                       : fmt::format(
                             " The claims are about inextensible cables, and {} {} elastic "
                             "ones alone: not checked.",
                             joined(names, "and"), names.size() == 1 ? "runs" : "run");
}

/// The last sentence: of all models together.
std::string closing(const EngineInfo& info, const std::vector<CheckedModel>& models) {
  std::vector<std::string> unsound;
  bool some_known = false;
  for (const CheckedModel& checked : models) {
    some_known = some_known || !claims_that(checked, is_known).empty();
    if (!broken_claims(checked.claims).empty()) {
      unsound.push_back(checked.name);
    }
  }
  if (unsound.empty()) {
    return fmt::format("{}: every claim holds for {}{}.", info.name,
                       models.size() == 1 ? "this model" : "all of its models",
                       some_known ? ", except the listed violations" : "");
  }
  return fmt::format("{}: {} of {} models {} every claim; {} {} not.", info.name,
                     models.size() - unsound.size(), models.size(),
                     models.size() - unsound.size() == 1 ? "keeps" : "keep", joined(unsound, "and"),
                     unsound.size() == 1 ? "does" : "do");
}

/// Everything that is wrong with what was asked.
std::vector<std::string> usage_problems(const CheckCommand& command, const EngineChoice& choice) {
  std::vector<std::string> broken = choice.problems;
  append(broken, missing_folder("--json", command.json));
  if (!(command.time_limit > 0.0)) {
    broken.push_back(fmt::format("--time-limit {}: must be above 0 [s]", command.time_limit));
  }
  if (choice.problems.empty() && choice.engines.front().info) {
    const EngineInfo& info = *choice.engines.front().info;
    const std::vector<std::string> checked = checked_models(info);
    if (!command.model.empty()) {
      append(broken, unknown_models(choice.engines, {command.model}));
    }
    if (broken.empty() &&
        (command.model.empty() ? checked.empty()
                               : std::ranges::count(checked, command.model) == 0)) {
      broken.push_back(
          fmt::format("engine {} has nothing to check here.{}", info.name, left_out(info)));
    }
  }
  return broken;
}

/// What is known of an engine that has answered, from the file next to it.
Contract contract_of(const RegisteredEngine& engine) {
  const std::vector<std::string> models = listed(engine.info->models, &Model::name);
  return contract_beside(engine.plugin, engine.info->name, models);
}

int check_command(const CheckCommand& command) {
  const EngineChoice choice = choose_engines({command.engine});
  if (complain(usage_problems(command, choice))) {
    return exit_usage;
  }
  const RegisteredEngine& engine = choice.engines.front();
  if (!engine.info) {
    complain({fmt::format("engine {}: {}", engine.name, printable(engine.failure, 1000))});
    // the loader's own sentences name the file first: it is no plug-in of this version
    return is_no_plugin(engine) ? exit_usage : exit_failed;
  }
  const Contract contract = contract_of(engine);
  if (complain(contract.problems)) {
    return exit_usage;
  }
  catch_interruption();
  std::vector<CheckedModel> models;
  const std::vector<std::string> asked =
      command.model.empty() ? checked_models(*engine.info) : std::vector{command.model};
  for (const std::string& model : asked) {
    WorkerLimits limits;
    limits.time = command.time_limit;
    CheckReply reply = check_in_worker(engine.plugin, model, limits);
    if (reply.interrupted) {
      complain({"interrupted"});
      return exit_failed;
    }
    mark_known(contract, model, reply.claims);
    models.push_back({model, std::move(reply.claims)});
    if (command.json.empty()) {
      print_check(*engine.info, models.back());
    }
  }
  if (command.json.empty()) {
    const std::string others = command.model.empty() ? left_out(*engine.info) : "";
    fmt::print("{}", wrapped(closing(*engine.info, models) + others, output_style().text));
  } else {
    write_output(command.json, check_json(engine, models));
  }
  const bool sound = std::all_of(models.begin(), models.end(), [](const CheckedModel& checked) {
    return broken_claims(checked.claims).empty();
  });
  return sound ? exit_done : exit_failed;
}

}  // namespace

void add_check(CLI::App& app, int& code) {
  CLI::App* const command = app.add_subcommand(
      "check", "Test an engine against the claims that every sound engine keeps");
  const auto asked = std::make_shared<CheckCommand>();
  command
      ->add_option("PLUGIN", asked->engine,
                   "the path of a plug-in or an engine.toml, or an engine's name")
      ->required();
  command->add_option("--model", asked->model, "only this model (default: all)")
      ->option_text("MODEL");
  command
      ->add_option("--time-limit", asked->time_limit,
                   "end the check of a model after this long [s]")
      ->option_text("SECONDS")
      ->capture_default_str();
  add_target(*command, "--json", asked->json, "write the verdicts as JSON");
  add_schema(*command, check_schema_json);
  command->callback([asked, &code] { code = check_command(*asked); });
}

}  // namespace tautline::bench
