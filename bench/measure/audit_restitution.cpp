// What a model makes of restitution, from the impacts of all its runs. Each question leaves aside
// what the one before has explained: what is cut off does not spread.

#include "bench/base/listed.hpp"
#include "bench/measure/audit_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bench/base/statistics.hpp"
#include "bench/measure/audit_lost.hpp"

namespace tautline::bench {
namespace {

using Impacts = std::vector<AuditedImpact>;

/// Fewer impacts say nothing of a model: of those that speak for a finding, and of all.
constexpr std::size_t least_on_a_side = 3;
constexpr std::size_t least_for_restitution = 8;

/// So many impacts of a group may say otherwise [-].
constexpr double contrary = 0.1;

/// In units of what a step does to a rate: the spread of the middle 90 % that no sampling explains
/// (of exact motions that are only sampled: at most 1.5), and the median of an offset.
constexpr double wide = 2.5;
constexpr double far_off = 3.0;

/// An offset of e below this is none, and so is a standard deviation, however small the step [-].
constexpr double least_offset = 0.01;
constexpr double least_scatter = 0.01;

bool lost(const AuditedImpact& impact) { return impact.effective < lost_part * impact.requested; }
bool bounced(const AuditedImpact& impact) { return !lost(impact); }

Impacts those(const Impacts& impacts, const std::function<bool(const AuditedImpact&)>& wanted) {
  Impacts result;
  std::copy_if(impacts.begin(), impacts.end(), std::back_inserter(result), wanted);
  return result;
}

std::vector<double> values(const Impacts& impacts,
                           const std::function<double(const AuditedImpact&)>& value) {
  return listed(impacts, value);
}

/// How many of the impacts are `wanted`, as a part of 1.
double share(const Impacts& impacts, const std::function<bool(const AuditedImpact&)>& wanted) {
  return static_cast<double>(std::count_if(impacts.begin(), impacts.end(), wanted)) /
         static_cast<double>(impacts.size());
}

double deviation_of(const AuditedImpact& impact) { return impact.deviation(); }
double effective_of(const AuditedImpact& impact) { return impact.effective; }
double requested_of(const AuditedImpact& impact) { return impact.requested; }
double floors_of(const AuditedImpact& impact) { return impact.floors(); }

/// "0.9" or "0.5 to 1".
std::string range_text(const std::vector<double>& numbers) {
  const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  return *least == *most ? fmt::format("{:.3g}", *least)
                         : fmt::format("{:.3g} to {:.3g}", *least, *most);
}

/// What `impacts` of `model` show, and the runs with one that is as wrong as it says.
Finding from(const AuditedModel& model, const Impacts& impacts, const std::string& kind,
             double value, const std::string& sentence,
             const std::function<bool(const AuditedImpact&)>& shows) {
  Finding finding = finding_of(model, kind);
  finding.sentence = sentence;
  finding.value = value;
  finding.impacts = impacts.size();
  finding.shown_in = runs_with(model, shows);
  return finding;
}

bool asks(const AuditedImpact& impact) { return impact.requested >= asking; }

/// It shows in every run that asks for a rebound at all.
Finding ignored(const AuditedModel& model, const Impacts& asked, double e) {
  return from(model, asked, "restitution-ignored", e,
              fmt::format("restitution is ignored: the median e is {:.2g} where {} is requested", e,
                          range_text(values(asked, requested_of))),
              asks);
}

/// Effective restitutions this near are the same, and requested ones this far apart are not [-].
constexpr double alike = 0.05;
constexpr double different = 0.2;

/// Everything comes back with one restitution, whatever is requested.
std::optional<Finding> constant(const AuditedModel& model, const Impacts& asked) {
  if (asked.size() < least_for_restitution) {
    return std::nullopt;
  }
  const double middle = quantile(values(asked, effective_of), 0.5);
  const auto requested = values(asked, requested_of);
  const auto [least, most] = std::minmax_element(requested.begin(), requested.end());
  const double same = share(asked, [&](const AuditedImpact& impact) {
    return std::abs(impact.effective - middle) < alike;
  });
  const double wrong = share(
      asked, [](const AuditedImpact& impact) { return std::abs(impact.deviation()) > alike; });
  if (*most - *least < different || middle < alike || same < 1.0 - contrary || wrong < contrary) {
    return std::nullopt;
  }
  return ignored(model, asked, middle);
}

/// Nothing rebounds.
std::optional<Finding> nothing_rebounds(const AuditedModel& model, const Impacts& asked) {
  if (asked.size() < least_on_a_side || share(asked, lost) < 1.0 - contrary) {
    return std::nullopt;
  }
  const double middle = quantile(values(asked, effective_of), 0.5);
  return ignored(model, asked, std::abs(middle) < 0.5 * alike ? 0.0 : middle);
}

/// The place in `sorted`, in rising speed, that best parts lost impacts below from kept ones above.
std::size_t best_cut(const Impacts& sorted) {
  auto wrong = static_cast<std::ptrdiff_t>(std::count_if(sorted.begin(), sorted.end(), lost));
  std::ptrdiff_t fewest = wrong;
  std::size_t best = 0;
  for (std::size_t index = 0; index < sorted.size(); ++index) {
    wrong += lost(sorted[index]) ? -1 : 1;
    if (wrong < fewest) {
      fewest = wrong;
      best = index + 1;
    }
  }
  return best;
}

/// A speed below which nothing rebounds.
std::optional<Finding> threshold(const AuditedModel& model, Impacts asked) {
  std::sort(asked.begin(), asked.end(),
            [](const AuditedImpact& a, const AuditedImpact& b) { return a.speed < b.speed; });
  const std::size_t cut = best_cut(asked);
  const auto place = asked.begin() + static_cast<std::ptrdiff_t>(cut);
  const Impacts below(asked.begin(), place);
  const Impacts above(place, asked.end());
  if (below.size() < least_on_a_side || above.size() < least_on_a_side ||
      share(below, lost) < 1.0 - contrary || share(above, lost) > contrary) {
    return std::nullopt;
  }
  const double slower = below.back().speed;
  const double faster = above.front().speed;
  const double value = 0.5 * (slower + faster);
  Finding finding =
      from(model, asked, "threshold", value,
           fmt::format("bounces slower than {:.2g} m/s are lost: {} of {} impacts up to {:.3g} m/s "
                       "come back with less than half of the requested e (their median e is "
                       "{:.2g}), {} of {} from {:.3g} m/s on with more",
                       value, std::count_if(below.begin(), below.end(), lost), below.size(), slower,
                       quantile(values(below, effective_of), 0.5),
                       std::count_if(above.begin(), above.end(), std::not_fn(lost)), above.size(),
                       faster),
           [&](const AuditedImpact& impact) {
             return asks(impact) && lost(impact) && impact.speed <= slower;
           });
  finding.unit = "m/s";
  return finding;
}

/// True where an offset by `middle` is no chance: it is far larger than what a step does, or than
/// what it varies by.
bool sure(const Impacts& bounces, const std::vector<double>& deviations, double middle) {
  return std::abs(quantile(values(bounces, floors_of), 0.5)) >= far_off ||
         quantile(deviations, 0.95) - quantile(deviations, 0.05) < std::abs(middle);
}

/// Rebounds that are too fast or too slow, one like the other.
std::optional<Finding> offset(const AuditedModel& model, const Impacts& bounces) {
  const auto deviations = values(bounces, deviation_of);
  const double middle = quantile(deviations, 0.5);
  const double one_side = quantile(deviations, middle > 0.0 ? 0.25 : 0.75);
  if (std::abs(middle) < least_offset || middle * one_side <= 0.0 ||
      !sure(bounces, deviations, middle)) {
    return std::nullopt;
  }
  const double outer = quantile(deviations, middle > 0.0 ? 0.95 : 0.05);
  return from(
      model, bounces, middle > 0.0 ? "gain" : "offset", middle,
      fmt::format("rebounds are too {0}: e is {1} the requested one by {2:.2g} in the median, "
                  "and by {3:.2g} or more in 5 % of the impacts",
                  middle > 0.0 ? "fast" : "slow", middle > 0.0 ? "above" : "below",
                  std::abs(middle), std::abs(outer)),
      [&](const AuditedImpact& impact) { return impact.deviation() / middle >= 0.5; });
}

/// The width of the middle 90 % of errors of e less `offset`, in units of what a step does.
double width(const Impacts& bounces, double offset) {
  const auto floors = values(bounces, [offset](const AuditedImpact& impact) {
    return (impact.deviation() - offset) * impact.speed / impact.rate_floor;
  });
  return quantile(floors, 0.95) - quantile(floors, 0.05);
}

/// Restitution that spreads by more than sampling explains, and not only as one error of e does
/// that is the same at all speeds: in units of a step that grows with the speed.
std::optional<Finding> spread(const AuditedModel& model, const Impacts& bounces) {
  const auto deviations = values(bounces, deviation_of);
  if (std::min(width(bounces, 0.0), width(bounces, quantile(deviations, 0.5))) < wide) {
    return std::nullopt;
  }
  double sum = 0.0;
  double squares = 0.0;
  for (const double deviation : deviations) {
    sum += deviation;
    squares += deviation * deviation;
  }
  const double mean = sum / static_cast<double>(deviations.size());
  const double sd = std::sqrt(squares / static_cast<double>(deviations.size()) - mean * mean);
  if (sd < least_scatter) {
    return std::nullopt;
  }
  const auto [least, most] = std::minmax_element(deviations.begin(), deviations.end());
  return from(
      model, bounces, "scatter", sd,
      fmt::format("e scatters about the requested one: it is off by {:+.2g} in the mean, "
                  "by {:+.2g} to {:+.2g} in single impacts, and its standard deviation is "
                  "{:.2g}",
                  mean, *least, *most, sd),
      [&](const AuditedImpact& impact) { return std::abs(impact.deviation() - mean) >= sd; });
}

/// Rebounds that take several steps.
std::optional<Finding> several_steps(const AuditedModel& model, const Impacts& bounces) {
  const Impacts longer =
      those(bounces, [](const AuditedImpact& impact) { return impact.steps > 1; });
  if (2 * longer.size() < bounces.size()) {
    return std::nullopt;
  }
  const auto steps =
      values(longer, [](const AuditedImpact& impact) { return static_cast<double>(impact.steps); });
  const double middle = quantile(steps, 0.5);
  Finding finding =
      from(model, bounces, "several-steps", middle,
           fmt::format("an impact takes {:.0f} steps in the median and {:.0f} at most", middle,
                       quantile(steps, 1.0)),
           [](const AuditedImpact& impact) { return impact.steps > 1; });
  finding.unit = "steps";
  return finding;
}

}  // namespace

std::vector<Finding> restitution_findings(const AuditedModel& model) {
  std::vector<Finding> findings;
  const auto note = [&](std::optional<Finding> finding) {
    if (finding) {
      findings.push_back(std::move(*finding));
    }
    return finding.has_value();
  };
  const Impacts asked = those(model.impacts, asks);
  if (note(constant(model, asked))) {
    return findings;
  }
  double slowest = 0.0;  // [m/s], that is not cut off
  if (note(threshold(model, asked))) {
    slowest = *findings.back().value;
  } else if (note(nothing_rebounds(model, asked))) {
    return findings;
  }
  const Impacts fast =
      those(model.impacts, [&](const AuditedImpact& impact) { return impact.speed >= slowest; });
  if (fast.size() >= least_for_restitution && !note(offset(model, fast))) {
    note(spread(model, fast));
  }
  const Impacts bounces = those(asked, bounced);
  if (bounces.size() >= least_for_restitution) {
    note(several_steps(model, bounces));
  }
  return findings;
}

}  // namespace tautline::bench
