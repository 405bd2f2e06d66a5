#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/gate/limits.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// What the limits say of one run: of several entries the last counts, as the special stands behind
/// the general. Each answer is null where there is none.
class LimitsOnRun {
 public:
  /// `limits` and `run` must outlive this.
  LimitsOnRun(const Limits& limits, const RunKey& run, std::string precision);

  [[nodiscard]] const Limit* limit(std::string_view metric) const;
  [[nodiscard]] const KnownDeviation* known(std::string_view metric) const;
  [[nodiscard]] const Unjudged* unjudged() const;

 private:
  template <class Entry, class Fits>
  [[nodiscard]] const Entry* last(const std::vector<Entry>& entries, const Fits& fits) const;

  const Limits& limits_;
  const RunKey& run_;
  std::string precision_;
};

}  // namespace tautline::bench
