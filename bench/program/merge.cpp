#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "bench/base/process.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/measure/certification.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/request.hpp"
#include "bench/program/results.hpp"
#include "bench/store/manifest.hpp"
#include "bench/store/tree.hpp"
#include "bench/store/trees.hpp"
#include "bench/suite/report_of.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

/// What `tautline merge` was asked.
struct MergeCommand {
  std::vector<std::string> trees;
  std::string out;
  std::optional<std::string> gate;
  std::string json;
  std::string command_line;  // as it was typed, for the report
};

/// True where `folder` is `inner`, or one of the folders above it.
bool contains(const fs::path& folder, const fs::path& inner) {
  const fs::path outer = fs::weakly_canonical(folder);
  const fs::path path = fs::weakly_canonical(inner);
  return std::mismatch(outer.begin(), outer.end(), path.begin(), path.end()).first == outer.end();
}

/// What hinders --out from taking the merged tree; "" if nothing.
std::string out_problem(const MergeCommand& command) {
  if (command.out.empty()) {
    return "--out: is empty; give a folder to write the results to";
  }
  for (const std::string& tree : command.trees) {
    if (contains(tree, command.out) || contains(command.out, tree)) {
      return fmt::format(
          "--out {}: is, holds or lies in the tree {}, which stays as it is; give a folder next to "
          "it",
          printable(command.out, 1024), printable(tree, 1024));
    }
  }
  return tree_problem(command.out).value_or("");
}

int merge_command(const MergeCommand& command) {
  TreeSet set = read_trees({command.trees.begin(), command.trees.end()});
  std::vector<std::string> problems = set.problems;
  if (std::string problem = out_problem(command); !problem.empty()) {
    problems.push_back(std::move(problem));
  }
  append(problems, missing_folder("--json", command.json, command.out));
  const SuiteOptions options =
      set.problems.empty() ? whole_suite(set.trees, command.out) : SuiteOptions();
  ResultsTarget target = {command.out, command.json, command.gate, {}, false};
  target.listed = listed_by(command.gate, options, problems);
  if (complain(problems)) {
    return exit_usage;
  }
  const std::vector<Reference> references = solve_all(options.cases, options.law);
  const Expectations expectations = expectations_of(references);
  const Descriptor tree = open_tree(options.out, true);
  const Gathering gathering = gather(set.trees, options.out);
  Context context = made_by(set.trees);
  context.command = command.command_line;
  context.program_memory = peak_memory();
  Manifest manifest = manifest_of(options, context.command, context.started);
  manifest.shard.elapsed = context.elapsed;
  write_manifest(options.out, manifest);
  Report report =
      report_of(options, expectations, Certification(references, options.certify).digits(),
                gathering.result, std::move(context));
  add_verdicts(report, target.listed);
  write_results(target, report, replay_of(expectations, gathering.result));
  print_results(
      target, report,
      fmt::format("{} of {} runs from {} result tree{}", report.runs.size(), report.planned_runs,
                  set.trees.size(), set.trees.size() == 1 ? "" : "s"));
  if (!gathering.missing.empty()) {
    complain(gathering.missing);
    complain({"the merged report is incomplete"});
    return exit_failed;
  }
  return judged(target, report);
}

}  // namespace

void add_merge(CLI::App& app, int& code, const std::string& command_line) {
  CLI::App* const command =
      app.add_subcommand("merge", "One report from the result folders of `tautline bench --shard`");
  const auto asked = std::make_shared<MergeCommand>();
  asked->command_line = command_line;
  command->add_option("TREES", asked->trees, "the --out folders of the shards, in any order")
      ->required();
  command->add_option("--out", asked->out, "folder for the merged report and the runs' files")
      ->option_text("FOLDER")
      ->required();
  command->add_option("--gate", asked->gate, gate_help)->option_text("FILE");
  add_target(*command, "--json", asked->json, "also write the report as JSON");
  command->callback([asked, &code] { code = merge_command(*asked); });
}

}  // namespace tautline::bench
