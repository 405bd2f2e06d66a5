#include "bench/program/request.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/ensemble/output/comparison.hpp"
#include "bench/program/common.hpp"
#include "bench/report/json/json.hpp"
#include "bench/run/registry.hpp"
#include "bench/store/shard.hpp"
#include "bench/suite/draws.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// The suite that is meant; null where cases are named, or with a sentence on what is wrong.
const Suite* suite_of(const BenchCommand& command, std::vector<std::string>& problems) {
  if (!command.suite) {
    return command.cases.empty() ? &suites().front() : nullptr;
  }
  if (!command.cases.empty()) {
    problems.emplace_back("--suite: cases are named too; give the one or the other");
    return nullptr;
  }
  const Suite* suite = find_suite(*command.suite);
  if (suite == nullptr) {
    problems.push_back(
        fmt::format("--suite {}: must be {}", printable(*command.suite), suite_names("or")));
  }
  return suite;
}

/// The cases that are meant, none of them longer than --until says.
std::vector<BenchCase> cases_of(const BenchCommand& command, const Suite* suite,
                                std::vector<std::string>& problems) {
  CaseSelection selection = select_cases(
      suite != nullptr ? cases_of(*suite) : command.cases, {},
      suite == nullptr || suite->systems ? Kinds::cases_and_systems : Kinds::cases_alone);
  append(problems, selection.problems);
  complain(selection.notes);
  std::vector<BenchCase> cases = bench_cases(std::move(selection), command.law, problems);
  if (command.until && !(*command.until > 0.0 && std::isfinite(*command.until))) {
    problems.push_back(
        fmt::format("--until {}: must be a finite number above 0 [s]", *command.until));
    return cases;
  }
  bool shortens = cases.empty() || !command.until;
  for (BenchCase& any : cases) {
    std::visit(
        [&](auto& one) {
          shortens = shortens || *command.until < one.duration;
          one.duration = std::min(one.duration, command.until.value_or(one.duration));
        },
        any);
  }
  if (!shortens) {
    complain(
        {fmt::format("--until {}: changes nothing, as every case ends by then; a case becomes "
                     "longer by its file's `duration`",
                     *command.until)});
  }
  return cases;
}

/// The part of the runs that is meant.
Shard shard_of(const BenchCommand& command, std::vector<std::string>& problems) {
  if (!command.shard) {
    return {};
  }
  const std::optional<Shard> shard = shard_from(*command.shard);
  if (!shard) {
    problems.push_back(fmt::format(
        "--shard {}: must be two whole numbers K/N with K from 1 to N, and N at most {}",
        printable(*command.shard), most_shards));
  } else if (shard->of > 1 && command.gate) {
    problems.emplace_back(
        "--gate: a shard does not have all runs; give it to the `tautline merge` of all shards");
  }
  return shard.value_or(Shard());
}

/// The draws that are meant, of a case that must be among `cases`.
std::size_t draws_of(const BenchCommand& command, const Request& request,
                     std::vector<std::string>& problems) {
  if (!command.draws) {  // those of a shard would be a part of nothing
    const bool whole = request.options.shard.of == 1;
    return whole && request.suite != nullptr ? request.suite->draws : 0;
  }
  const long long draws = *command.draws;
  const std::vector<BenchCase>& cases = request.options.cases;
  constexpr auto most = static_cast<long long>(most_draws_of_suite);
  if (draws != 0 && (draws < static_cast<long long>(least_sample) || draws > most)) {
    problems.push_back(
        fmt::format("--draws {}: must be 0, or from {} to {}; `tautline ensemble` "
                    "solves more",
                    draws, least_sample, most));
  } else if (draws != 0 && request.options.shard.of > 1) {
    problems.push_back(fmt::format(
        "--draws {}: a shard has none; give them to a `tautline ensemble` of their own", draws));
  } else if (draws != 0 && !cases.empty() &&
             std::none_of(cases.begin(), cases.end(),
                          [](const BenchCase& one) { return name_of(one) == drawn_case; })) {
    problems.push_back(
        fmt::format("--draws {}: are of {}, which is not among the cases; name it too, or give "
                    "your own case to `tautline ensemble`",
                    draws, drawn_case));
  }
  return static_cast<std::size_t>(std::clamp(draws, 0LL, most));
}

/// The part of the shortest cable that "1%" or "0.01" means; none if it is no such part.
std::optional<double> part_from(std::string_view text) {
  const bool percent = text.ends_with('%');
  text.remove_suffix(percent ? 1 : 0);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const double part = percent ? number / 100.0 : number;
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && part > 0.0 && part < 1.0 ? std::optional(part) : std::nullopt;
}

/// The part of the shortest cable that --within asks for.
std::optional<double> within_of(const BenchCommand& command, std::vector<std::string>& problems) {
  if (!command.within) {
    return std::nullopt;
  }
  const std::optional<double> part = part_from(*command.within);
  if (!part) {
    problems.push_back(fmt::format(
        "--within {}: must be a part of the shortest cable above 0 and below 1, such as 0.01, or "
        "in percent, such as 1%",
        command.within->empty() ? "\"\"" : printable(*command.within)));
  }
  for (const auto& [option, given] :
       {std::pair("--gate", command.gate.has_value()), std::pair("--json", !command.json.empty()),
        std::pair("--list-problems", !command.list_problems.empty()),
        std::pair("--playground", !command.playground.empty()),
        std::pair("--shard", command.shard.has_value()), std::pair("--resume", command.resume),
        std::pair("--steps", !command.steps.empty()),
        std::pair("--until", command.until.has_value()),
        std::pair("--draws", command.draws.has_value())}) {
    if (given) {
      problems.push_back(
          fmt::format("{}: --within searches steps and prints them, without a report; give the one "
                      "or the other",
                      option));
    }
  }
  return part;
}

ProblemNames::Engine names_of(const RegisteredEngine& engine) {
  ProblemNames::Engine names{engine.name, std::nullopt};
  if (engine.info) {
    names.models = listed(engine.info->models, &Model::name);
  }
  return names;
}

/// The names that a problems file may have: of all engines that the program knows or was given,
/// their models, the shipped cases and `cases`.
ProblemNames problem_names(const std::vector<RegisteredEngine>& given,
                           const std::vector<BenchCase>& cases) {
  std::vector<RegisteredEngine> engines = given;
  for (RegisteredEngine& engine : registered_engines(Asked::plugins)) {
    const bool is_given = std::any_of(given.begin(), given.end(), [&](const auto& one) {
      return one.name == engine.name;  // one of the user's own may replace it
    });
    if (!is_given) {
      engines.push_back(std::move(engine));
    }
  }
  ProblemNames names;
  names.engines = listed(engines, names_of);
  names.cases = listed(shipped_cases(), &Case::name);
  for (const BenchCase& any : cases) {
    names.cases.push_back(name_of(any));
  }
  return names;
}

}  // namespace

ListedProblems listed_by(const std::optional<std::string>& gate, const SuiteOptions& options,
                         std::vector<std::string>& problems) {
  if (!gate || *gate == "shipped") {
    return shipped_problems();
  }
  if (*gate == "none") {
    return {"none listed", "0", {}};
  }
  ProblemsReading reading =
      read_problems_file(*gate, problem_names(options.engines, options.cases));
  append(problems, reading.problems);
  return std::move(reading.listed).value_or(ListedProblems());
}

Request read_runs(const BenchCommand& command) {
  Request request;
  SuiteOptions& options = request.options;
  request.suite = suite_of(command, request.problems);
  if (request.problems.empty()) {
    options.cases = cases_of(command, request.suite, request.problems);
  }
  options.models = command.models;
  options.steps = request.suite != nullptr ? request.suite->steps : usual_steps();
  if (!command.steps.empty()) {
    options.steps = command.steps;
  }
  options.law = command.law;
  options.out = command.out;
  options.shard = shard_of(command, request.problems);
  options.resume = command.resume;
  options.draws = draws_of(command, request, request.problems);
  options.certify = command.certify.value_or(request.suite != nullptr);
  options.limits.time = command.time_limit;
  options.jobs = command.jobs.value_or(std::max(1U, std::thread::hardware_concurrency()));
  append(request.problems, missing_folder("--json", command.json, command.out));
  append(request.problems, missing_folder("--list-problems", command.list_problems, command.out));
  if (command.out.empty()) {
    request.problems.emplace_back("--out: is empty; give a folder to write the results to");
  }
  return request;
}

Request read_request(const BenchCommand& command) {
  Request request = read_runs(command);
  SuiteOptions& options = request.options;
  EngineChoice choice = choose_engines(command.engines);
  append(request.problems, choice.problems);
  append(request.problems, unknown_models(choice.engines, command.models));
  options.engines = std::move(choice.engines);
  append(request.problems, suite_problems(options));
  request.listed = listed_by(command.gate, options, request.problems);
  if (std::filesystem::exists(command.list_problems)) {  // what a person has said in it stays
    ProblemsReading before = read_problems_file(command.list_problems);
    append(request.problems, before.problems);
    request.listed_before = std::move(before.listed).value_or(ListedProblems());
  }
  if (request.problems.empty() && !options.cases.empty() && options.models.empty() &&
      plan(options).empty() &&
      std::any_of(options.engines.begin(), options.engines.end(),
                  [](const RegisteredEngine& engine) { return engine.info.has_value(); })) {
    const bool in_space = std::ranges::any_of(options.engines, [](const RegisteredEngine& engine) {
      return engine.info && std::ranges::any_of(engine.info->models, [](const Model& model) {
               return model.in_space.has_value();
             });
    });
    request.problems.push_back(
        fmt::format("no model of these engines runs {}; `tautline engines` names those that do",
                    in_space ? "elastic cables" : "systems"));
  }
  request.within = within_of(command, request.problems);
  return request;
}

void add_bench_options(CLI::App& command, BenchCommand& asked) {
  command.add_option("CASES", asked.cases, std::string(case_help) + ". Without: --suite quick");
  command
      .add_option("--suite", asked.suite,
                  "a selection of shipped cases: " + suite_names("or") + "; see below")
      ->option_text("SUITE");
  command
      .add_option("--engines,--engine", asked.engines,
                  "names, or paths of a plug-in or an engine.toml: bullet64,./libmine.so (default: "
                  "all plug-ins). An engine with an engine.toml runs only if it is named; the name "
                  "of a folder, such as npm, means all engines in it")
      ->option_text("ENGINES")
      ->delimiter(',')
      ->allow_extra_args(false);  // a case may follow
  command.add_option("--models", asked.models, "only these models: row,event (default: all)")
      ->option_text("MODELS")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--steps", asked.steps,
                  "step sizes [s] (default: the suite's; for CASES 0.01,0.001,0.0001)")
      ->option_text("SECONDS")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--until", asked.until,
                  "end longer cases at this time [s]; shorter ones stay as they are")
      ->option_text("SECONDS");
  add_law(command, asked.law, law_help);
  command.add_option("--out", asked.out, "folder for the report and the runs' files")
      ->option_text("FOLDER")
      ->capture_default_str();
  command.add_option("--jobs", asked.jobs, "runs at a time (default: one per core)");
  command
      .add_option("--shard", asked.shard,
                  "do only part K of N of the runs: 3/16; `tautline merge` puts the N result "
                  "folders together")
      ->option_text("K/N");
  command.add_flag("--resume", asked.resume, "keep the runs that --out already has");
  command.add_flag_callback(
      "--certify", [&asked] { asked.certify = true; },
      "say until when the exact solution of each case is right, by comparison with many digits; "
      "takes up to seconds a case (default for a --suite)");
  command.add_flag_callback(
      "--no-certify", [&asked] { asked.certify = false; }, "do not certify the cases");
  command.add_option("--draws", asked.draws,
                     "after the runs, solve this many draws of breakwater/1910121100 on every "
                     "model, and compare the distributions of settling times and other statistics "
                     "(default: the suite's; for CASES 0)");
  command.add_option("--time-limit", asked.time_limit, "end a run after this long [s]")
      ->option_text("SECONDS")
      ->capture_default_str();
  add_target(command, "--json", asked.json, "also write the report as JSON");
  add_schema(command, report_schema_json);
  command
      .add_option("--playground", asked.playground,
                  "link each case of the report's replay to the live page at this address, such as "
                  "../playground/index.html; scripts/playground makes one")
      ->option_text("ADDRESS");
  command.add_option("--gate", asked.gate, gate_help)->option_text("FILE");
  add_target(command, "--list-problems", asked.list_problems,
             "write the list of problems that --gate reads");
  command
      .add_option(
          "--within", asked.within,
          "instead of a report: the largest step of each model that stays within this part of "
          "the shortest cable, such as 1%, over the first 3 s of each case, confirmed by a "
          "run with it")
      ->option_text("PART");
  command.add_flag("--all", asked.all, "print every number over the cases, too");
  command.footer("Suites, and what their cases show:\n" + suites_text());
}

}  // namespace tautline::bench
