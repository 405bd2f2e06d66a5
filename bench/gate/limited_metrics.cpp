// Which numbers of a run a limit can be set on, and how they are read out of its row.

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/gate/limits.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The number at `path` below a run's metrics; none where something on the way is null.
std::optional<double> number(const ordered_json& run, const char* path) {
  const ordered_json& metrics = run.at("metrics");
  const ordered_json::json_pointer place(path);
  if (!metrics.is_object() || !metrics.contains(place) || !metrics.at(place).is_number()) {
    return std::nullopt;
  }
  return metrics.at(place).get<double>();
}

std::optional<double> missed_share(const ordered_json& run) {
  const auto exact = number(run, "/horizon/impacts/exact");
  const auto missed = number(run, "/horizon/impacts/missed");
  return exact && missed && *exact > 0.0 ? std::optional(*missed / *exact) : std::nullopt;
}

constexpr std::array metrics = {
    LimitedMetric{"early_position_error", "m",
                  "Largest distance from the exact position up to the first few impacts.",
                  [](const ordered_json& run) { return number(run, "/early/position_error"); }},
    LimitedMetric{"early_angle_error", "rad",
                  "Largest distance from the exact angle up to the first few impacts.",
                  [](const ordered_json& run) { return number(run, "/early/angle_error"); }},
    LimitedMetric{"horizon_position_error", "m",
                  "Largest distance from the exact position up to the predictability horizon.",
                  [](const ordered_json& run) { return number(run, "/horizon/position_error"); }},
    LimitedMetric{
        "first_impact_error", "s", "How far the first impact is off in time.",
        [](const ordered_json& run) { return number(run, "/horizon/impacts/first_time_error"); }},
    LimitedMetric{"missed_impacts", "1",
                  "Share of the exact impacts up to the horizon that the run has no match for.",
                  missed_share},
    LimitedMetric{"restitution_error", "1",
                  "Largest distance of a measured restitution from the cable's own.",
                  [](const ordered_json& run) { return number(run, "/restitution/worst_error"); }},
    LimitedMetric{"overstretch", "m", "Largest length of a cable beyond its own.",
                  [](const ordered_json& run) { return number(run, "/overstretch"); }},
    LimitedMetric{"energy_gain", "J", "Largest rise of the energy above the start.",
                  [](const ordered_json& run) { return number(run, "/energy/largest_gain"); }}};

/// Patterns have * and ? alone: what else is special for fnmatch stands for itself.
bool matches(const std::string& pattern, const std::string& name) {
  std::string escaped;
  for (const char letter : pattern) {
    if (letter == '[' || letter == ']' || letter == '\\') {
      escaped += '\\';
    }
    escaped += letter;
  }
  return ::fnmatch(escaped.c_str(), name.c_str(), 0) == 0;
}

/// Steps this near are the same: 0.001 from a file and from a command line. [-]
constexpr double same_step = 1e-9;

}  // namespace

std::span<const LimitedMetric> limited_metrics() { return metrics; }

bool RunPattern::holds(const ordered_json& run, const std::string& precision_of_run) const {
  const double its_step = run.at("step");
  return matches(engine, run.at("engine")) && matches(model, run.at("model")) &&
         matches(the_case, run.at("case")) && matches(precision, precision_of_run) &&
         (!step || std::abs(*step - its_step) <= same_step * its_step);
}

}  // namespace tautline::bench
