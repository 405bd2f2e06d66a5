#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/gate/pattern.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

struct Form;

/// A problem that runs are known to have, which only a person can say: why it is so, and that it
/// may stay.
struct ListedProblem {
  RunPattern runs;
  std::string kind;      // of `problem_kinds`
  std::string finding;   // what was found when it was listed; may be ""
  std::string reason;    // why it is so; "" until a person has said it
  bool in_some = false;  // of these runs: that none shows it in a report says nothing
};

/// The content of a problems file.
struct ListedProblems {
  std::string file;
  std::string version;
  std::vector<ListedProblem> problems;
  std::string schema_line = {};  // "#:schema PATH", by which an editor finds the schema; may be ""

  /// The first that is about this problem of `run`; null without one.
  [[nodiscard]] const ListedProblem* find(const RunKey& run, std::string_view kind) const;
};

/// The problems of a file, or all that is wrong with it.
struct ProblemsReading {
  std::optional<ListedProblems> listed;  // present exactly when `problems` is empty
  std::vector<std::string> problems;     // sentences with file, line, key, value and what is right
};

/// The number of the file's form: its key `schema`.
inline constexpr int problems_schema = 2;

/// The names that there are, against which those of a problems file are held.
struct ProblemNames {
  struct Engine {
    std::string name;
    std::optional<std::vector<std::string>> models;  // none where it is not here to be asked
  };
  std::vector<Engine> engines;
  std::vector<std::string> cases;
};

/// A model that an engine of `names` does not have, a case that a series of `names` does not have,
/// and any name that is nearly one of `names` is a mistake. Other names are not: an engine or a
/// case of the user's own need not be there each time.
[[nodiscard]] ProblemsReading read_problems_file(const std::filesystem::path& path,
                                                 const ProblemNames& names = {});
[[nodiscard]] ProblemsReading read_problems_text(std::string_view text,
                                                 const std::string& source_name,
                                                 const ProblemNames& names = {});

/// The keys of such a file.
[[nodiscard]] Form problems_form();

/// The name of the shipped list, which is about more engines than most reports.
inline constexpr std::string_view shipped_problems_file = "problems.toml, built in";

/// bench/gate/problems.toml as it was when the program was built.
[[nodiscard]] ListedProblems shipped_problems();

}  // namespace tautline::bench
