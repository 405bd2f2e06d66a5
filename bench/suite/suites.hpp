#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::bench {

/// Cases of a suite.
struct SuiteCases {
  std::string_view cases;  // the name of a shipped case, or a pattern of such names
  std::string_view shows;  // what happens in them
};

/// A selection of shipped cases with the steps that they are run with.
struct Suite {
  std::string_view name;
  std::string_view sentence;  // what it is for
  std::vector<double> steps;  // [s]
  std::vector<SuiteCases> entries;
  std::size_t draws = 0;  // of the standard case, unasked: see `compare_draws`
  bool systems = false;   // of systems, which a pattern does not mean
};

/// The suites that `tautline bench` has, the one that it runs unasked first.
[[nodiscard]] std::span<const Suite> suites();

/// Null if there is none of this name.
[[nodiscard]] const Suite* find_suite(std::string_view name);

/// All their names, with `last_word` before the last: "a, b or c".
[[nodiscard]] std::string suite_names(const std::string& last_word);

/// Names and patterns, as `select_cases` takes them.
[[nodiscard]] std::vector<std::string> cases_of(const Suite& suite);

/// The steps of cases that are named one by one [s].
[[nodiscard]] const std::vector<double>& usual_steps();

/// Every suite with its steps and what each of its cases shows, for a terminal.
[[nodiscard]] std::string suites_text();

}  // namespace tautline::bench
