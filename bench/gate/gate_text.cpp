#include "bench/gate/gate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "bench/gate/verdict.hpp"

namespace tautline::bench {
namespace {

std::string step_text(const std::optional<double>& step) {
  return step ? fmt::format("{:g}", *step) : "";
}

/// Engines whose plug-in is there and does not work.
void add_engines(const Report& report, std::vector<BrokenRow>& rows) {
  for (const EngineRow& engine : report.engines) {
    if (engine.problem && !engine.missing) {
      rows.push_back({printable(engine.name), "", "", "", "failure",
                      "no runs: " + printable(*engine.problem)});
    }
  }
}

void add_runs(const Report& report, std::vector<BrokenRow>& rows) {
  for (const RunRow& run : report.runs) {
    for (const Problem& problem : run.verdict.value().problems) {
      if (!problem.listed) {
        rows.push_back({printable(run.key.engine), printable(run.key.model),
                        printable(run.key.the_case), step_text(run.key.step), problem.kind,
                        printable(problem.sentence)});
      }
    }
  }
}

/// Listed problems that runs of the report could show and none does.
void add_gone(const Report& report, const ListedProblems& listed, std::vector<BrokenRow>& rows) {
  for (const ListedProblem& problem : listed.problems) {
    if (is_gone(problem, report)) {
      rows.push_back({printable(problem.runs.engine), printable(problem.runs.model),
                      problem.runs.the_case == "*" ? "" : printable(problem.runs.the_case),
                      step_text(problem.runs.step), problem.kind,
                      "is listed and no run shows it any more: delete it from the file; there: " +
                          printable(problem.reason)});
    }
  }
}

/// Rows that anyone reads; the report has them all.
constexpr std::size_t most_broken = 100;

std::string table_of(const std::vector<BrokenRow>& rows) {
  Table table({"engine", "model", "case", "step", "kind", "what"}, 5, 1);
  for (const BrokenRow& row : rows) {
    table.add({row.engine, row.model, row.the_case, row.step, row.kind, row.what});
  }
  table.cut(most_broken, ", all in the report");
  return table.plain() + "\n";
}

/// "3 sound, 1 listed problem"
std::string counts(const Report& report) {
  std::string result;
  for (const Word word : all_words) {
    const auto count =
        std::count_if(report.runs.begin(), report.runs.end(),
                      [&](const RunRow& run) { return run.verdict.value().word == word; });
    if (count > 0) {
      result += fmt::format("{}{} {}", result.empty() ? "" : ", ", count, to_string(word));
    }
  }
  return result.empty() ? "no runs" : result;
}

/// More entries of a kind than these are counted, not named.
constexpr std::size_t most_named = 5;

constexpr std::size_t line_length = 80;  // [columns]

/// "bullet64 contact restitution"
std::string name_of(const ListedProblem& problem) {
  const RunPattern& runs = problem.runs;
  return printable(fmt::format("{} {} {}{}{}", runs.engine, runs.model, problem.kind,
                               runs.the_case == "*" ? "" : " on " + runs.the_case,
                               runs.step ? fmt::format(" at {:g} s", *runs.step) : ""));
}

/// Says which listed problems are `such`: "2 of 9 listed problems have no reason: ...".
template <class Such>
std::string entries_text(const ListedProblems& listed, const Such& such, const char* what) {
  std::vector<std::string> names;
  for (const ListedProblem& problem : listed.problems) {
    if (such(problem)) {
      names.push_back(name_of(problem));
    }
  }
  if (names.empty()) {
    return "";
  }
  const std::size_t all = names.size();
  names.resize(std::min(most_named, all));
  const std::string rest = all > most_named ? fmt::format("; and {} more", all - most_named) : "";
  return wrapped(fmt::format("{} of {} listed problems {}: {}{}.", all, listed.problems.size(),
                             what, fmt::join(names, "; "), rest),
                 line_length);
}

std::string entry_of(const ListedProblem& problem) {
  const RunPattern& runs = problem.runs;
  const auto line = [](const char* key, const std::string& value) {
    return fmt::format("{} = {}\n", key, toml_string(value));
  };
  return "\n[[problem]]\n" + line("engine", runs.engine) + line("model", runs.model) +
         (runs.the_case != "*" ? line("case", runs.the_case) : "") +
         (runs.step ? fmt::format("step = {}\n", shortest(*runs.step)) : "") +
         line("kind", problem.kind) +
         (problem.finding.empty() ? "" : line("finding", problem.finding)) +
         line("reason", problem.reason) + (problem.in_some ? "in_some = true\n" : "");
}

}  // namespace

std::vector<BrokenRow> broken_rows(const Report& report, const ListedProblems& listed) {
  std::vector<BrokenRow> rows;
  add_engines(report, rows);
  add_runs(report, rows);
  add_gone(report, listed, rows);
  if (rows.empty() && std::none_of(report.runs.begin(), report.runs.end(),
                                   [](const RunRow& run) { return run.judgement.has_value(); })) {
    rows.push_back({"", "", "", "", "", "no run could be judged"});
  }
  return rows;
}

std::string gate_text(const Report& report, const ListedProblems& listed,
                      const std::vector<BrokenRow>& rows) {
  const std::string source = printable(listed.file) + ", version " + printable(listed.version);
  const auto unused = [&](const ListedProblem& problem) {  // subsets are run too
    return listed.file != shipped_problems_file &&
           std::none_of(report.runs.begin(), report.runs.end(),
                        [&](const RunRow& run) { return problem.runs.holds(run.key); });
  };
  const std::string notes =
      entries_text(listed, unused, "are about no run of this report") +
      entries_text(
          listed, [](const ListedProblem& problem) { return problem.reason.empty(); },
          "have no reason in the file yet");
  if (rows.empty()) {
    return notes + fmt::format("The gate holds ({}): {}.\n", source, counts(report));
  }
  return table_of(rows) + notes +
         fmt::format("The gate is broken by {} row{} ({}): {}.\n", rows.size(),
                     rows.size() == 1 ? "" : "s", source, counts(report));
}

std::string problems_file_of(const Report& report, const ListedProblems& before,
                             const ListedProblems& known) {
  std::map<std::tuple<std::string, std::string, std::string>, ListedProblem> added;
  for (const RunRow& run : report.runs) {
    for (const Problem& problem : run.verdict.value().problems) {
      if (before.find(run.key, problem.kind) == nullptr) {
        const ListedProblem* const said = known.find(run.key, problem.kind);
        added.try_emplace({run.key.engine, run.key.model, problem.kind},
                          ListedProblem{{run.key.engine, run.key.model, "*", {}},
                                        problem.kind,
                                        problem.sentence,
                                        said != nullptr ? said->reason : ""});
      }
    }
  }
  std::string out = before.schema_line + (before.schema_line.empty() ? "" : "\n");
  out += fmt::format(
      "# Problems that runs of these models are known to have. Say in each reason why it may "
      "stay;\n"
      "# `tautline bench --gate` reads them: other problems break it, and so do listed ones that "
      "are gone.\n"
      "schema = {}\nversion = {}\n",
      problems_schema, toml_string(before.version.empty() ? "1" : before.version));
  for (const ListedProblem& problem : before.problems) {
    out += is_gone(problem, report) ? "" : entry_of(problem);
  }
  for (auto& entry : added) {
    ListedProblem& problem = entry.second;
    problem.in_some = std::any_of(report.runs.begin(), report.runs.end(), [&](const RunRow& run) {
      return problem.runs.holds(run.key) && !shows(run, problem.kind);
    });
    out += entry_of(problem);
  }
  return out;
}

}  // namespace tautline::bench
