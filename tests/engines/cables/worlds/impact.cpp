#include "engines/cables/worlds/impact.hpp"

#include <cmath>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

/// With the hooks' velocities of the step that leads to `after`.
std::vector<BodyState> with_hook_velocities_of(std::vector<BodyState> bodies,
                                               const std::vector<BodyState>& after) {
  for (std::size_t index = 0; index < bodies.size(); ++index) {
    if (bodies[index].is_hook()) {
      bodies[index].velocity = after[index].velocity;
    }
  }
  return bodies;
}

/// Of a load in a step [rad]. With more, a cable may go taut and slack several times in a step, and
/// Bullet does not turn a body any further.
constexpr double most_turn = 0.78;

BodyState flown(BodyState body, double time, double downwards) {
  body.position += time * body.velocity;
  if (body.is_hook()) {
    return body;
  }
  body.position -= 0.5 * time * time * downwards * Vec3::UnitY();
  body.velocity -= time * downwards * Vec3::UnitY();
  const double spin = body.spin.norm();
  if (spin > 0.0) {
    const Eigen::AngleAxisd turned(Scene::turn(spin, time), body.spin / spin);
    body.axes = turned.toRotationMatrix() * body.axes;
  }
  return body;
}

std::vector<BodyState> flown(const std::vector<BodyState>& bodies, double time, double downwards) {
  std::vector<BodyState> result;
  result.reserve(bodies.size());
  for (const BodyState& body : bodies) {
    result.push_back(flown(body, time, downwards));
  }
  return result;
}

}  // namespace

SeenImpact fixed_impact(const CableData& cable, const Moment& before, const Moment& after) {
  const Line line = line_of(cable, before.bodies);
  const double closing =
      -gap_rate(line, cable, with_hook_velocities_of(before.bodies, after.bodies));
  return {closing, gap_rate(line, cable, after.bodies) / closing};
}

std::optional<SeenImpact> event_impact(const CableData& cable, const Moment& before,
                                       const Moment& after, double impulse, double dt,
                                       double downwards) {
  const auto start = with_hook_velocities_of(before.bodies, after.bodies);
  for (const int body : {cable.first.body, cable.second.body}) {
    if (body >= 0 && start[static_cast<std::size_t>(body)].spin.norm() * dt > most_turn) {
      return std::nullopt;
    }
  }
  const auto gap_at = [&](double time) {
    return cable.length - line_of(cable, flown(start, time, downwards)).distance;
  };
  if (gap_at(dt) >= 0.0) {
    return std::nullopt;
  }
  double slack = 0.0;
  double taut = dt;
  const int halvings = 60;  // to rounding
  for (int done = 0; done < halvings; ++done) {
    const double middle = 0.5 * (slack + taut);
    (gap_at(middle) < 0.0 ? taut : slack) = middle;
  }
  const auto then = flown(start, taut, downwards);
  const Line line = line_of(cable, then);
  const double closing = -gap_rate(line, cable, then);
  // what opens so slowly closes again before the step is over
  if (cable.restitution * closing < 2.0 * downwards * dt) {
    return std::nullopt;
  }
  const double rebound = impulse * (line.inverse[0] + line.inverse[1]) - closing;
  return SeenImpact{closing, rebound / closing};
}

}  // namespace tautline::test
