#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::bench {

/// One number of a run's row of the report that a limit can be set on; smaller is better.
struct LimitedMetric {
  std::string_view name;
  std::string_view unit;     // "1" for a ratio
  std::string_view meaning;  // ends in a full stop
  /// The metric of a run; none where the run did not allow to measure it.
  std::optional<double> (*of)(const nlohmann::ordered_json& run);
};

/// Every metric that a limit can be set on.
[[nodiscard]] std::span<const LimitedMetric> limited_metrics();

/// Which runs an entry of the manifest is about. Names are patterns as for files: * and ?.
struct RunPattern {
  std::string engine = "*";
  std::string model = "*";
  std::string the_case = "*";
  std::string precision = "*";  // of the engine: float64 or float32
  std::optional<double> step;   // [s]; any without one

  /// True where `run` of the report, on an engine of `precision_of_run`, is one of these.
  [[nodiscard]] bool holds(const nlohmann::ordered_json& run,
                           const std::string& precision_of_run) const;
};

/// A limit: constant + per_step * step + over_step / step, in the unit of the metric. A scheme of
/// first order needs the second term, the rounding of many steps the third.
struct Limit {
  RunPattern runs;
  std::string metric;
  double constant = 0.0;
  double per_step = 0.0;   // [unit / s]
  double over_step = 0.0;  // [unit s]
  std::string reason;      // where the number comes from

  [[nodiscard]] double at(double step) const {
    return constant + per_step * step + over_step / step;
  }
};

/// A limit that runs are known to break, or `failure`: that they are known to fail or diverge.
struct KnownDeviation {
  RunPattern runs;
  std::string metric;
  std::string reason;
};
inline constexpr std::string_view failure = "failure";

/// Runs that are not judged.
struct Unjudged {
  RunPattern runs;
  std::string word;  // "informative" or "unsupported"
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

[[nodiscard]] LimitsReading read_limits_file(const std::filesystem::path& path);
[[nodiscard]] LimitsReading read_limits_text(std::string_view text, const std::string& source_name);

/// bench/gate/limits.toml as it was when the program was built.
[[nodiscard]] Limits shipped_limits();

}  // namespace tautline::bench
