#pragma once

#include <array>
#include <span>
#include <string_view>

namespace tautline::bench {

/// What a run's deviation comes from: attribution.hpp says how they are told apart.
enum class Cause {
  flight_bias,          // the integrator's path between impacts: semi-implicit Euler, -g t dt / 2
  event_lag,            // the impact came before or after its instant, at another pose
  late_rate,            // restitution of a rate that is not the one at the instant of the impact
  position_correction,  // overstretch pushed out: by velocity on top of the bounce, or as a shift
  threshold,            // slow impacts do not rebound
  restitution_ignored,  // no impact does, at any speed
  solver_residual,      // what else the impulse did: wrong size, wrong direction
  taut_drift,           // motion on taut cables
  amplification,        // what the exact motion makes of defects beyond first order, or of rounding
  rotation_in_flight,   // how a body turns between impacts; of systems alone
};
inline constexpr std::array causes = {Cause::flight_bias,     Cause::event_lag,
                                      Cause::late_rate,       Cause::position_correction,
                                      Cause::threshold,       Cause::restitution_ignored,
                                      Cause::solver_residual, Cause::taut_drift,
                                      Cause::amplification,   Cause::rotation_in_flight};

/// The name used in files: "flight_bias", and so on.
[[nodiscard]] std::string_view to_string(Cause cause);

/// What it is, in words that follow its name.
[[nodiscard]] const char* meaning_of(Cause cause);

/// One number per cause [m].
struct CauseParts : std::array<double, causes.size()> {};

/// The causes that `parts` show: rotation in flight, the last of all, only where there
/// is some.
[[nodiscard]] inline std::span<const Cause> causes_of(const CauseParts& parts) {
  return std::span(causes).first(causes.size() - (parts.back() == 0.0 ? 1U : 0U));
}

}  // namespace tautline::bench
