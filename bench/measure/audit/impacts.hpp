#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tautline::bench {

/// An impact of a run as the audit sees it.
struct AuditedImpact {
  double speed;       // [m/s], > 0, at which the cable closed
  double requested;   // [-], the cable's restitution at that speed
  double effective;   // [-], what came back
  double arm;         // [m]
  double across;      // [-], unexplained momentum across the cable, as part of the impulse
  double turning;     // [-], unexplained spin, as part of the impulse at the radius of gyration
  double rate_floor;  // [m/s], what a step does to rates: less says nothing
  std::size_t steps;  // with an impulse; 0 if located

  /// Effective less requested restitution.
  [[nodiscard]] double deviation() const { return effective - requested; }
  /// The same as a rate, in units of what a step does.
  [[nodiscard]] double floors() const { return deviation() * speed / rate_floor; }
};

/// A run that freezes: the body stops in one go where the exact motion swings on.
struct Freeze {
  std::string case_name;
  double moving;  // [s], of the last sample before
  double time;    // [s], of the first sample from which on nothing moves
  double lost;    // [J], of energy between the two
};

/// All runs of one model.
struct AuditedModel {
  std::string engine;
  std::string model;
  std::size_t runs = 0;
  std::vector<AuditedImpact> impacts;
  std::vector<Freeze> freezes;
};

/// What a model does to impacts: a "finding" of bench/report/report.schema.json.
struct AuditFinding {
  std::string kind;
  std::string sentence;
  std::optional<double> value;
  std::string unit;
  std::size_t runs = 0;
  std::size_t impacts = 0;
};

/// The impacts of `run`, a row of a report, that say something of restitution: those of one cable
/// alone, up to the lock of the exact motion of `the_case`, the row of its case, and fast enough
/// for the run's step.
[[nodiscard]] std::vector<AuditedImpact> audited_impacts(const nlohmann::ordered_json& run,
                                                         const nlohmann::ordered_json& the_case);

/// "audit" of `run`: bounce ladder and scatter.
[[nodiscard]] nlohmann::ordered_json run_audit(const nlohmann::ordered_json& run,
                                               const nlohmann::ordered_json& the_case);

/// Whether and when `run` freezes.
[[nodiscard]] std::optional<Freeze> freeze_of(const nlohmann::ordered_json& run,
                                              const nlohmann::ordered_json& the_case);

/// The `part` (0 to 1) of `values`, which are not empty.
[[nodiscard]] double quantile(std::vector<double> values, double part);

/// Restitution that is ignored, cut off, spread, too large or too small; impacts of several steps.
[[nodiscard]] std::vector<AuditFinding> restitution_findings(const AuditedModel& model);

/// Impulses that do not point along the cable, or turn the body by other than their arm.
[[nodiscard]] std::vector<AuditFinding> impulse_findings(const AuditedModel& model);

/// Bodies put to sleep.
[[nodiscard]] std::vector<AuditFinding> sleep_findings(const AuditedModel& model);

}  // namespace tautline::bench
