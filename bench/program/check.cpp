// `tautline check`: every model of one plug-in, each in a worker process of its own, held against
// what every sound engine keeps.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/program/commands.hpp"
#include "bench/run/registry.hpp"
#include "bench/run/worker.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

constexpr int check_schema = 1;

/// A model and what was found of it.
struct ModelCheck {
  std::string model;
  std::vector<Finding> findings;
};

std::vector<std::string> broken_claims(const ModelCheck& check) {
  std::vector<std::string> names;
  for (const Finding& finding : check.findings) {
    if (!finding.holds) {
      names.push_back(finding.claim);
    }
  }
  return names;
}

std::string number_text(double value) {
  return std::isnan(value) ? "none" : fmt::format("{:.2g}", value);
}

/// The end of what is said of one model.
std::string verdict(const ModelCheck& check) {
  const auto broken = broken_claims(check);
  std::string text =
      broken.empty()
          ? fmt::format("All {} claims hold.", check.findings.size())
          : fmt::format("{} of {} claims {} not hold: {}.", broken.size(), check.findings.size(),
                        broken.size() == 1 ? "does" : "do", joined(broken, "and"));
  const std::size_t all = claims().size() + 1;  // and `quiet`
  if (check.findings.size() < all) {
    text += fmt::format(" The other {} were not measured.", all - check.findings.size());
  }
  return text;
}

void print_check(const EngineInfo& info, const ModelCheck& check) {
  fmt::print("{} {}, {}, model {}\n\n", info.name, printable(info.version), info.precision,
             check.model);
  Table table({"claim", "found", "limit", "verdict", "what was found"}, 1, 2);
  for (const Finding& finding : check.findings) {
    table.add({finding.claim, number_text(finding.found), number_text(finding.limit),
               finding.holds ? "holds" : "does not hold", printable(finding.sentence, 1000)});
  }
  fmt::print("{}\n{}\n\n", table.plain(), verdict(check));
}

/// The last sentence: of all models together.
std::string closing(const EngineInfo& info, const std::vector<ModelCheck>& checks) {
  std::vector<std::string> unsound;
  for (const ModelCheck& check : checks) {
    if (!broken_claims(check).empty()) {
      unsound.push_back(check.model);
    }
  }
  if (unsound.empty()) {
    return fmt::format("{}: every claim holds for {}.", info.name,
                       checks.size() == 1 ? "this model" : "all of its models");
  }
  return fmt::format("{}: {} of {} models {} every claim; {} {} not.", info.name,
                     checks.size() - unsound.size(), checks.size(),
                     checks.size() - unsound.size() == 1 ? "keeps" : "keep", joined(unsound, "and"),
                     unsound.size() == 1 ? "does" : "do");
}

ordered_json check_json(const RegisteredEngine& engine, const std::vector<ModelCheck>& checks) {
  ordered_json rows = ordered_json::array();
  bool all = true;
  for (const ModelCheck& check : checks) {
    ordered_json findings = findings_json(check.findings);
    for (ordered_json& finding : findings) {
      const Claim* const claim = find_claim(finding.at("claim").get<std::string>());
      finding["claimed"] = claim != nullptr ? claim->sentence : quiet_sentence;
      finding["reason"] = claim != nullptr ? claim->reason : quiet_reason;
      finding["sentence"] = printable(finding.at("sentence").get<std::string>(), 1000);
    }
    const bool holds = broken_claims(check).empty();
    all = all && holds;
    rows.push_back({{"model", check.model}, {"holds", holds}, {"findings", std::move(findings)}});
  }
  return {{"schema", check_schema},
          {"engine",
           {{"name", engine.info->name},
            {"version", engine.info->version},
            {"precision", engine.info->precision},
            {"plugin", engine.plugin.string()}}},
          {"holds", all},
          {"models", std::move(rows)}};
}

/// Everything that is wrong with what was asked.
std::vector<std::string> usage_problems(const CheckCommand& command, const EngineChoice& choice) {
  std::vector<std::string> broken = choice.problems;
  if (!(command.time_limit > 0.0)) {
    broken.push_back(fmt::format("--time-limit {}: must be above 0 [s]", command.time_limit));
  }
  if (choice.problems.empty() && !command.model.empty() && choice.engines.front().info) {
    for (std::string& sentence : unknown_models(choice.engines, {command.model})) {
      broken.push_back(std::move(sentence));
    }
  }
  return broken;
}

}  // namespace

int check_command(const CheckCommand& command) {
  const EngineChoice choice = choose_engines({command.engine});
  if (const auto broken = usage_problems(command, choice); !broken.empty()) {
    complain(broken);
    return exit_usage;
  }
  const RegisteredEngine& engine = choice.engines.front();
  if (!engine.info) {
    complain({fmt::format("engine {}: {}", engine.name, printable(engine.failure, 1000))});
    // the loader's own sentences name the file first: it is no plug-in of this version
    return is_no_plugin(engine) ? exit_usage : exit_failed;
  }
  catch_interruption();
  std::vector<ModelCheck> checks;
  for (const Model& model : engine.info->models) {
    if (!command.model.empty() && model.name != command.model) {
      continue;
    }
    WorkerLimits limits;
    limits.time = command.time_limit;
    CheckReply reply = check_in_worker(engine.plugin, model.name, limits);
    if (reply.interrupted) {
      complain({"interrupted"});
      return exit_failed;
    }
    checks.push_back({model.name, std::move(reply.findings)});
    if (command.json.empty()) {
      print_check(*engine.info, checks.back());
    }
  }
  if (command.json.empty()) {
    fmt::print("{}\n", closing(*engine.info, checks));
  } else {
    write_output(command.json, check_json(engine, checks).dump(2) + "\n");
  }
  const bool sound = std::all_of(checks.begin(), checks.end(), [](const ModelCheck& check) {
    return broken_claims(check).empty();
  });
  return sound ? exit_done : exit_failed;
}

}  // namespace tautline::bench
