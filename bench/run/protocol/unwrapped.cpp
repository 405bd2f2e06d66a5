#include "bench/run/protocol/simulations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/run/protocol/messages.hpp"

namespace tautline::bench {

void refuse_wrapped(const State& before, const State& after, double dt) {
  const double turned = std::abs(after.angle - before.angle);
  // a step may turn faster inside than at both ends, but not by this much more
  constexpr double generous = 4.0;  // [-]
  const double likely = generous * dt * std::max(std::abs(before.spin), std::abs(after.spin));
  if (turned > std::numbers::pi && turned > likely) {
    throw ProtocolError(fmt::format(
        "the engine's angle went from {:.6g} to {:.6g} in {:g} s at a spin of {:.3g}: it must not "
        "be wrapped",
        before.angle, after.angle, dt, after.spin));
  }
}

}  // namespace tautline::bench
