// What one run says of restitution: its impacts against what a step can do to them, its ladder of
// bounces and its scatter.

#include "bench/measure/audit/impacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/report/replay_data.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// An impact counts where what a step does to its rates is at most this part of them [-].
constexpr double readable = 0.1;

double norm(const ordered_json& pair) {
  return std::hypot(pair.at(0).get<double>(), pair.at(1).get<double>());
}

double shortest_cable(const ordered_json& the_case) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const ordered_json& cable : the_case.at("geometry")) {
    shortest = std::min(shortest, cable.at("length").get<double>());
  }
  return shortest;
}

/// The largest kinetic energy of the exact motion at its samples [J].
double largest_kinetic_energy(const ordered_json& the_case) {
  const ordered_json& path = the_case.at("path");
  const double mass = the_case.at("body").at("mass");
  const ordered_json& g = the_case.at("gravity");
  double largest = 0.0;
  for (std::size_t i = 0; i < path.at("time").size(); ++i) {
    const double fall = g.at(0).get<double>() * path.at("x").at(i).get<double>() +
                        g.at(1).get<double>() * path.at("y").at(i).get<double>();
    largest = std::max(largest, path.at("energy").at(i).get<double>() + mass * fall);
  }
  return largest;
}

/// The size of accelerations in the exact motion [m/s^2]: gravity and turning on a cable. A rate
/// that is read a step early or late is off by a step of it.
double acceleration(const ordered_json& the_case) {
  const double mass = the_case.at("body").at("mass");
  return norm(the_case.at("gravity")) +
         2.0 * largest_kinetic_energy(the_case) / mass / shortest_cable(the_case);
}

/// The `index`-th entry of a column; NaN where it is null.
double entry(const ordered_json& columns, const char* name, std::size_t index) {
  const ordered_json& value = columns.at(name).at(index);
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// True where no other impact of the run is at the same time: those share one velocity jump.
bool alone(const ordered_json& times, std::size_t index) {
  return (index == 0 || times.at(index - 1) != times.at(index)) &&
         (index + 1 == times.size() || times.at(index + 1) != times.at(index));
}

/// `momentum` less what a step explains, as a part of `impulse`.
double excess(double momentum, double explained, double impulse) {
  return std::max(0.0, std::abs(momentum) - explained) / impulse;
}

/// True where the exact motion stays on one line through the only cable's anchor, and so do its
/// bounces: the body falls back as high as it rose.
bool bounces_straight(const ordered_json& the_case) {
  constexpr double straight = 1e-6;  // [-], of the length: the digits of the path
  if (the_case.at("geometry").size() != 1) {
    return false;
  }
  const ordered_json& cable = the_case.at("geometry").front();
  const ordered_json& g = the_case.at("gravity");
  const ordered_json& path = the_case.at("path");
  const double allowed = straight * cable.at("length").get<double>();
  if (norm(cable.at("attachment")) > allowed || norm(g) == 0.0) {
    return false;
  }
  for (std::size_t i = 0; i < path.at("time").size(); ++i) {
    const double x = path.at("x").at(i).get<double>() - cable.at("anchor").at(0).get<double>();
    const double y = path.at("y").at(i).get<double>() - cable.at("anchor").at(1).get<double>();
    const double aside = x * g.at(1).get<double>() - y * g.at(0).get<double>();
    if (std::abs(aside) > allowed * norm(g)) {
      return false;
    }
  }
  return true;
}

ordered_json ladder(const ordered_json& run, const ordered_json& the_case) {
  const ordered_json& impacts = run.at("impacts");
  const ordered_json& requested = the_case.at("geometry").front().at("restitution");
  if (!bounces_straight(the_case) || impacts.at("time").empty() || requested.is_null() ||
      impacts.at("left_out") != 0) {
    return nullptr;
  }
  const double e = requested.get<double>();
  const double fall = entry(impacts, "rate_before", 0);
  ordered_json heights = ordered_json::array();
  ordered_json exact = ordered_json::array();
  double ratio = 1.0;
  for (std::size_t i = 0; i < impacts.at("time").size(); ++i) {
    const double rebound = entry(impacts, "rate_after", i) / fall;
    ratio *= e * e;
    if (!std::isfinite(rebound)) {
      break;
    }
    heights.push_back(rounded(rebound * rebound));  // v^2 = 2 g h
    exact.push_back(rounded(ratio));
  }
  return {{"cable", 0}, {"exact_ratio", e * e}, {"heights", heights}, {"exact", exact}};
}

ordered_json scatter(const std::vector<AuditedImpact>& impacts) {
  if (impacts.empty()) {
    return nullptr;
  }
  double sum = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -smallest;
  for (const AuditedImpact& impact : impacts) {
    sum += impact.deviation();
    smallest = std::min(smallest, impact.deviation());
    largest = std::max(largest, impact.deviation());
  }
  const double mean = sum / static_cast<double>(impacts.size());
  double squares = 0.0;
  for (const AuditedImpact& impact : impacts) {
    squares += (impact.deviation() - mean) * (impact.deviation() - mean);
  }
  return {{"count", impacts.size()},
          {"mean", rounded(mean)},
          {"standard_deviation", rounded(std::sqrt(squares / static_cast<double>(impacts.size())))},
          {"smallest", rounded(smallest)},
          {"largest", rounded(largest)}};
}

}  // namespace

std::vector<AuditedImpact> audited_impacts(const ordered_json& run, const ordered_json& the_case) {
  const ordered_json& impacts = run.at("impacts");
  const ordered_json& times = impacts.at("time");
  const ordered_json& lock = the_case.at("settling").at("lock");
  const double end =
      lock.is_null() ? the_case.at("end_time").get<double>() : lock.at("time").get<double>();
  const double mass = the_case.at("body").at("mass");
  const double inertia = the_case.at("body").at("inertia");
  const double gyration = std::sqrt(inertia / mass);  // [m]
  const double floor = acceleration(the_case) * run.at("step").get<double>();
  std::vector<AuditedImpact> result;
  for (std::size_t i = 0; i < times.size(); ++i) {
    AuditedImpact impact{};
    impact.speed = -entry(impacts, "rate_before", i);
    impact.requested = entry(impacts, "requested", i);
    impact.effective = entry(impacts, "rate_after", i) / impact.speed;
    impact.arm = entry(impacts, "arm", i);
    impact.rate_floor = floor;
    impact.steps = impacts.at("steps").at(i);
    if (entry(impacts, "time", i) > end || !alone(times, i) ||
        !std::isfinite(impact.effective * impact.requested) || floor > readable * impact.speed) {
      continue;
    }
    const double inverse = 1.0 / mass + (inertia > 0.0 ? impact.arm * impact.arm / inertia : 0.0);
    const double impulse = impact.speed * (1.0 + std::abs(impact.effective)) / inverse;
    const double steps = std::max<double>(1.0, static_cast<double>(impact.steps));
    const double explained = mass * floor * steps;
    impact.across = excess(entry(impacts, "tangential_error", i), explained, impulse);
    impact.turning = gyration > 0.0
                         ? excess(entry(impacts, "angular_error", i) / gyration, explained, impulse)
                         : 0.0;
    result.push_back(impact);
  }
  return result;
}

ordered_json run_audit(const ordered_json& run, const ordered_json& the_case) {
  return {{"ladder", ladder(run, the_case)}, {"scatter", scatter(audited_impacts(run, the_case))}};
}

double quantile(std::vector<double> values, double part) {
  const auto place = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

}  // namespace tautline::bench
