#include "bench/gate/limits_on_run.hpp"

#include <algorithm>
#include <utility>

namespace tautline::bench {

LimitsOnRun::LimitsOnRun(const Limits& limits, const RunKey& run, std::string precision)
    : limits_(limits), run_(run), precision_(std::move(precision)) {}

template <class Entry, class Fits>
const Entry* LimitsOnRun::last(const std::vector<Entry>& entries, const Fits& fits) const {
  const auto found = std::find_if(entries.rbegin(), entries.rend(), [&](const Entry& entry) {
    return fits(entry) && entry.runs.holds(run_, precision_);
  });
  return found != entries.rend() ? &*found : nullptr;
}

const Limit* LimitsOnRun::limit(std::string_view metric) const {
  return last(limits_.limits, [&](const Limit& limit) { return limit.metric == metric; });
}

const KnownDeviation* LimitsOnRun::known(std::string_view metric) const {
  return last(limits_.known, [&](const KnownDeviation& known) { return is_about(known, metric); });
}

const Unjudged* LimitsOnRun::unjudged() const {
  return last(limits_.unjudged, [](const Unjudged&) { return true; });
}

}  // namespace tautline::bench
