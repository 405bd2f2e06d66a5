#include "bench/solution/solution_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tautline/geometry.hpp"
#include "tautline/ledger.hpp"

namespace tautline::bench {
namespace {

/// What an ending means, in a sentence.
std::string ending_sentence(const Case& the_case, const Solution& solution) {
  const double end = solution.end_time();
  switch (solution.ending()) {
    case Ending::reached_duration:
      return fmt::format("The run reached its duration, t = {}.", end);
    case Ending::rest:
      if (solution.arcs().back().initial.spin != 0.0) {  // exactly
        return fmt::format(
            "The body hangs still at its centre from t = {:.9f} on, to its duration, t = {}, and "
            "turns steadily.",
            solution.arcs().back().start, end);
      }
      return fmt::format("The body is at rest from t = {:.9f} on, to its duration, t = {}.",
                         solution.arcs().back().start, end);
    case Ending::unstable_rest:
      return fmt::format(
          "The body stands still from t = {:.9f} on, to its duration, t = {}, at an unstable "
          "equilibrium: the smallest push would end it.",
          solution.arcs().back().start, end);
    case Ending::singular:
      return fmt::format(
          "Stopped at t = {:.9f}: the touching cables come so near to one line there that their "
          "tensions or impulses cannot be told.",
          end);
    case Ending::angle_limit:
      return fmt::format("|angle| reached the limit {} at t = {:.9f}.", *the_case.angle_limit, end);
    case Ending::ceiling:
      return fmt::format("An attachment reached the ceiling {} at t = {:.9f}.", *the_case.ceiling,
                         end);
    case Ending::event_limit:
      return fmt::format("Stopped at t = {:.9f}: the limit of {} events is reached.", end,
                         solution.events().size());
    case Ending::step_limit:
      return fmt::format(
          "Stopped at t = {:.9f}: the limit of steps of taut motion is reached; the body turns or "
          "swings too often until t = {}.",
          end, the_case.duration);
    case Ending::no_progress:
      return fmt::format(
          "Stopped at t = {:.9f}: event follows event there, and time does not advance.", end);
    case Ending::overflow:
      return fmt::format(
          "Stopped at t = {:.9f}: past it the motion has numbers too large for a double.", end);
  }
  return "";
}

std::string last_impacts_sentence(const Settling& settling) {
  std::string result;
  for (const LastImpact& last : settling.last_impacts) {
    result += fmt::format("{} faster than {:g}: {}", result.empty() ? "Last impact" : ";",
                          last.speed, last.time ? fmt::format("t = {:.6f}", *last.time) : "none");
  }
  return result + ".";
}

/// When the final set of cables became taut, and whether they stay so.
std::string lock_sentence(const Case& the_case, const Lock& lock) {
  const std::string error =
      lock.uncertainty > 0.0 ? fmt::format(" (+- {:.0e}, rounding not counted)", lock.uncertainty)
                             : "";
  const std::string since =
      fmt::format("From t = {:.6f}{} on {} taut", lock.time, error, cables_are(lock.cables));
  if (lock.rests) {
    return since + ", for good: the body is at rest.";
  }
  if (lock.permanent) {
    return since + ", for good: no tension falls to zero in a whole period.";
  }
  const std::size_t freedoms = is_point_mass(the_case) ? 2 : 3;
  return since + (lock.cables.size() + 1 < freedoms
                      ? "; for how long is not known: with more than one degree of freedom left "
                        "there is no period to look at."
                      : ", but perhaps not for good: no whole period without a release was found.");
}

/// What is left of the initial energy, and the swing.
std::string swing_sentence(const Case& the_case, const Solution& solution, const Swing& swing) {
  const double lowest = energy(the_case, solution.at(solution.end_time())) - swing.energy;
  const double start = energy(the_case, the_case.initial) - lowest;
  return fmt::format(
      "The body swings with amplitude {:.6g} rad and period {:.6g}. Of the initial energy {:.6g} "
      "above the equilibrium {:.6g} is left ({:.2f} %).",
      swing.amplitude, swing.period, start, swing.energy, 100.0 * swing.energy / start);
}

/// What is left of the initial energy where there is no swing to measure it against.
std::string energy_sentence(const EnergyLedger& ledger) {
  const double rounding = 1e-15 * std::abs(ledger.start);
  const double end = std::abs(ledger.end) <= rounding ? 0.0 : ledger.end;
  return fmt::format("Impacts have taken {:.6g} of energy: {:.6g} at the start, {:.6g} at the end.",
                     ledger.impacts + ledger.completions, ledger.start, end);
}

}  // namespace

std::string cable_list(CableSet cables) {
  std::string result;
  for (const std::size_t index : cables) {
    result += (result.empty() ? "" : "+") + std::to_string(index);
  }
  return result;
}

std::string cables_are(CableSet cables) {
  return cables.size() == 1 ? "cable " + cable_list(cables) + " is"
                            : "cables " + cable_list(cables) + " are";
}

std::string solution_text(const Case& the_case, const Solution& solution,
                          const Settling& settling) {
  std::string result = ending_sentence(the_case, solution) + "\n";
  if (!solution.events().empty()) {
    result += last_impacts_sentence(settling) + "\n";
  }
  if (!settling.lock) {
    const CableSet taut = solution.arcs().back().taut;
    result += fmt::format("At the end {} taut.\n", taut.empty() ? "no cable is" : cables_are(taut));
  } else {
    result += lock_sentence(the_case, *settling.lock) + "\n";
  }
  if (settling.lock && settling.lock->swing) {
    return result + swing_sentence(the_case, solution, *settling.lock->swing) + "\n";
  }
  return result + energy_sentence(energy_ledger(the_case, solution)) + "\n";
}

}  // namespace tautline::bench
