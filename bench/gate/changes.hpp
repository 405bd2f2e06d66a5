#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/gate/noise.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// A name or version that differs; none: it is not there.
struct VersionChange {
  std::string what;
  std::optional<std::string> before;
  std::optional<std::string> after;
};

/// A run that ended otherwise.
struct StatusChange {
  RunKey key;
  Status before = Status::finished;
  Status after = Status::finished;
  std::string reason;  // of the second
};

/// A metric that changed by more than noise; none: not measured.
struct MetricChange {
  RunKey key;
  std::size_t metric = 0;  // its place in the list
  std::optional<double> before;
  std::optional<double> after;
};

/// The cost ratios of one engine, model and step that changed by more than noise.
struct CostChange {
  SetupKey key;
  std::size_t cases = 0;
  double factor = 1.0;  // median
};

/// What changed from one report to another beyond noise.
struct Changes {
  std::size_t compared = 0;  // runs
  Noise noise;
  std::vector<VersionChange> versions;
  std::vector<StatusChange> new_failures;
  std::vector<StatusChange> recovered;
  std::vector<MetricChange> got_worse;
  std::vector<MetricChange> got_better;
  std::vector<RunKey> only_before;
  std::vector<RunKey> only_after;
  std::vector<RunKey> other_case;  // whose case has changed and kept its name
  std::vector<CostChange> costs;

  /// How many changes are for the worse, and how many for the better.
  [[nodiscard]] std::size_t count_worse() const {
    return new_failures.size() + got_worse.size() + only_before.size();
  }
  [[nodiscard]] std::size_t count_better() const { return recovered.size() + got_better.size(); }
  [[nodiscard]] bool worse() const { return count_worse() > 0; }
};

/// Why two reports cannot be compared at all; empty if they can.
[[nodiscard]] std::vector<std::string> incomparable(const Report& before, const Report& after);

/// What changed. Both list the engine and the case of each of their runs. Of what lies beyond the
/// horizon, only extremes of the whole run are compared, by a factor (Noise::extremes).
[[nodiscard]] Changes changes(const Report& before, const Report& after, const Noise& noise = {});

/// True where both ask the same of their runs, up to the rounding of another compiler; a case of a
/// suite may be changed and keep its name.
[[nodiscard]] bool same_case(const CaseRow& one, const CaseRow& two);

}  // namespace tautline::bench
