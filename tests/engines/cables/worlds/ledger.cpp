#include "engines/cables/worlds/ledger.hpp"

#include <algorithm>
#include <cmath>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

double kinetic(const BodyState& body, const Vec3& velocity, const Vec3& spin) {
  const Vec3 local = body.axes.transpose() * spin;
  return 0.5 * body.mass * velocity.squaredNorm() +
         0.5 * local.dot(body.moments.cwiseProduct(local));
}

/// Of the largest energy, in what is gained: each step rounds the engine's numbers, some times, and
/// an hour of steps goes astray by the root of their number.
constexpr double roundings = 100.0;

double potential(const BodyState& body, double downwards) {
  return body.mass * downwards * body.position.y();
}

double distance_along(const CableData& cable, const std::vector<BodyState>& bodies,
                      const Vec3& displacement) {
  return line_of(cable, bodies).towards.dot(displacement);
}

}  // namespace

Energy energy_between(const std::vector<BodyState>& at, const std::vector<BodyState>& next,
                      int loads, Stepping stepping, double downwards) {
  Energy result{0.0, 0.0};
  for (std::size_t index = 0; index < static_cast<std::size_t>(loads); ++index) {
    const BodyState& body = at[index];
    const double halfway = kinetic(body, 0.5 * (body.velocity + next[index].velocity),
                                   0.5 * (body.spin + next[index].spin));
    const double here = kinetic(body, body.velocity, body.spin);
    result.kinetic += stepping == Stepping::fixed ? halfway : std::min(halfway, here);
    result.potential += potential(body, downwards);
  }
  return result;
}

Energy energy_at_start(const std::vector<BodyState>& bodies, int loads, Stepping stepping,
                       double dt, double downwards) {
  const double lag = stepping == Stepping::fixed ? 0.5 * dt : 0.0;
  Energy result{0.0, 0.0};
  for (std::size_t index = 0; index < static_cast<std::size_t>(loads); ++index) {
    const BodyState& body = bodies[index];
    const Vec3 now = body.velocity - lag * downwards * Vec3::UnitY();
    result.kinetic += kinetic(body, now, body.spin);
    result.potential += potential(body, downwards);
  }
  return result;
}

Ledger::Ledger(const World& world, Stepping stepping, double dt)
    : world_(world), stepping_(stepping), dt_(dt) {}

void Ledger::start(const Moment& before, const Moment& after) {
  const Energy energy =
      energy_at_start(before.bodies, world_.load_count(), stepping_, dt_, world_.gravity);
  start_ = energy.kinetic + energy.potential;
  highest_kinetic_ = energy.kinetic;
  highest_ = lowest_ = energy.potential;
  // a hook moves from the beginning on: its displacement before the start is that after it
  previous_ = before.bodies;
  for (std::size_t index = 0; index < previous_.size(); ++index) {
    previous_[index].position -= after.bodies[index].position - before.bodies[index].position;
  }
}

void Ledger::add_work(const Moment& before, const Moment& after) {
  for (std::size_t index = 0; index < world_.cables.size(); ++index) {
    const CableData& cable = world_.cables[index];
    if (cable.second.body < world_.load_count() || !(after.impulses[index] > 0.0)) {
      continue;
    }
    const double half = 0.5 * after.impulses[index] / dt_;  // of the tension [N]
    const auto hook = static_cast<std::size_t>(cable.second.body);
    const Vec3 here = before.bodies[hook].position;
    const Vec3 way = after.bodies[hook].position - here;
    if (before.impulses[index] > 0.0) {
      work_ += half * distance_along(cable, before.bodies, here - previous_[hook].position);
      work_to_come_ += half * distance_along(cable, before.bodies, way);
      continue;
    }
    // by events, the impact is at some pose between the two
    const double along = stepping_ == Stepping::fixed
                             ? distance_along(cable, before.bodies, way)
                             : 0.5 * (distance_along(cable, before.bodies, way) +
                                      distance_along(cable, after.bodies, way));
    work_ += half * along;
    work_to_come_ += half * along;
  }
}

void Ledger::add(const Moment& before, const Moment& after) {
  if (previous_.empty()) {
    start(before, after);
  }
  work_ += work_to_come_;
  work_to_come_ = 0.0;
  add_work(before, after);
  const Energy energy =
      energy_between(before.bodies, after.bodies, world_.load_count(), stepping_, world_.gravity);
  highest_kinetic_ = std::max(highest_kinetic_, energy.kinetic);
  highest_ = std::max(highest_, energy.potential);
  lowest_ = std::min(lowest_, energy.potential);
  double largest = energy.kinetic + std::abs(work_);  // of what is added up
  for (std::size_t load = 0; load < world_.loads.size(); ++load) {
    largest += std::abs(potential(before.bodies[load], world_.gravity));
  }
  const double rounding = roundings * Scene::rounding * largest;
  gain_ = std::max(0.0, energy.kinetic + energy.potential - start_ - work_ - rounding);
  previous_ = before.bodies;
}

}  // namespace tautline::test
