#include "bench/measure/attribution/cause.hpp"

namespace tautline::bench {

std::string_view to_string(Cause cause) {
  switch (cause) {
    case Cause::flight_bias:
      return "flight_bias";
    case Cause::event_lag:
      return "event_lag";
    case Cause::late_rate:
      return "late_rate";
    case Cause::position_correction:
      return "position_correction";
    case Cause::threshold:
      return "threshold";
    case Cause::restitution_ignored:
      return "restitution_ignored";
    case Cause::solver_residual:
      return "solver_residual";
    case Cause::taut_drift:
      return "taut_drift";
    case Cause::amplification:
      return "amplification";
  }
  return "unknown";
}

}  // namespace tautline::bench
