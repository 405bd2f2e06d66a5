#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/judge/judgement.hpp"

namespace tautline::bench {

/// How a model follows the exact motions as its step falls.
enum class Course {
  exact,      // exact to its events: at every step its error is a part of what a step explains
  as_good,    // as good as a step-by-step model can be
  converges,  // more than a plain scheme's error, and in proportion to it
  does_not_converge,  // the error falls more slowly than the error of a plain scheme
  off,                // more than a plain scheme's error, at the only step that tells
  untold,             // no run could be judged by its position
};

/// The audit and the judgement of a run.
struct JudgedRun : AuditedRun {
  const Judgement* judgement = nullptr;
};

/// A model over all cases, at the finest step that it was run with.
struct ModelJudgement {
  std::string engine;
  std::string model;
  double step = 0.0;               // [s]
  std::size_t cases = 0;           //
  Rebounds rebounds;               // over all cases
  Course course = Course::untold;  // the worst of all cases
  std::size_t told = 0;            // cases in which the position tells something
  std::optional<double> ratio;     // [-], Following::ratio at worst
  std::string worst_case;          // of that
  double error = 0.0;              // [m], there
  double time = 0.0;               // [s], then
  Expected impacts;                // of all cases
  double overstretch = 0.0;        // [-], at worst
  double energy = 0.0;             // [-], at worst
  double flight = 0.0;             // [-], at worst
  std::optional<double> rotation;  // [-], at worst
};

/// Every model, in the order of its first run.
[[nodiscard]] std::vector<ModelJudgement> models_of(const std::vector<JudgedRun>& runs);

/// The findings that the rebounds of the models are, in addition to the findings of the audit: at
/// the finest step.
[[nodiscard]] std::vector<Finding> rebound_findings(const std::vector<ModelJudgement>& models,
                                                    const std::vector<JudgedRun>& runs);

/// How the error of one case changes with the step: `ratios` of Following::ratio at `steps` [s],
/// which fall.
[[nodiscard]] Course course_of(const std::vector<double>& steps, const std::vector<double>& ratios);

// The words, everywhere the same.

[[nodiscard]] const char* to_string(Rebound word);     // "kept", "lost below", ...: in files
[[nodiscard]] const char* to_string(Course word);      // "exact", "as good", ...: in files
[[nodiscard]] const char* to_string(Barrier barrier);  // "end", "effort", "growth", "fork"

/// "kept (4 impacts, from 0.34 m/s on)", "0.15 too high (5 impacts)", "none: stays taut after 2.96
/// m/s", "lost below 0.09 m/s (3 of 52 impacts)", "too few to tell (1 impact)".
[[nodiscard]] std::string words_of(const Rebounds& rebounds);

/// "accelerates wrong in flight, by 1 %", of Judgement::flight.
[[nodiscard]] std::string flight_text(double flight);
/// "turns wrong in flight, 20 times what a step explains", of Judgement::rotation.
[[nodiscard]] std::string rotation_text(double rotation);

/// "exact to its events", "as good as a step-by-step model can be", "converges, with 8 times the
/// error of a plain scheme", ...
[[nodiscard]] std::string words_of(Course course, const std::optional<double>& ratio);

}  // namespace tautline::bench
