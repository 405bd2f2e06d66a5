#include "bench/gate/gate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/unused.hpp"

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
