#include "bench/gate/unused.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/verdict.hpp"

namespace tautline::bench {
namespace {

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

}  // namespace

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
                return check.metric == known.metric && check.holds == Holds::no;
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

}  // namespace tautline::bench
