#include "bench/measure/attribution/cause.hpp"

#include <cstddef>

namespace tautline::bench {
namespace {

struct CauseText {
  std::string_view name;
  const char* meaning;
};

/// In the order of the enumerators.
constexpr std::array<CauseText, causes.size()> texts = {
    {{"flight_bias", "the integrator's path in free flight: semi-implicit Euler is g dt t / 2 off"},
     {"event_lag", "an impact before or after its instant, at another pose"},
     {"late_rate", "restitution of a rate that is not the one at the instant of the impact"},
     {"position_correction",
      "overstretch pushed out, by velocity on top of the bounce or as a shift"},
     {"threshold", "slow impacts lose their rebound, faster ones do not"},
     {"restitution_ignored",
      "no impact, at any speed, comes back with half of the restitution requested"},
     {"solver_residual", "what else the impulse did: a wrong size or a wrong direction"},
     {"taut_drift", "what goes wrong on taut cables"},
     {"amplification",
      "what the exact motion makes of all this beyond first order, or of rounding"},
     {"rotation_in_flight",
      "how a body in space turns in free flight: without its gyroscopic term, or wrong by as much "
      "as a long step makes it"}}};

const CauseText& text_of(Cause cause) { return texts.at(static_cast<std::size_t>(cause)); }

}  // namespace

std::string_view to_string(Cause cause) { return text_of(cause).name; }

const char* meaning_of(Cause cause) { return text_of(cause).meaning; }

}  // namespace tautline::bench
