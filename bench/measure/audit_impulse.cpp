// A cable pulls along itself and turns the body by its lever arm. What else an impact changes is
// the engine's own.

#include "bench/base/listed.hpp"
#include "bench/measure/audit_parts.hpp"

#include <fmt/format.h>

#include <functional>

#include "bench/base/statistics.hpp"
#include "bench/measure/audit_lost.hpp"

namespace tautline::bench {
namespace {

/// Fewer impacts say nothing of a model.
constexpr std::size_t least_impacts = 8;

/// A model is told of where more than half of its impacts have more of this in them [-].
constexpr double notable = 0.05;

std::optional<Finding> unexplained(const AuditedModel& model, const std::string& kind,
                                   const std::string& sentence,
                                   const std::function<double(const AuditedImpact&)>& part) {
  const std::vector<double> parts = listed(model.impacts, part);
  if (parts.size() < least_impacts || quantile(parts, 0.5) < notable) {
    return std::nullopt;
  }
  const double middle = quantile(parts, 0.5);
  Finding finding = finding_of(model, kind);
  finding.sentence = fmt::format(
      "{} {:.2g} of the impulse in the median, and {:.2g} or more in 5 % of the impacts", sentence,
      middle, quantile(parts, 0.95));
  finding.value = middle;
  finding.shown_in =
      runs_with(model, [&](const AuditedImpact& impact) { return part(impact) >= notable; });
  return finding;
}

/// Rebounds that take several steps.
std::optional<Finding> several_steps(const AuditedModel& model) {
  std::vector<double> steps;  // of impacts that ask for a rebound and get one
  std::size_t bounces = 0;
  for (const AuditedImpact& impact : model.impacts) {
    const bool bounced = impact.effective >= lost_part * impact.requested;
    if (impact.requested >= asking && bounced) {
      ++bounces;
      if (impact.steps > 1) {
        steps.push_back(static_cast<double>(impact.steps));
      }
    }
  }
  if (bounces < least_impacts || 2 * steps.size() < bounces) {
    return std::nullopt;
  }
  const double middle = quantile(steps, 0.5);
  Finding finding = finding_of(model, "several-steps");
  finding.sentence = fmt::format("an impact takes {:.0f} steps in the median and {:.0f} at most",
                                 middle, quantile(steps, 1.0));
  finding.value = middle;
  finding.unit = "steps";
  finding.impacts = bounces;
  finding.shown_in = runs_with(model, [](const AuditedImpact& impact) { return impact.steps > 1; });
  return finding;
}

}  // namespace

std::vector<Finding> impulse_findings(const AuditedModel& model) {
  std::vector<Finding> findings;
  if (auto across =
          unexplained(model, "tangential-impulse", "impacts push the body across the cable, by",
                      [](const AuditedImpact& impact) { return impact.across; })) {
    findings.push_back(std::move(*across));
  }
  if (auto turning =
          unexplained(model, "angular-impulse",
                      "impacts turn the body by more or less than impulse times lever arm does: at "
                      "the radius of gyration the difference is",
                      [](const AuditedImpact& impact) { return impact.turning; })) {
    findings.push_back(std::move(*turning));
  }
  if (auto steps = several_steps(model)) {
    findings.push_back(std::move(*steps));
  }
  return findings;
}

}  // namespace tautline::bench
