// No gravity: before and after the hit nothing changes but position and angle. The body comes along
// the cable and does not spin, so its pose at the hit does not depend on the step in which it is
// noticed.

#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "bench/check/cases.hpp"
#include "bench/check/hit.hpp"
#include "bench/check/stepping.hpp"
#include "tautline/geometry.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

constexpr double hit_step = 1e-4;     // [s]
constexpr double hit_end = 0.04;      // [s], long after the hit
constexpr double way_to_go = 0.0203;  // [m], at 1 m/s: no whole number of steps

/// A contact that takes `longest_contact` steps turns the body by up to 5e-3 rad meanwhile, and the
/// moment with it; rounding to float is well below.
constexpr double body_limit = 0.02;

/// A body of `mass` and `inertia` at `angle` on the way to be hit along its cable.
Case hit_at(double angle, const Body& body, const Vec2& attachment) {
  const Vec2 towards(0.28, 0.96);  // a unit vector, in no special direction
  Case result;
  result.name = "hit";
  result.body = body;
  result.gravity = Vec2::Zero();
  result.duration = hit_end;
  result.initial.angle = angle;
  result.initial.velocity = -towards;
  Cable cable{Vec2::Zero(), attachment, 1.0, 0.5};
  cable.anchor = attachment_point(result.initial, cable) + (1.0 - way_to_go) * towards;
  result.cables = {cable};
  return result;
}

/// The spin a hit gives, over the one its impulse should give about the declared arm [-].
double turn_ratio(const Subject& subject, double angle, double inertia) {
  const Case the_case = hit_at(angle, {1.0, inertia}, Vec2(0.3, 0.2));
  const std::optional<Hit> hit = first_hit(subject, the_case, hit_step, hit_end);
  if (!hit) {
    return std::nan("");
  }
  const double moment = gap_gradient(the_case.cables.front(), the_case.initial)[2];
  return inertia * (hit->after.spin - hit->before.spin) / (hit->impulse * moment);
}

constexpr double inertias[] = {0.05, 0.4};  // [kg m^2], of 1 kg

/// [rad]; the arm is 0.23 m or more at all of them, and 0.23 m at angle 0
constexpr double angles[] = {-0.9, 1.8, 3.0, -2.0};

/// The effect of a hit on a body in space, in the axes of the body.
struct Struck {
  Eigen::Vector3d wanted;  // [m], the moment of a unit impulse
  Eigen::Vector3d turned;  // [kg m^2 rad/s / (N s)], moments times change of spin, over the impulse
  double astray;           // [-], of the impulse: how far the change of momentum is from it
};

/// Three different moments that a body of 1 kg can have: each is at most the sum of the others.
const Eigen::Vector3d& struck_moments() {
  static const Eigen::Vector3d moments(0.05, 0.08, 0.11);  // [kg m^2]
  return moments;
}

/// A body at `orientation` that is hit at the point `at` of it [m] along `towards`, a unit vector
/// of the world. Empty if no impulse is reported.
std::optional<Struck> struck(const Subject& subject, const Quaternion& orientation,
                             const Eigen::Vector3d& at, const Eigen::Vector3d& towards) {
  SpatialSystem system = body_in_space(struck_moments());
  SpatialState& start = system.initial.bodies.front();
  start.orientation = orientation;
  start.velocity = -towards;
  SpatialCable& cable = system.cables.front();
  cable.from.at = at;
  cable.length = Function<1>::constant(1.0);
  cable.to.at = in_the_world(start, at) + (1.0 - way_to_strike) * towards;
  const std::optional<SystemHit> hit = first_hit(subject, system, hit_step, hit_end);
  if (!hit) {
    return std::nullopt;
  }
  const SpatialState& before = hit->before.bodies.front();
  const SpatialState& after = hit->after.bodies.front();
  const Eigen::Vector3d gained =
      system.bodies.front().mass * (after.velocity - before.velocity) / hit->impulse;
  return Struck{moment_of(start, at, in_the_world(start, at), towards),
                struck_moments().cwiseProduct(after.spin - before.spin) / hit->impulse,
                (gained - towards).norm()};
}

constexpr std::array axis_names = {"first", "second", "third"};

/// A hit that turns a body, whose axes are those of the world, about its axis `axis`.
std::optional<Struck> struck_about(const Subject& subject, int axis) {
  constexpr double arm = 0.3;  // [m]
  const Quaternion none = Quaternion::Unit(0);
  return struck(subject, none, arm * Eigen::Vector3d::Unit((axis + 1) % 3),
                Eigen::Vector3d::Unit((axis + 2) % 3));
}

/// What a hit about the axis `axis` did.
std::string sentence_on(const Struck& hit, int axis) {
  const char* const name = axis_names.at(static_cast<std::size_t>(axis));
  Eigen::Vector3d aside = hit.turned;
  aside[axis] = 0.0;
  const double about_others = aside.norm() / hit.wanted.norm();
  if (!(about_others <= body_limit)) {
    return fmt::format(
        "a hit about the {} axis turns the body about other axes, too, by {:.3g} of what it must "
        "about its own",
        name, about_others);
  }
  if (hit.turned[axis] == 0.0) {
    return fmt::format("a hit about the {} axis does not turn the body", name);
  }
  return fmt::format(
      "a hit about the {} axis turns the body as if its moment were {:.4g} times the declared one",
      name, hit.wanted[axis] / hit.turned[axis]);
}

/// The momentum about the anchor of cable 0 [N m s].
double momentum_about_anchor(const Case& the_case, const State& state) {
  const Vec2 from_anchor = state.position - the_case.cables.front().anchor;
  return the_case.body.mass * cross(from_anchor, state.velocity) +
         the_case.body.inertia * state.spin;
}

}  // namespace

Measure measure_mass(const Subject& subject) {
  double found = 0.0;
  std::string sentence;
  for (const double mass : {1.0, 3.0}) {
    const Case the_case = hit_at(0.0, {mass, 0.4}, Vec2::Zero());
    const std::optional<Hit> hit = first_hit(subject, the_case, hit_step, hit_end);
    if (!hit) {
      return never_hit(body_limit);
    }
    const double shown = hit->impulse / (hit->after.velocity - hit->before.velocity).norm();
    const double error = worse(0.0, std::abs(shown / mass - 1.0));
    if (error >= found) {
      found = error;
      sentence = fmt::format(
          "a central hit changes the velocity as if the body had {:.4g} kg; it declares {:g} kg",
          shown, mass);
    }
  }
  return {found, body_limit, sentence};
}

Measure measure_inertia(const Subject& subject) {
  double found = 0.0;
  double shown = 1.0;
  for (const double inertia : inertias) {
    const double ratio = turn_ratio(subject, 0.0, inertia);
    if (std::isnan(ratio)) {
      return never_hit(body_limit);
    }
    if (!(std::abs(ratio - 1.0) < found)) {
      found = std::abs(ratio - 1.0);
      shown = ratio;
    }
  }
  return {found, body_limit,
          fmt::format("an off-centre hit at angle 0 turns the body as if its inertia were {:.4g} "
                      "times the declared one",
                      1.0 / shown)};
}

Measure measure_arm(const Subject& subject) {
  double found = 0.0;
  double worst = angles[0];
  double worst_ratio = 1.0;
  for (const double inertia : inertias) {
    const double at_zero = turn_ratio(subject, 0.0, inertia);
    for (const double angle : angles) {
      const double ratio = turn_ratio(subject, angle, inertia) / at_zero;
      if (std::isnan(ratio)) {
        return never_hit(body_limit);
      }
      if (std::abs(ratio - 1.0) > found) {
        found = std::abs(ratio - 1.0);
        worst = angle;
        worst_ratio = ratio;
      }
    }
  }
  if (found <= body_limit) {
    return {found, body_limit, "an impulse has the same arm at every angle of the body"};
  }
  return {found, body_limit,
          fmt::format("the arm of an impulse is wrong: at angle {:g} it is {:.3g} times what it "
                      "should be by that at angle 0; it does not turn with the body",
                      worst, worst_ratio)};
}

Measure measure_angular_momentum(const Subject& subject) {
  Case the_case = spinning_on_one_cable(0.05);
  the_case.gravity = Vec2::Zero();
  const auto simulation = subject.start(the_case, hit_step);
  std::optional<State> before;  // the first step with an impulse
  State after;                  // the last one of the same contact
  bool over = false;
  run_whole(*simulation, hit_step, 0.25, [&](const Moment& moment) {
    const bool hit = simulation->impulses()[0] > 0.0;
    over = over || (before && !hit);
    if (hit && !over) {
      before = before.value_or(moment.before);
      after = moment.after;
    }
  });
  if (!before) {
    return never_hit(body_limit);
  }
  const double change =
      momentum_about_anchor(the_case, after) - momentum_about_anchor(the_case, *before);
  const double turned = the_case.body.inertia * std::abs(after.spin - before->spin);
  const double found = std::abs(change) / turned;
  return {found, body_limit,
          found <= body_limit
              ? "a hit leaves the angular momentum about the anchor as it is"
              : fmt::format("a hit changes the angular momentum about the anchor, by {:.2g} of "
                            "what it turns the body by: the impulse does not act along the cable, "
                            "or on another inertia",
                            found)};
}

Measure measure_space_inertia(const Subject& subject) {
  double found = 0.0;
  std::string sentence;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<Struck> hit = struck_about(subject, axis);
    if (!hit) {
      return never_hit(body_limit);
    }
    const double error = worse(0.0, (hit->turned - hit->wanted).norm() / hit->wanted.norm());
    if (error >= found) {
      found = error;
      sentence = sentence_on(*hit, axis);
    }
  }
  return {found, body_limit, sentence};
}

Measure measure_space_arm(const Subject& subject) {
  // the moments that the engine seems to have are another claim; where it has none, the declared
  // ones are asked for
  Eigen::Vector3d shown;
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<Struck> hit = struck_about(subject, axis);
    if (!hit) {
      return never_hit(body_limit);
    }
    shown[axis] = hit->turned[axis] != 0.0 ? hit->wanted[axis] / hit->turned[axis] : 1.0;
  }
  double turned = 0.0;
  double astray = 0.0;
  for (const Eigen::Vector3d& by : {Eigen::Vector3d(0.9, 0.0, 0.4), Eigen::Vector3d(-1.8, 0.7, 0.3),
                                    Eigen::Vector3d(0.2, 1.1, -2.3)}) {
    const std::optional<Struck> hit = struck(subject, quaternion_of<double>(by),
                                             Eigen::Vector3d(0.3, -0.2, 0.1), struck_direction());
    if (!hit) {
      return never_hit(body_limit);
    }
    turned =
        worse(turned, (shown.cwiseProduct(hit->turned) - hit->wanted).norm() / hit->wanted.norm());
    astray = worse(astray, hit->astray);
  }
  const double found = std::max(turned, astray);
  if (found <= body_limit) {
    return {found, body_limit, "an impulse has its arm in every orientation of the body"};
  }
  if (!(astray <= body_limit)) {
    return {found, body_limit,
            fmt::format("a hit changes the momentum by other than its impulse along the cable, by "
                        "{:.3g} of it",
                        astray)};
  }
  return {found, body_limit,
          fmt::format("the arm of an impulse is wrong in space: it turns a body by other than its "
                      "moment, by {:.3g} of it",
                      turned)};
}

}  // namespace tautline::bench
