#include "bench/gate/gate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// Rows that anyone reads; the report has them all.
constexpr std::size_t most_broken = 100;

std::string table_of(const std::vector<BrokenRow>& rows) {
  Table table({"engine", "model", "case", "step", "kind", "what"}, 5, 1);
  for (std::size_t index = 0; index < std::min(most_broken, rows.size()); ++index) {
    const BrokenRow& row = rows[index];
    table.add({row.engine, row.model, row.the_case, row.step, row.kind, row.what});
  }
  const std::string rest =
      rows.size() > most_broken
          ? fmt::format("and {} more, all in the report\n", rows.size() - most_broken)
          : "";
  return table.plain() + "\n" + rest;
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

/// Says which listed problems are about no run of the report: subsets are run too.
std::string unused_entries(const Report& report, const ListedProblems& listed) {
  std::vector<std::string> names;
  for (const ListedProblem& problem : listed.problems) {
    if (std::none_of(report.runs.begin(), report.runs.end(),
                     [&](const RunRow& run) { return problem.runs.holds(run.key); })) {
      names.push_back(name_of(problem));
    }
  }
  if (names.empty()) {
    return "";
  }
  const std::size_t all = names.size();
  names.resize(std::min(most_named, all));
  const std::string rest = all > most_named ? fmt::format("; and {} more", all - most_named) : "";
  return wrapped(fmt::format("{} of {} listed problems are about no run of this report: {}{}.", all,
                             listed.problems.size(), fmt::join(names, "; "), rest),
                 line_length);
}

}  // namespace

std::string gate_text(const Report& report, const ListedProblems& listed,
                      const std::vector<BrokenRow>& rows) {
  const std::string source = printable(listed.file) + ", version " + printable(listed.version);
  const std::string unused = unused_entries(report, listed);
  if (rows.empty()) {
    return unused + fmt::format("The gate holds ({}): {}.\n", source, counts(report));
  }
  return table_of(rows) + unused +
         fmt::format("The gate is broken by {} row{} ({}): {}.\n", rows.size(),
                     rows.size() == 1 ? "" : "s", source, counts(report));
}

}  // namespace tautline::bench
