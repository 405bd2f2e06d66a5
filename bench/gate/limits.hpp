#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/gate/pattern.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// A limit: constant + per_step * step + over_step / step, in the unit of the metric. A scheme of
/// first order needs the second term, the rounding of many steps the third.
struct Limit {
  RunPattern runs;
  std::string metric;  // of the list
  double constant = 0.0;
  double per_step = 0.0;   // [unit / s]
  double over_step = 0.0;  // [unit s]
  std::string reason;      // where the number comes from

  [[nodiscard]] double at(double step) const {
    return constant + per_step * step + over_step / step;
  }
};

/// A limit that runs are known to break; or `failure`: that they are known to fail or diverge; or a
/// kind of finding that the audit is known to make in them.
struct KnownDeviation {
  RunPattern runs;
  std::string metric;
  std::string reason;
  bool in_some = false;  // of these runs: that none breaks it in a report says nothing
};
inline constexpr std::string_view failure = "failure";

/// Stands for a finding of any kind: few impacts may show a threshold as scatter.
inline constexpr std::string_view any_finding = "finding";

/// True of a kind of finding, and of any.
[[nodiscard]] bool is_finding(std::string_view metric);

/// True where `known` is about a check of `metric`.
[[nodiscard]] bool is_about(const KnownDeviation& known, std::string_view metric);

/// Runs that are not judged.
struct Unjudged {
  RunPattern runs;
  std::string reason;
};

/// What a limits file says.
struct Limits {
  std::string file;
  std::string version;
  std::vector<Limit> limits;  // of those on one run and metric, the last counts
  std::vector<KnownDeviation> known;
  std::vector<Unjudged> unjudged;  // of those on one run, the last counts
};

/// The limits of a file, or all that is wrong with it.
struct LimitsReading {
  std::optional<Limits> limits;       // present exactly when `problems` is empty
  std::vector<std::string> problems;  // sentences with file, line, key, value and what is right
};

/// The number of the manifest's form: its key `schema`.
inline constexpr int limits_schema = 1;

/// The names that there are, against which those of a limits file are held.
struct LimitNames {
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
[[nodiscard]] LimitsReading read_limits_file(const std::filesystem::path& path,
                                             const LimitNames& names = {});
[[nodiscard]] LimitsReading read_limits_text(std::string_view text, const std::string& source_name,
                                             const LimitNames& names = {});

/// bench/gate/limits.toml as it was when the program was built.
[[nodiscard]] Limits shipped_limits();

}  // namespace tautline::bench
