#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "bench/base/process.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/gate/listed_problems.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/output.hpp"
#include "bench/store/tree.hpp"
#include "bench/suite/report_of.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {
namespace {

/// What `tautline run` was asked.
struct RunCommand {
  std::string the_case;
  std::string engine;
  std::string model;
  double step = 1e-3;  // [s]
  ImpactLaw law = ImpactLaw::simultaneous;
  double time_limit = 60.0;
  std::string json;
  bool all = false;           // metrics, not only those that matter
  std::filesystem::path out;  // folder for the run's files, or empty
};

int run_command(const RunCommand& command) {
  std::vector<std::string> broken;
  CaseSelection selection = select_cases({&command.the_case, 1}, {}, Kinds::cases_and_systems);
  append(broken, selection.problems);
  complain(selection.notes);
  SuiteOptions options;
  options.cases = bench_cases(std::move(selection), command.law, broken);
  if (options.cases.size() > 1) {
    broken.push_back(fmt::format("{} means {} cases; this command takes one",
                                 printable(command.the_case), options.cases.size()));
  }
  EngineChoice choice = choose_engines({command.engine});
  append(broken, choice.problems);
  if (choice.problems.empty() && choice.engines.front().info) {
    append(broken, unknown_models(choice.engines, {command.model}));
  }
  options.engines = std::move(choice.engines);
  options.models = {command.model};
  options.steps = {command.step};
  options.law = command.law;
  options.out = command.out;
  options.limits.time = command.time_limit;
  append(broken, suite_problems(options));
  append(broken, missing_folder("--json", command.json, command.out));
  if (complain(broken)) {
    return exit_usage;
  }
  if (const RegisteredEngine& engine = options.engines.front(); !engine.info) {
    complain({fmt::format("engine {}: {}", engine.name, printable(engine.failure))});
    return exit_failed;
  }
  // the runs of other engines and models stay
  const Descriptor tree = options.out.empty() ? Descriptor() : open_tree(options.out, false);
  const std::vector<Reference> references = solve_all(options.cases, options.law);
  const Expectations expectations = expectations_of(references);
  catch_interruption();
  const SuiteResult result = run_suite(options, expectations, [](const PlannedRun&, bool) {});
  if (result.runs.empty()) {
    complain({"interrupted"});
    return exit_failed;
  }
  Report report = report_of(options, expectations, {std::nullopt}, result, Context());
  add_verdicts(report, shipped_problems());
  const RunRow& row = report.runs.front();
  if (command.json.empty()) {
    fmt::print("{}", run_card(report, command.all, output_style()));
  } else {
    write_output(command.json, run_json(row, result.runs.front().replay));
  }
  return did_its_work(row.status) ? exit_done : exit_failed;
}

}  // namespace

void add_run(CLI::App& app, int& code) {
  CLI::App* const command =
      app.add_subcommand("run", "One run on one engine, compared with the exact motion");
  const auto asked = std::make_shared<RunCommand>();
  command->add_option("CASE", asked->the_case, case_help)->required();
  command
      ->add_option("--engine", asked->engine,
                   "an engine's name, or the path of a plug-in or an engine.toml")
      ->option_text("ENGINE")
      ->required();
  command
      ->add_option("--model", asked->model,
                   "one of its models of a cable; `tautline engines` lists them")
      ->option_text("MODEL")
      ->required();
  command->add_option("--step", asked->step, "the engine's step [s]")
      ->option_text("SECONDS")
      ->capture_default_str();
  add_law(*command, asked->law, law_help);
  command->add_option("--time-limit", asked->time_limit, "end the run after this long [s]")
      ->option_text("SECONDS")
      ->capture_default_str();
  command
      ->add_option("--out", asked->out,
                   "write trajectory.csv, events.csv and settings below this folder")
      ->option_text("FOLDER");
  add_target(*command, "--json", asked->json, "write the result as JSON");
  command->add_flag("--all", asked->all, "print all metrics, not only those that matter");
  command->footer(
      "tautline run bouncing-ball --engine bullet64 --model row --step 1e-2\n"
      "tautline run my_case.toml --engine ./libmine.so --model cable");
  command->callback([asked, &code] { code = run_command(*asked); });
}

}  // namespace tautline::bench
