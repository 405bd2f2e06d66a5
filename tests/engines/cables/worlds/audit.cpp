#include "engines/cables/worlds/audit.hpp"

#include <algorithm>
#include <cmath>

#include "engines/cables/measure.hpp"
#include "engines/cables/worlds/impact.hpp"

namespace tautline::test {
namespace {

Moment moment_of(const Scene& scene, const World& world) {
  const int bodies = world.load_count() + static_cast<int>(world.hooks.size());
  Moment result{bodies_of(scene, bodies), {}};
  for (std::size_t cable = 0; cable < world.cables.size(); ++cable) {
    result.impulses.push_back(scene.impulse(static_cast<int>(cable)));
  }
  return result;
}

bool is_finite(const Moment& moment) {
  const auto finite = [](const BodyState& body) {
    return body.position.allFinite() && body.axes.allFinite() && body.velocity.allFinite() &&
           body.spin.allFinite();
  };
  return std::all_of(moment.bodies.begin(), moment.bodies.end(), finite) &&
         std::all_of(moment.impulses.begin(), moment.impulses.end(),
                     [](double impulse) { return std::isfinite(impulse); });
}

Vec3 velocity_of(const CableEnd& end, const std::vector<BodyState>& bodies) {
  if (end.body < 0) {
    return Vec3::Zero();
  }
  const BodyState& body = bodies[static_cast<std::size_t>(end.body)];
  return body.velocity + body.spin.cross(body.axes * end.point);
}

}  // namespace

Claims claims(Stepping stepping, bool hooks) {
  Claims result{1e-3, 1e-3, 1e-2};
  if (stepping == Stepping::by_events) {
    // where a step runs out of parts, light loads between heavy ones overshoot in the last of them
    result.way_allowance = 5e-3;
    // Float's rounding of 1e-7, in coordinates of some metres and over a minute, is more than the
    // exactness that is asked for.
    result.restitution = std::max(1e-6, 1e4 * Scene::rounding);
    // a taut swing by events keeps its energy to second order in the step: 2e-4 of it at 60 Hz
    result.gain_part = 1e-3;
    if (hooks) {
      result.gain_part = 1e-2;  // their work is known to the turn of the line in a step alone
    }
  }
  return result;
}

// energies beyond all numbers have no part of each other, and break the claim too
Broken broken(const Findings& findings, const Claims& claims) {
  return {findings.not_a_number.value > 0.0, !(findings.beyond.value <= claims.way_allowance),
          !(findings.gain_part() <= claims.gain_part),
          !(findings.restitution.value <= claims.restitution)};
}

Audit::Audit(const World& world, Stepping stepping, double dt, const Scene& scene)
    : world_(world),
      stepping_(stepping),
      dt_(dt),
      now_(moment_of(scene, world)),
      ledger_(world, stepping, dt),
      past_(world.cables.size()) {
  for (const Load& load : world.loads) {
    findings_.weight += load.mass * world_.gravity;
  }
}

void Audit::look(const Scene& scene, int parts) {
  before_ = std::move(now_);
  now_ = moment_of(scene, world_);
  ++step_;
  const double time = step_ * dt_;
  findings_.most_parts = std::max(findings_.most_parts, parts);
  if (!is_finite(now_)) {
    findings_.not_a_number.hold(1.0, time, -1);
    return;
  }
  ledger_.add(before_, now_);
  findings_.gain.hold(ledger_.gain(), time - dt_, -1);
  findings_.range = ledger_.range();
  for (std::size_t cable = 0; cable < past_.size(); ++cable) {
    look_at_impact(scene, cable, parts);
  }
  for (std::size_t cable = 0; cable < past_.size(); ++cable) {
    look_at_overstretch(cable);
    Past& past = past_[cable];
    past.impulse = now_.impulses[cable];
    const bool was_slack =
        line_of(world_.cables[cable], before_.bodies).distance < world_.cables[cable].length;
    past.slack_steps = past.impulse > 0.0 || !was_slack ? 0 : past.slack_steps + 1;
  }
}

void Audit::look_at_overstretch(std::size_t cable) {
  const CableData& data = world_.cables[cable];
  const double speed =
      (velocity_of(data.second, now_.bodies) - velocity_of(data.first, now_.bodies)).norm();
  auto& highest = past_[cable].highest;
  const int second = static_cast<int>(std::lround(1.0 / dt_));
  while (!highest.empty() && highest.front().first <= step_ - second) {
    highest.pop_front();
  }
  while (!highest.empty() && highest.back().second <= speed) {
    highest.pop_back();
  }
  highest.emplace_back(step_, speed);
  const double overstretch = line_of(data, now_.bodies).distance - data.length;
  // within a step of many parts the ends are faster than at its ends
  const double seen = stepping_ == Stepping::by_events ? 2.0 : 1.0;
  const double way = seen * highest.front().second * dt_;
  findings_.overstretch.hold(overstretch, step_ * dt_, static_cast<int>(cable));
  findings_.beyond.hold(overstretch - way, step_ * dt_, static_cast<int>(cable));
}

/// An impact of one cable alone: slack for two steps, while no other cable of its loads pulls in
/// this step or the one before, nothing touches them, and they close faster than gravity's part of
/// a step and than 0.05 m/s, below which float's rounding is felt.
bool Audit::is_isolated(const Scene& scene, std::size_t cable) const {
  if (!(now_.impulses[cable] > 0.0) || past_[cable].slack_steps < 2) {
    return false;
  }
  for (const int body : {world_.cables[cable].first.body, world_.cables[cable].second.body}) {
    if (body < 0 || body >= world_.load_count()) {
      continue;
    }
    if (scene.touched(body)) {
      return false;
    }
    for (std::size_t other = 0; other < world_.cables.size(); ++other) {
      const CableData& data = world_.cables[other];
      const bool shares = data.first.body == body || data.second.body == body;
      const bool pulls = now_.impulses[other] > 0.0 || past_[other].impulse > 0.0;
      if (other != cable && shares && pulls) {
        return false;
      }
    }
  }
  return true;
}

void Audit::look_at_impact(const Scene& scene, std::size_t cable, int parts) {
  // two parts have one impact between them; of more, the step's impulse may be a sum
  if (!is_isolated(scene, cable) || (stepping_ == Stepping::by_events && parts != 2)) {
    return;
  }
  const CableData& data = world_.cables[cable];
  const std::optional<SeenImpact> impact =
      stepping_ == Stepping::fixed
          ? fixed_impact(data, before_, now_)
          : event_impact(data, before_, now_, now_.impulses[cable], dt_, world_.gravity);
  const double slowest = std::max(0.05, world_.gravity * dt_);
  if (!impact || impact->closing < slowest) {
    return;
  }
  // by events, a cable that is held after its impact pulls on in the same step
  const double gap_now = data.length - line_of(data, now_.bodies).distance;
  if (stepping_ == Stepping::by_events && gap_now < 1e-6 * data.length) {
    return;
  }
  ++findings_.impacts;
  findings_.restitution.hold(std::abs(impact->ratio - data.restitution), step_ * dt_,
                             static_cast<int>(cable));
}

}  // namespace tautline::test
