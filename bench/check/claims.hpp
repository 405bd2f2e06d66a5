#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/check/subject.hpp"

namespace tautline::bench {

// What every model of every engine should keep, each as a number with a limit. `tautline check`
// asks for limits that a sound engine with fixed steps can meet; the tests of the engines here ask
// the same measures for rounding.

/// What was measured for a claim.
struct Measure {
  double found;          // the smaller the better; not a number where nothing could be measured
  double limit;          // that a sound engine can meet
  std::string sentence;  // what was found; beyond the limit, what seems to be wrong
};

/// One thing that is claimed of a model.
struct Claim {
  std::string_view name;      // [a-z-]+
  std::string_view sentence;  // what is claimed
  std::string_view reason;    // why the limit is what it is
  Measure (*measure)(const Subject& subject);
};

/// All claims, in the order in which a reader wants them: one that fails may break those after it.
[[nodiscard]] std::span<const Claim> claims();

/// The claim of this name, or null.
[[nodiscard]] const Claim* find_claim(std::string_view name);

/// A claim about one model, settled.
struct Finding {
  std::string claim;
  double found = 0.0;
  double limit = 0.0;
  bool holds = false;
  std::string sentence;
};

/// Measures every claim for `model` of `engine`, which has it; what the engine throws becomes a
/// finding. `progress` is called before each claim with its name and what was found so far.
using CheckProgress = std::function<void(std::string_view, const std::vector<Finding>&)>;
[[nodiscard]] std::vector<Finding> check_model(const Engine& engine, const std::string& model,
                                               const CheckProgress& progress);

/// The finding for a claim that could not be measured, and why.
[[nodiscard]] Finding unmeasured(std::string_view claim, const std::string& why);

/// The finding of the claim `quiet`, which only the process around the engine can tell: `printed`
/// [bytes], and the last of it.
[[nodiscard]] Finding quiet(std::size_t printed, const std::string& tail);
inline constexpr std::string_view quiet_sentence = "the engine does not print at every step";
inline constexpr std::string_view quiet_reason = "a greeting at each of the runs of a check";

[[nodiscard]] nlohmann::ordered_json findings_json(const std::vector<Finding>& findings);
[[nodiscard]] std::vector<Finding> findings_from(const nlohmann::ordered_json& json);

// The measures, by what they look at. Lengths in [m], times in [s]; see `claims` for what each is.
[[nodiscard]] Measure measure_state_echo(const Subject& subject);
[[nodiscard]] Measure measure_precision(const Subject& subject);
[[nodiscard]] Measure measure_flight(const Subject& subject);
[[nodiscard]] Measure measure_mass(const Subject& subject);
[[nodiscard]] Measure measure_inertia(const Subject& subject);
[[nodiscard]] Measure measure_arm(const Subject& subject);
[[nodiscard]] Measure measure_angular_momentum(const Subject& subject);
[[nodiscard]] Measure measure_step_momentum(const Subject& subject);
[[nodiscard]] Measure measure_central_restitution(const Subject& subject);
[[nodiscard]] Measure measure_off_centre_restitution(const Subject& subject);
[[nodiscard]] Measure measure_slow_restitution(const Subject& subject);
[[nodiscard]] Measure measure_energy(const Subject& subject);
[[nodiscard]] Measure measure_overstretch(const Subject& subject);
[[nodiscard]] Measure measure_taut_growth(const Subject& subject);
[[nodiscard]] Measure measure_mirror_symmetry(const Subject& subject);
[[nodiscard]] Measure measure_determinism(const Subject& subject);
[[nodiscard]] Measure measure_convergence(const Subject& subject);

/// How far a model is from the exact motion of the standard breakwater with e = 0.9 in two seconds.
struct Convergence {
  std::vector<double> steps;       // [s]
  std::vector<double> deviations;  // [m], the largest distance of the centre of mass
  double slope = 0.0;              // of log(deviation) over log(step)
  bool exact = false;              // at every step: only rounding is left, and no slope
};
[[nodiscard]] Convergence convergence(const Subject& subject);

/// A digest of the run of `determinism`: any two runs of a deterministic model have the same, in
/// whatever process. Throws what the engine throws.
[[nodiscard]] std::string run_digest(const Engine& engine, const std::string& model);

/// A contact that an engine spreads over time may take this many steps: as many as a spring needs
/// to be stable and to give back its restitution within a few hundredths.
inline constexpr int longest_contact = 20;

/// One cable through an attachment of a spinning body, slack for the first `slack` metres.
[[nodiscard]] Case spinning_on_one_cable(double slack);

}  // namespace tautline::bench
