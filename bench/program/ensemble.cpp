// `tautline ensemble`: many draws of a case, exact and by engines, compared as distributions.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <thread>

#include "bench/base/atomic_file.hpp"
#include "bench/base/process.hpp"
#include "bench/base/progress.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/ensemble/output/output.hpp"
#include "bench/ensemble/output/results_so_far.hpp"
#include "bench/ensemble/spec_file.hpp"
#include "bench/ensemble/visibly.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/store/tree.hpp"
#include "bench/suite/draws.hpp"
#include "tautline/case_file.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

/// What `tautline ensemble` was asked.
struct EnsembleCommand {
  std::string spec;
  std::optional<std::string> the_case;  // none: that of the spec
  std::optional<long long> count;       // none: that of the spec
  fs::path out = "ensemble";
  std::optional<unsigned> jobs;  // none: one per core
  bool resume = false;
  double time_limit = 60.0;  // [s]
  std::string json;
  std::optional<long long> draw;  // to be written as a case, instead
};

/// An ensemble that can be solved, or what is wrong with it.
struct EnsembleReading {
  EnsembleRequest request;
  EnsembleOptions options;
  std::vector<std::string> problems;
};

std::vector<std::string> command_problems(const EnsembleCommand& command) {
  std::vector<std::string> broken = missing_folder("--json", command.json, command.out);
  if (command.out.empty()) {
    broken.emplace_back("--out: is empty; give a folder to write the results to");
  } else if (const auto problem = tree_problem(command.out)) {
    broken.push_back(*problem);
  }
  if (command.jobs && (*command.jobs < 1 || *command.jobs > most_jobs)) {
    broken.push_back(fmt::format("--jobs {}: must be from 1 to {}", *command.jobs, most_jobs));
  }
  if (!(command.time_limit > 0.0)) {
    broken.push_back(fmt::format("--time-limit {:g}: must be above 0 [s]", command.time_limit));
  }
  return broken;
}

/// The spec that `command` names, with the case and the count that it gives instead.
SpecReading read_spec(const EnsembleCommand& command) {
  SpecReading reading = read_spec_file(command.spec, command.the_case);
  complain(reading.notes);
  if (const auto& count = command.count) {
    if (*count < 1 || *count > static_cast<long long>(most_draws)) {
      reading.problems.push_back(
          fmt::format("--count {}: must be from 1 to {}", *count, most_draws));
    } else if (reading.spec) {
      reading.spec->count = static_cast<std::size_t>(*count);
    }
  }
  return reading;
}

/// The engines that the spec, a `file`, names, all of which must be there.
void read_engines_of(EnsembleReading& reading, const std::string& file) {
  const EnsembleSpec& spec = reading.request.spec;
  if (spec.engines.empty()) {
    return;
  }
  EngineChoice choice = choose_engines(spec.engines);
  std::vector<std::string> wrong = choice.problems;
  for (const RegisteredEngine& engine : choice.engines) {
    if (!engine.info && choice.problems.empty()) {
      wrong.push_back(
          fmt::format("engine {}: {}", engine.name,
                      printable(engine.failure.empty() ? engine.missing : engine.failure)));
    }
  }
  if (wrong.empty()) {
    wrong = unknown_models(choice.engines, spec.models);
  }
  for (const std::string& problem : wrong) {
    reading.problems.push_back(fmt::format("{}, [engines]: {}", file, problem));
  }
  reading.request.engines = std::move(choice.engines);
}

EnsembleReading read_ensemble(const EnsembleCommand& command) {
  EnsembleReading reading;
  reading.problems = command_problems(command);
  SpecReading spec = read_spec(command);
  append(reading.problems, spec.problems);
  if (!reading.problems.empty()) {
    return reading;
  }
  EnsembleRequest& request = reading.request;
  request.spec = std::move(*spec.spec);
  request.limits.time = command.time_limit;
  if (draw_count(request.spec) > most_draws) {
    reading.problems.push_back(fmt::format("--count: {} draws in all, must be at most {}",
                                           draw_count(request.spec), most_draws));
  }
  read_engines_of(reading, command.spec);
  if (reading.problems.empty()) {
    request.setups = setups_of(request.spec, request.engines);
    reading.options = {command.out,
                       command.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())),
                       command.resume, programs_of(request)};
  }
  return reading;
}

/// Writes the page, Markdown and JSON, and prints what differs.
void give(const EnsembleCommand& command, const EnsembleReport& report) {
  write_ensemble(command.out, report);
  if (command.json != "-") {
    fmt::print("{}\nensemble: {}, with ensemble.md, ensemble.json and draws/ next to it\n",
               ensemble_text(report, output_style()), (command.out / "index.html").string());
  }
  if (!command.json.empty()) {
    write_output(command.json, ensemble_json(report));
  }
}

/// Alone, with the results so far in the folder.
EnsembleResult solve_alone(const EnsembleCommand& command, const EnsembleReading& reading) {
  const auto write = [&](const EnsembleResult& so_far) {
    const Findings findings = findings_of(reading.request, so_far, reading.options.jobs);
    write_ensemble(command.out, {reading.request, so_far, findings});
  };
  ResultsSoFar results(write, error_screen().clock);
  EnsembleOptions options = reading.options;
  options.so_far = [&](const EnsembleResult& so_far) { results.offer(so_far); };
  return solve_visibly(reading.request, options);
}

/// With others, all of whom leave their draws in the folder, where the leader then reads them.
EnsembleResult solve_with(const EnsembleReading& reading, Team& team) {
  EnsembleOptions options = reading.options;
  options.team = &team;
  EnsembleResult result = team.leads() ? solve_visibly(reading.request, options)
                                       : solve_ensemble(reading.request, options, [](auto&&...) {});
  result.interrupted = !team.all(!result.interrupted);
  if (result.interrupted || !team.leads()) {
    return result;
  }
  options.team = nullptr;
  options.resume = true;
  return solve_visibly(reading.request, options);
}

/// True where no process of `team` has `problems`. The leader says them, or who has some alone.
bool none_has(const std::vector<std::string>& problems, Team& team) {
  const bool leader_has_none = team.all(problems.empty() || !team.leads());
  if (!problems.empty() && (team.leads() || leader_has_none)) {
    complain(problems);
  }
  return team.all(problems.empty());
}

/// What the leader has to say at the end.
int conclude(const EnsembleCommand& command, const EnsembleReading& reading,
             const EnsembleResult& result, const Team& team) {
  const bool has_all = team.size() == 1 || !result.interrupted;  // of what is done
  const Findings findings =
      has_all ? findings_of(reading.request, result, reading.options.jobs) : Findings{};
  if (has_all) {
    give(command, {reading.request, result, findings});
  }
  if (result.interrupted) {
    complain({"interrupted: the same command with --resume does the rest"});
    return exit_failed;
  }
  if (findings.problems[0] == result.draws[0].ended()) {  // no draw is a case
    return exit_failed;
  }
  // draws that are no case are none of an engine's doing; what it fails at, is
  for (std::size_t setup = 1; setup < reading.request.setups.size(); ++setup) {
    if (findings.problems[setup] > findings.problems[0]) {
      return exit_failed;
    }
  }
  return exit_done;
}

/// The part of one process of `team`.
int take_part(const EnsembleCommand& command, Team& team) {
  const EnsembleReading reading = read_ensemble(command);
  if (!none_has(reading.problems, team)) {
    return exit_usage;
  }
  catch_interruption();
  std::optional<Descriptor> tree;
  if (team.leads()) {
    tree = open_tree(command.out, !command.resume);
  }
  static_cast<void>(team.all(true));  // before that nobody may write to it
  try {
    const EnsembleResult result =
        team.size() == 1 ? solve_alone(command, reading) : solve_with(reading, team);
    if (!team.leads()) {
      return result.interrupted ? exit_failed : exit_done;
    }
    return conclude(command, reading, result, team);
  } catch (const FileError& error) {
    throw FileError(
        fmt::format("{}; what is done is kept: the same command with --resume does the "
                    "rest",
                    error.what()));
  }
}

/// Writes a draw of the exact motion as a case file.
int write_draw(const EnsembleCommand& command) {
  const SpecReading reading = read_spec(command);
  if (!reading.problems.empty()) {
    complain(reading.problems);
    return exit_usage;
  }
  const EnsembleSpec& spec = *reading.spec;
  if (*command.draw < 0 || *command.draw >= static_cast<long long>(draw_count(spec))) {
    complain({fmt::format("--draw {}: must be from 0 to {}, as --count says", *command.draw,
                          draw_count(spec) - 1)});
    return exit_usage;
  }
  const EnsembleSetup exact = setups_of(spec, {}).front();
  const AnyCase the_case = named_case_of(spec, exact, static_cast<std::size_t>(*command.draw));
  if (const auto broken = problems(the_case); !broken.empty()) {
    complain({fmt::format("--draw {}: no such case: {}", *command.draw, broken.front())});
    return exit_failed;
  }
  const bool is_default = spec.law == SolveOptions{}.law;
  fmt::print("# draw {} of {}{}\n{}", *command.draw, printable(command.spec),
             is_default ? "" : fmt::format(", which is solved with --law {}", to_string(spec.law)),
             written(the_case));
  return exit_done;
}

int ensemble_command(const EnsembleCommand& command) {
  if (command.draw) {
    return write_draw(command);
  }
  Team team;
  if (team.size() == 1) {
    return take_part(command, team);
  }
  try {
    return take_part(command, team);
  } catch (const std::exception& error) {
    complain({error.what()});
    team.abandon(exit_failed);
    return exit_failed;
  }
}

}  // namespace

void add_ensemble(CLI::App& app, int& code) {
  CLI::App* const command = app.add_subcommand(
      "ensemble", "Many draws of a case, exact and by engines, as distributions");
  const auto asked = std::make_shared<EnsembleCommand>();
  command
      ->add_option(
          "SPEC", asked->spec,
          "a file (TOML) that names the case, what varies, how many draws, and the engines")
      ->required();
  command->add_option("--case", asked->the_case, "this case instead, a file or a shipped one")
      ->option_text("CASE");
  command->add_option("--count", asked->count,
                      "number of draws; with a grid: at each of its points");
  command->add_option("--out", asked->out, "folder for the page and the draws")
      ->option_text("FOLDER")
      ->capture_default_str();
  command->add_option("--jobs", asked->jobs, "draws at a time (default: one per core)");
  command->add_flag("--resume", asked->resume, "keep the draws that --out already has");
  command->add_option("--time-limit", asked->time_limit, "end an engine's run after this long [s]")
      ->option_text("SECONDS")
      ->capture_default_str();
  add_target(*command, "--json", asked->json, "also write the result as JSON");
  add_schema(*command, ensemble_schema_json);
  command
      ->add_option("--draw", asked->draw,
                   "print this draw as a case file instead, for `tautline solve` and `run`")
      ->excludes("--json")
      ->excludes("--resume");
  command->footer("tautline ensemble standard.toml --count 200");
  command->callback([asked, &code] { code = ensemble_command(*asked); });
}

}  // namespace tautline::bench
