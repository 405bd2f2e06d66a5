#include "ledger.hpp"

#include <algorithm>

#include "measure.hpp"

namespace tautline::test {
namespace {

double kinetic(const BodyState& body, const Vec3& velocity, const Vec3& spin) {
  const Vec3 local = body.axes.transpose() * spin;
  return 0.5 * body.mass * velocity.squaredNorm() +
         0.5 * local.dot(body.moments.cwiseProduct(local));
}

double potential(const BodyState& body) { return body.mass * world_gravity * body.position.y(); }

/// Of the cables' impulses on lines between `bodies`, times how far their hooks go from where to
/// where [N s m].
double reach(const World& world, const std::vector<BodyState>& bodies,
             const std::vector<double>& impulses, const std::vector<BodyState>& from,
             const std::vector<BodyState>& to) {
  double result = 0.0;
  for (std::size_t index = 0; index < world.cables.size(); ++index) {
    const CableData& cable = world.cables[index];
    if (cable.second.body >= world.load_count() && impulses[index] > 0.0) {
      const auto hook = static_cast<std::size_t>(cable.second.body);
      result += impulses[index] *
                line_of(cable, bodies).towards.dot(to[hook].position - from[hook].position);
    }
  }
  return result;
}

}  // namespace

std::vector<BodyState> with_hooks_of(std::vector<BodyState> bodies,
                                     const std::vector<BodyState>& hooks) {
  for (std::size_t index = 0; index < bodies.size(); ++index) {
    if (bodies[index].is_hook()) {
      bodies[index] = hooks[index];
    }
  }
  return bodies;
}

Energy energy_between(const std::vector<BodyState>& at, const std::vector<BodyState>& next,
                      int loads, Stepping stepping) {
  Energy result{0.0, 0.0};
  for (std::size_t index = 0; index < static_cast<std::size_t>(loads); ++index) {
    const BodyState& body = at[index];
    const double halfway = kinetic(body, 0.5 * (body.velocity + next[index].velocity),
                                   0.5 * (body.spin + next[index].spin));
    const double here = kinetic(body, body.velocity, body.spin);
    result.kinetic += stepping == Stepping::fixed ? halfway : std::min(halfway, here);
    result.potential += potential(body);
  }
  return result;
}

Energy energy_at_start(const std::vector<BodyState>& bodies, int loads, Stepping stepping,
                       double dt) {
  const double lag = stepping == Stepping::fixed ? 0.5 * dt : 0.0;
  Energy result{0.0, 0.0};
  for (std::size_t index = 0; index < static_cast<std::size_t>(loads); ++index) {
    const BodyState& body = bodies[index];
    const Vec3 now = body.velocity - lag * world_gravity * Vec3::UnitY();
    result.kinetic += kinetic(body, now, body.spin);
    result.potential += potential(body);
  }
  return result;
}

Ledger::Ledger(const World& world, Stepping stepping, double dt)
    : world_(world), stepping_(stepping), dt_(dt) {}

void Ledger::start(const Moment& before, const Moment& after) {
  const Energy energy = energy_at_start(before.bodies, world_.load_count(), stepping_, dt_);
  start_ = energy.kinetic + energy.potential;
  highest_kinetic_ = energy.kinetic;
  highest_ = lowest_ = energy.potential;
  // a hook moves from the beginning on: its displacement before the start is that after it
  previous_ = before.bodies;
  for (std::size_t index = 0; index < previous_.size(); ++index) {
    previous_[index].position -= after.bodies[index].position - before.bodies[index].position;
  }
}

void Ledger::add(const Moment& before, const Moment& after) {
  if (previous_.empty()) {
    start(before, after);
  }
  std::array<double, 3> later{};  // work that is done after this pose
  if (!world_.hooks.empty()) {
    // an impact's impulse, and that of a cable that pulled before
    std::vector<double> fresh = after.impulses;
    std::vector<double> held = after.impulses;
    for (std::size_t cable = 0; cable < fresh.size(); ++cable) {
      (before.impulses[cable] > 0.0 ? fresh : held)[cable] = 0.0;
    }
    const auto arrived = with_hooks_of(before.bodies, after.bodies);
    const std::array lines = {&before.bodies, &arrived};
    for (std::size_t way = 0; way < lines.size(); ++way) {
      const auto now = [&](const std::vector<double>& impulses) {
        return 0.5 / dt_ * reach(world_, *lines[way], impulses, before.bodies, after.bodies);
      };
      work_[way] +=
          now(fresh) + 0.5 / dt_ * reach(world_, *lines[way], held, previous_, before.bodies);
      later[way] = now(fresh) + now(held);
    }
    if (stepping_ == Stepping::by_events) {
      const auto pull = [&](const std::vector<BodyState>& line) {
        return reach(world_, line, after.impulses, before.bodies, after.bodies) / dt_;
      };
      later[2] = 0.5 * (pull(before.bodies) + pull(after.bodies));
    }
  }
  const Energy energy = energy_between(before.bodies, after.bodies, world_.load_count(), stepping_);
  highest_kinetic_ = std::max(highest_kinetic_, energy.kinetic);
  highest_ = std::max(highest_, energy.potential);
  lowest_ = std::min(lowest_, energy.potential);
  const std::size_t ways = stepping_ == Stepping::fixed ? 2 : 3;
  gain_ = energy.kinetic + energy.potential - start_ -
          *std::max_element(work_.begin(), work_.begin() + ways);
  for (std::size_t way = 0; way < work_.size(); ++way) {
    work_[way] += later[way];
  }
  previous_ = before.bodies;
}

}  // namespace tautline::test
