// The list of what is claimed of every model, and its settling one by one.

#include "bench/check/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>

#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// A greeting at each of the hundred runs of a check is fine, a line at each of its hundred
/// thousand steps is not [bytes].
constexpr double most_printed = 65536;

constexpr std::array all_claims = {
    Claim{"state-echo", "a run begins in the initial state it was given",
          "the rounding of the precision that the engine declares", measure_state_echo},
    Claim{"precision", "states keep the declared precision after every step",
          "one number in 2^29 is a float by chance", measure_precision},
    Claim{"flight", "a slack body flies the parabola or semi-implicit Euler, at any step",
          "an angle advanced by infinitesimal turns lags by 1.4e-4 rad", measure_flight},
    Claim{"mass", "an impulse moves the declared mass",
          "a contact of 20 steps turns the body meanwhile", measure_mass},
    Claim{"inertia", "an impulse turns the declared inertia",
          "a contact of 20 steps turns the body meanwhile", measure_inertia},
    Claim{"arm", "an impulse acts at the attachment, whatever the angle",
          "a contact of 20 steps turns the body meanwhile", measure_arm},
    Claim{"angular-momentum", "a hit keeps the angular momentum about the anchor",
          "the same limit as for the inertia and the arm it comes from", measure_angular_momentum},
    Claim{"step-momentum", "the reported impulses are the change of momentum",
          "they may act anywhere in the step, in which a body turns", measure_step_momentum},
    Claim{"central-restitution", "a hit through the centre rebounds with the restitution",
          "gravity's part of a contact of 20 steps, and 0.02 for a spring's phase",
          measure_central_restitution},
    Claim{"off-centre-restitution", "so does one that turns the body",
          "the cable's turning in a contact of 20 steps, and 0.02 for a spring's phase",
          measure_off_centre_restitution},
    Claim{"slow-restitution", "so does one at any speed down to 0.02 m/s",
          "0.02 for the phase in which a spring begins and ends", measure_slow_restitution},
    Claim{"energy", "energy never rises, beyond what the scheme borrows and returns",
          "gravity's part of a contact of 20 steps", measure_energy},
    Claim{"overstretch", "a cable is stopped at its length",
          "one step late, or a spring contact of 20 steps", measure_overstretch},
    Claim{"taut-growth", "a cable that stays taut does not lengthen",
          "a tenth of what a cable held in its rate alone lengthens by", measure_taut_growth},
    Claim{"mirror-symmetry", "the mirrored case moves in the mirror",
          "what ten sweeps of a solver leave of the order of the cables", measure_mirror_symmetry},
    Claim{"determinism", "a second run is the same, bit by bit", "none: the same is the same",
          measure_determinism},
    Claim{"convergence", "smaller steps bring it to the exact motion, at first order",
          "a slope of 1, scattered by where an impact falls in its step", measure_convergence}};

Finding settle(const Claim& claim, const Subject& subject) {
  Finding finding;
  finding.claim = claim.name;
  const Measure measure = claim.measure(subject);
  finding.found = measure.found;
  finding.limit = measure.limit;
  finding.holds = measure.found <= measure.limit;  // false where it is not a number
  finding.sentence = measure.sentence;
  return finding;
}

/// The last line of `text` that is not empty.
std::string last_line(std::string text) {
  text.erase(text.find_last_not_of('\n') + 1);
  return text.substr(text.rfind('\n') + 1);
}

/// Why a claim could not be measured.
std::string reason(const std::exception& error) {
  const bool stopped = dynamic_cast<const RunStopped*>(&error) != nullptr;
  return (stopped ? "" : "the engine threw: ") + std::string(error.what());
}

}  // namespace

std::span<const Claim> claims() { return all_claims; }

const Claim* find_claim(std::string_view name) {
  const auto* const found = std::find_if(all_claims.begin(), all_claims.end(),
                                         [&](const Claim& claim) { return claim.name == name; });
  return found != all_claims.end() ? found : nullptr;
}

std::vector<Finding> check_model(const Engine& engine, const std::string& model,
                                 const CheckProgress& progress) {
  std::vector<Finding> findings;
  progress(all_claims.front().name, findings);
  try {
    const Subject subject(engine, model);
    for (const Claim& claim : all_claims) {
      progress(claim.name, findings);
      try {
        findings.push_back(settle(claim, subject));
      } catch (const std::exception& error) {
        findings.push_back(unmeasured(claim.name, reason(error)));
      }
    }
  } catch (const std::exception& error) {
    findings.push_back(unmeasured(all_claims.front().name, reason(error)));
  }
  return findings;
}

Finding unmeasured(std::string_view claim, const std::string& why) {
  Finding finding;
  finding.claim = claim;
  finding.found = std::numeric_limits<double>::quiet_NaN();
  finding.limit = std::numeric_limits<double>::quiet_NaN();
  finding.sentence = why;
  return finding;
}

Finding quiet(std::size_t printed, const std::string& tail) {
  Finding finding;
  finding.claim = "quiet";
  finding.found = static_cast<double>(printed);
  finding.limit = most_printed;
  finding.holds = finding.found <= finding.limit;
  finding.sentence = printed == 0 ? "prints nothing" : fmt::format("prints {} bytes", printed);
  if (!finding.holds) {
    finding.sentence += ", the last line of them: " + printable(last_line(tail));
  }
  return finding;
}

ordered_json findings_json(const std::vector<Finding>& findings) {
  ordered_json rows = ordered_json::array();
  for (const Finding& finding : findings) {
    rows.push_back({{"claim", finding.claim},
                    {"found", finding.found},  // null where it is not finite
                    {"limit", finding.limit},
                    {"holds", finding.holds},
                    {"sentence", finding.sentence}});
  }
  return rows;
}

std::vector<Finding> findings_from(const ordered_json& json) {
  std::vector<Finding> findings;
  for (const ordered_json& row : json) {
    const auto number = [&row](const char* key) {
      return row.at(key).is_number() ? row.at(key).get<double>()
                                     : std::numeric_limits<double>::quiet_NaN();
    };
    findings.push_back(
        {row.at("claim"), number("found"), number("limit"), row.at("holds"), row.at("sentence")});
  }
  return findings;
}

}  // namespace tautline::bench
