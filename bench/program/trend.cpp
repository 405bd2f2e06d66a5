#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "bench/base/atomic_file.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/process.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/changes_output.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/request.hpp"
#include "bench/program/results.hpp"
#include "bench/report/words.hpp"
#include "bench/store/tree.hpp"
#include "bench/tools/trend/version_trend.hpp"
#include "bench/tools/trend/versions.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

/// What `tautline trend` was asked.
struct TrendCommand {
  std::vector<std::string> engines;  // with their versions
  bool every = false;                // version, not only the newest of each minor one
  bool all = false;                  // print each model and step over the versions, too
  BenchCommand runs;                 // of each version; its --out and --json are the trend's
};

/// What is asked of npm, before anything is fetched or run.
std::vector<VersionPlan> plans_of(const TrendCommand& command, std::vector<std::string>& problems) {
  std::vector<VersionPlan> plans;
  for (const std::string& text : command.engines) {
    plans.push_back(version_plan(text, command.every));
    const VersionPlan& plan = plans.back();
    append(problems, plan.problems);
    const auto same = [&](const VersionPlan& other) {
      return other.engine.name == plan.engine.name;
    };
    if (plan.problems.empty() && std::any_of(plans.begin(), plans.end() - 1, same)) {
      problems.push_back(fmt::format("engine {} is given twice", plan.engine.name));
    }
  }
  return plans;
}

/// Runs the suite on the copy of an engine, and writes its report where any report is; what hinders
/// that becomes the version's problem.
void run_version(const TrendCommand& command, const std::string& engine, const fs::path& copy,
                 TrendVersion& version) {
  BenchCommand runs = command.runs;
  runs.engines = {copy.string()};
  runs.out /= fs::path(engine) / version.version;
  runs.json.clear();
  runs.draws = 0;  // versions are compared with each other run by run
  const Request request = read_request(runs);
  // first why it does not start: an engine that does not has no models to ask for either
  const auto& asked = request.options.engines;
  version.problem = !asked.empty() && !asked.front().info ? asked.front().failure
                                                          : joined(request.problems, "and");
  if (!version.problem.empty()) {
    version.problem = interruption() ? "interrupted" : version.problem;
    return;
  }
  RunSuite done = run_request(request, command.runs.command_line);
  write_results({runs.out, "", std::nullopt, request.listed, false}, done.report, done.replay);
  if (done.result.interrupted) {
    version.problem = fmt::format("interrupted: {} of {} runs are finished",
                                  done.result.runs.size(), done.result.due);
    return;
  }
  version.file = (runs.out / "report.json").string();
  version.report = std::move(done.report);
}

/// Fetches version `index`, unless it was before, and runs it.
TrendVersion measure(const TrendCommand& command, const VersionPlan& plan, std::size_t index) {
  const PlannedVersion& planned = plan.versions[index];
  TrendVersion version{planned.version, planned.untried, "", "", std::nullopt};
  if (interruption()) {
    version.problem = "interrupted";
    return version;
  }
  const std::string name = plan.engine.name + " " + printable(planned.version);
  fmt::print(stderr, "{}, version {} of {}\n", name, index + 1, plan.versions.size());
  const PinnedEngine copy = pinned_engine(plan.engine, planned.version, version_cache());
  version.problem = copy.problem;
  if (version.problem.empty()) {
    run_version(command, plan.engine.name, copy.file, version);
  }
  if (!version.problem.empty() && !interruption()) {
    fmt::print(stderr, "{}: {} (its folder: {})\n", name, version.problem,
               printable(copy.file.parent_path().string(), longest_sentence));
  }
  return version;
}

VersionTrend trend_of(const TrendCommand& command, const VersionPlan& plan) {
  VersionTrend result{plan.engine.name, plan.engine.package, plan.range, {}, std::nullopt};
  for (std::size_t index = 0; index < plan.versions.size(); ++index) {
    result.versions.push_back(measure(command, plan, index));
  }
  find_trend(result);
  return result;
}

/// Writes the page, its charts and the JSON, and prints what changed.
void give(const TrendCommand& command, const std::vector<VersionTrend>& trends) {
  const fs::path& out = command.runs.out;
  for (const VersionTrend& trend : trends) {
    if (trend.trend) {
      write_file(out / chart_name(trend.engine), version_svg(trend));
    }
    if (command.runs.json != "-") {
      fmt::print("{}\n", version_text(trend, command.all, output_style()));
    }
  }
  write_file(out / "index.html", version_html(trends, page_assets()));
  write_file(out / "trend.md", version_markdown(trends));
  const std::string json = version_trends_json(trends);
  write_file(out / "trend.json", json);
  if (!command.runs.json.empty()) {
    write_output(command.runs.json, json);
  }
  if (command.runs.json != "-") {
    fmt::print("trend: {}, with trend.md, its charts and trend.json next to it\n",
               (out / "index.html").string());
  }
}

int trend_command(const TrendCommand& command) {
  Request runs = read_runs(command.runs);
  append(runs.problems, suite_problems(runs.options));
  const std::vector<VersionPlan> plans =
      runs.problems.empty() ? plans_of(command, runs.problems) : std::vector<VersionPlan>();
  if (complain(runs.problems)) {
    return exit_usage;
  }
  catch_interruption();
  const Descriptor tree = open_tree(command.runs.out, false);
  const std::vector<VersionTrend> trends =
      listed(plans, [&](const VersionPlan& plan) { return trend_of(command, plan); });
  give(command, trends);
  if (interruption()) {
    complain(
        {"interrupted: the versions that are finished are in the trend; the same command with "
         "--resume does the rest"});
    return exit_failed;
  }
  return std::any_of(trends.begin(), trends.end(), newest_is_worse) ? exit_failed : exit_done;
}

/// What is run on each version, as `tautline bench` is asked for it.
void add_runs(CLI::App& command, BenchCommand& runs) {
  command
      .add_option("--cases", runs.cases,
                  std::string(case_help) + ", several with commas. Without: --suite quick")
      ->delimiter(',');
  command
      .add_option(
          "--suite", runs.suite,
          "a selection of shipped cases: " + suite_names("or") + "; see `tautline help bench`")
      ->option_text("SUITE");
  command.add_option("--models", runs.models, "only these models: row,event (default: all)")
      ->option_text("MODELS")
      ->delimiter(',');
  command
      .add_option("--steps", runs.steps,
                  "step sizes [s] (default: the suite's; for --cases 0.01,0.001,0.0001)")
      ->option_text("SECONDS")
      ->delimiter(',');
  command
      .add_option("--until", runs.until,
                  "end longer cases at this time [s]; shorter ones stay as they are")
      ->option_text("SECONDS");
  command.add_option("--out", runs.out, "folder for the trend and the versions' reports")
      ->option_text("FOLDER")
      ->capture_default_str();
  command.add_option("--jobs", runs.jobs, "runs at a time (default: one per core)");
  command.add_flag("--resume", runs.resume, "keep the runs that --out already has");
  command.add_option("--time-limit", runs.time_limit, "end a run after this long [s]")
      ->option_text("SECONDS")
      ->capture_default_str();
  add_target(command, "--json", runs.json, "also write the trend as JSON");
  add_schema(command, version_trends_schema_json);
}

}  // namespace

void add_trend(CLI::App& app, int& code, const std::string& command_line) {
  CLI::App* const command =
      app.add_subcommand("trend", "An engine over the versions of its npm package: error and cost");
  const auto asked = std::make_shared<TrendCommand>();
  asked->runs.command_line = command_line;
  asked->runs.out = "trend";
  asked->runs.certify = false;  // versions are compared with each other
  command
      ->add_option("ENGINES", asked->engines,
                   "engines that npm installs, by name or engine.toml, each with its versions: "
                   "rapier2d@0.15..0.21, planck@1.0.., ./mine/engine.toml@^2. Without versions: "
                   "those that its engine.toml names. Each is installed once, in "
                   "$XDG_CACHE_HOME/tautline/npm, or ~/.cache/tautline/npm")
      ->required();
  command->add_flag("--every", asked->every,
                    "run every version, not only the newest of each minor one");
  command->add_flag("--all", asked->all,
                    "also print each model and step over the versions; the page always has them");
  add_runs(*command, asked->runs);
  command->footer(
      "tautline trend rapier2d@0.15..0.21\n"
      "tautline trend planck@1.0..1.4.2 matter@0.18.. --models row --steps 0.001");
  command->callback([asked, &code] { code = trend_command(*asked); });
}

}  // namespace tautline::bench
