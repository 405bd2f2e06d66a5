#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <string>
#include <system_error>

#include "bench/base/process.hpp"
#include "bench/program/commands.hpp"
#include "bench/run/worker.hpp"

namespace {

using namespace tautline::bench;

/// A word in single quotes, for a shell.
std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char letter : word) {
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return result + "'";
}

/// The command line as it was typed, quoted where a shell would need it.
std::string typed(int count, char** arguments) {
  std::string result;
  for (int index = 0; index < count; ++index) {
    const std::string word = arguments[index];
    const bool plain = word.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                           "-_./,:=+@%") == std::string::npos;
    result += (index == 0 ? "" : " ") + (plain && !word.empty() ? word : quoted(word));
  }
  return result;
}

std::map<std::string, tautline::ImpactLaw> law_names() {
  std::map<std::string, tautline::ImpactLaw> names;
  for (const tautline::ImpactLaw law : tautline::impact_laws) {
    names.emplace(tautline::to_string(law), law);
  }
  return names;
}

/// Adds `--law` to `command`, with what it is for.
void add_law(CLI::App& command, tautline::ImpactLaw& law, const std::string& help) {
  command
      .add_option_function<std::string>(
          "--law", [&law](const std::string& name) { law = law_names().at(name); }, help)
      ->check(CLI::IsMember(law_names()))
      ->default_str("simultaneous");
}

/// An empty name, as of an unset variable of a shell, would write nothing.
std::string named_file(const std::string& name) {
  return name.empty() ? "must be the name of a file, or -" : "";
}

constexpr const char* law_help =
    "the exact motion's law for impacts on several cables, and that of models that leave the "
    "choice";

constexpr const char* case_help =
    "a case file (TOML), the name of a shipped case, or a pattern of such names in quotes: "
    "'breakwater/19*'; `tautline cases` lists them";

/// The commands and their options; `code` gets the exit code of the one that ran. Everything given
/// here must outlive `app`, which runs the command while it parses.
void set_up(CLI::App& app, int& code, SolveCommand& solve, RunCommand& run, BenchCommand& bench,
            CompareCommand& compare, CheckCommand& check, ReproduceCommand& reproduce,
            EnginesCommand& engines, CasesCommand& cases) {
  app.require_subcommand(1);
  app.set_version_flag("--version", "tautline " TAUTLINE_VERSION);

  CLI::App* command =
      app.add_subcommand("solve", "The exact motion of a case: its events and its end");
  command->add_option("CASE", solve.the_case, case_help)->required();
  command->add_option("--until", solve.until,
                      "end the run at this time [s], not at the case's duration");
  command->add_option("--at", solve.at, "also give the state at these times [s]: 1,2.5,3")
      ->delimiter(',');
  command->add_option("--angle-limit", solve.angle_limit, "end where |angle| reaches this [rad]");
  command->add_option("--ceiling", solve.ceiling,
                      "end where an attachment rises to this height [m]");
  add_law(*command, solve.law, "how impacts on several cables are resolved");
  command->add_flag("--certify", solve.certify,
                    "solve with many digits as well, and say how far the doubles are right");
  command->add_option("--digits", solve.digits,
                      "decimal digits for --certify, 20 to 1000 (default: 50)");
  command
      ->add_option("--json", solve.json, "write everything as JSON to this file, or to stdout: -")
      ->check(named_file);
  command
      ->add_option("--plot", solve.plot,
                   "write a picture of the motion (SVG) to this file, or to stdout: -")
      ->check(named_file);
  command->callback([&] { code = solve_command(solve); });

  command = app.add_subcommand("run", "One case on one engine, held against the exact motion");
  command->add_option("CASE", run.the_case, case_help)->required();
  command->add_option("--engine", run.engine, "an engine's name, or the path of a plug-in")
      ->required();
  command->add_option("--model", run.model, "how its cables are modelled")->required();
  command->add_option("--step", run.step, "the engine's step [s]")->capture_default_str();
  add_law(*command, run.law, law_help);
  command->add_option("--time-limit", run.time_limit, "end the run after this long [s]")
      ->capture_default_str();
  command->add_option("--out", run.out,
                      "write trajectory.csv, events.csv and settings below this folder");
  command->add_option("--json", run.json, "write the result as JSON to this file, or to stdout: -");
  command->callback([&] { code = run_command(run); });

  command = app.add_subcommand("bench", "Cases x engines x models x steps, and a report");
  command->add_option("CASES", bench.cases, case_help)->default_str("'breakwater/*'");
  command
      ->add_option("--engines,--engine", bench.engines,
                   "names or plug-in paths: bullet64,./libmine.so (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);  // a case may follow
  command->add_option("--models", bench.models, "only these models: row,event (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--steps", bench.steps, "steps [s]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--until", bench.until, "end every run at this time [s]");
  add_law(*command, bench.law, law_help);
  command->add_option("--out", bench.out, "folder for the report and the runs' files")
      ->capture_default_str();
  command->add_option("--jobs", bench.jobs, "runs at a time (default: one per core)");
  command->add_flag("--resume", bench.resume, "keep the runs that --out already has");
  command->add_option("--time-limit", bench.time_limit, "end a run after this long [s]")
      ->capture_default_str();
  command->add_option("--json", bench.json,
                      "also write the report as JSON to this file, or to stdout: -");
  command->add_option("--gate", bench.gate,
                      "a limits file (TOML): exit code 1 if a run breaks it, and which");
  command->callback([&] { code = bench_command(bench); });

  command = app.add_subcommand("compare", "What changed from one report to another beyond noise");
  command->add_option("BEFORE", compare.before, "report.json of the one `bench`")->required();
  command->add_option("AFTER", compare.after, "report.json of the other")->required();
  command->add_option("--json", compare.json,
                      "write the changes as JSON to this file, or to stdout: -");
  command->callback([&] { code = compare_command(compare); });

  command = app.add_subcommand("check", "Whether an engine does what every sound engine does");
  command->add_option("PLUGIN", check.engine, "the path of a plug-in, or an engine's name")
      ->required();
  command->add_option("--model", check.model, "only this model (default: all)");
  command
      ->add_option("--time-limit", check.time_limit, "end the check of a model after this long [s]")
      ->capture_default_str();
  command->add_option("--json", check.json,
                      "write the verdicts as JSON to this file, or to stdout: -");
  command->callback([&] { code = check_command(check); });

  command = app.add_subcommand("reproduce",
                               "The source chapter's tables and figures, and what it got wrong");
  command
      ->add_option("--out", reproduce.out,
                   "folder for chapter.html, chapter.md, chapter.json and chapter/")
      ->capture_default_str();
  command->add_option("--json", reproduce.json,
                      "also write chapter.json to this file, or to stdout: -");
  command->callback([&] { code = reproduce_command(reproduce); });

  command =
      app.add_subcommand("engines", "The engines that are here, their models, and those missing");
  command->add_option("--json", engines.json,
                      "write the list as JSON to this file, or to stdout: -");
  command->callback([&] { code = engines_command(engines); });

  command =
      app.add_subcommand("cases", "The shipped cases; one of them as a case file to start from");
  command->add_option("CASE", cases.the_case, "the name of a shipped case");
  command->callback([&] { code = cases_command(cases); });
}

int run_program(int count, char** arguments) {
  CLI::App app{
      "Exact rigid bodies on slack cables, and a bench that holds physics engines against them"};
  int code = exit_done;
  SolveCommand solve;
  RunCommand run;
  BenchCommand bench;
  CompareCommand compare;
  CheckCommand check;
  ReproduceCommand reproduce;
  EnginesCommand engines;
  CasesCommand cases;
  bench.command_line = typed(count, arguments);
  set_up(app, code, solve, run, bench, compare, check, reproduce, engines, cases);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    const int cli_code = app.exit(error);
    return cli_code == 0 ? exit_done : exit_usage;
  }
  return code;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::string(arguments[1]) == worker_command) {
    return worker_main();
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a failed write, not the end
  try {
    const int code = run_program(count, arguments);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      complain({std::string("cannot write to standard output: ") + std::strerror(errno)});
      return exit_failed;
    }
    return code;
  } catch (const std::system_error& error) {  // fmt's, which does not tell what it wrote to
    const bool of_output = std::ferror(stdout) != 0;
    complain({of_output ? "cannot write to standard output: " + error.code().message()
                        : std::string(error.what())});
    return exit_failed;
  } catch (const std::exception& error) {
    complain({error.what()});
    return exit_failed;
  }
}
