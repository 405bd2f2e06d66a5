#include "bench/gate/gate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/verdict.hpp"

namespace tautline::bench {
namespace {

/// Rows that anyone reads; the report has them all.
constexpr std::size_t most_broken = 100;

std::string table_of(const std::vector<BrokenRow>& rows) {
  Table table({"engine", "model", "case", "step", "metric", "value", "limit", "reason"}, 5, 1);
  for (std::size_t index = 0; index < std::min(most_broken, rows.size()); ++index) {
    const BrokenRow& row = rows[index];
    table.add({row.engine, row.model, row.the_case, row.step, row.metric, row.value, row.limit,
               row.reason});
  }
  const std::string rest =
      rows.size() > most_broken
          ? fmt::format("and {} more, all in the report\n", rows.size() - most_broken)
          : "";
  return table.plain() + "\n" + rest;
}

/// "3 pass, 1 known deviation"
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

/// "bullet64 contact restitution_error"
std::string name_of(const KnownDeviation& known) {
  const RunPattern& runs = known.runs;
  return printable(fmt::format("{} {} {}{}{}", runs.engine, runs.model, known.metric,
                               runs.the_case == "*" ? "" : " on " + runs.the_case,
                               runs.step ? fmt::format(" at {:g} s", *runs.step) : ""));
}

/// "2 of 9 [[known]] entries are about no run here: ...", or "".
std::string sentence(const std::vector<std::string>& names, std::size_t all, const char* what) {
  if (names.empty()) {
    return "";
  }
  std::string list;
  for (std::size_t index = 0; index < std::min(most_named, names.size()); ++index) {
    list += (index == 0 ? "" : "; ") + names[index];
  }
  if (names.size() > most_named) {
    list += fmt::format("; and {} more", names.size() - most_named);
  }
  return wrapped(fmt::format("{} of {} [[known]] entries {}: {}.", names.size(), all, what, list),
                 line_length);
}

/// Says which entries of a limits file are about no run of the report, and which known deviations
/// no run of it shows, though that breaks nothing: subsets are run too.
std::string unused_entries(const Report& report, const Limits& limits) {
  const Precisions precisions(report);
  const auto meant = [&](const RunPattern& runs, const RunRow& run) {
    return runs.holds(run.key, precisions.of(run.key));
  };
  std::vector<std::string> without_runs;
  std::vector<std::string> not_shown;
  for (const KnownDeviation& known : limits.known) {
    bool any = false;
    bool shown = false;
    for (const RunRow& run : report.runs) {
      if (!meant(known.runs, run)) {
        continue;
      }
      any = true;
      const auto& checks = run.verdict.value().checks;
      shown = shown || std::any_of(checks.begin(), checks.end(), [&](const Check& check) {
                return is_about(known, check.metric) && check.holds != Holds::yes;
              });
    }
    if (!shown) {
      (any ? not_shown : without_runs).push_back(name_of(known));
    }
  }
  const auto idle =
      std::count_if(limits.limits.begin(), limits.limits.end(), [&](const Limit& one) {
        return std::none_of(report.runs.begin(), report.runs.end(),
                            [&](const RunRow& run) { return meant(one.runs, run); });
      });
  return sentence(without_runs, limits.known.size(), "are about no run of this report") +
         sentence(not_shown, limits.known.size(), "are shown by no run of this report") +
         (idle > 0 ? fmt::format("{} of {} limits are about no run of this report.\n", idle,
                                 limits.limits.size())
                   : "");
}

}  // namespace

std::string gate_text(const Report& report, const Limits& limits,
                      const std::vector<BrokenRow>& rows) {
  const std::string source = printable(limits.file) + ", version " + printable(limits.version);
  const std::string unused = unused_entries(report, limits);
  if (rows.empty()) {
    return unused + fmt::format("The gate holds ({}): {}.\n", source, counts(report));
  }
  return table_of(rows) + unused +
         fmt::format("The gate is broken by {} row{} ({}): {}.\n", rows.size(),
                     rows.size() == 1 ? "" : "s", source, counts(report));
}

}  // namespace tautline::bench
