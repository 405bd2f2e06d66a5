#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/check/cases.hpp"
#include "bench/check/stepping.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

constexpr double momentum_step = 1e-3;  // [s]
constexpr double momentum_end = 2.5;    // [s]

/// A step's impulses may act anywhere along the step, and in it a body turns: 1e-3 s at 10 rad/s,
/// with cables three times as long as the body is wide.
constexpr double momentum_limit = 0.03;

/// Events may be reported for the step they fall into, up to the rounding of its ends [s].
constexpr double time_rounding = 1e-12;

/// The change of momentum by `impulses` at the pose of `before`.
Eigen::Vector3d pull_of(const Case& the_case, const State& before, CableSet cables,
                        const CableVector& impulses) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result += impulses[row++] * gap_gradient(the_case.cables[index], before);
  }
  return result;
}

/// By how much the change from `before` to `after` misses `pull`, relative to the momenta there.
double momentum_error(const Case& the_case, const State& before, const State& after,
                      const Eigen::Vector3d& pull) {
  const Body& body = the_case.body;
  const Vec2 linear = body.mass * (after.velocity - before.velocity);
  const double angular = body.inertia * (after.spin - before.spin);
  const double scale = body.mass * (before.velocity.norm() + after.velocity.norm());
  const double spin_scale =
      scale * 1.0 + body.inertia * (std::abs(before.spin) + std::abs(after.spin));
  return std::max((linear - pull.head<2>()).norm() / scale,
                  std::abs(angular - pull[2]) / spin_scale);
}

/// What the steps of one case showed.
struct Sum {
  double found = 0.0;
  std::string fault;  // empty unless what a step reports makes no sense
  int hits = 0;       // steps of cables with an impulse
};

/// Looks at what the events of the latest step say, and takes their impulses from `rest`.
void look_at_events(const Case& the_case, const Simulation& simulation, const Moment& moment,
                    CableVector& rest, Sum& sum) {
  for (const Event& event : simulation.events()) {
    if (std::abs(event.time - (moment.time - 0.5 * momentum_step)) >
        0.5 * momentum_step + time_rounding) {
      sum.fault = fmt::format("an event at t = {:.6g} is reported in the step that ends at {:.6g}",
                              event.time, moment.time);
    }
    const Eigen::Vector3d pull = pull_of(the_case, event.before, event.cables, event.impulses);
    sum.found = worse(sum.found, momentum_error(the_case, event.before, event.after, pull));
    Eigen::Index row = 0;
    for (const std::size_t index : event.cables) {
      rest[static_cast<Eigen::Index>(index)] -= event.impulses[row++];
    }
  }
}

/// Looks at the latest step of `simulation`, which took the body as `moment` says.
void look_at(const Subject& subject, const Case& the_case, const Simulation& simulation,
             const Moment& moment, Sum& sum) {
  CableSet all;
  CableVector rest(static_cast<Eigen::Index>(the_case.cables.size()));
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const double impulse = simulation.impulses()[index];
    all.insert(index);
    rest[static_cast<Eigen::Index>(index)] = impulse;
    sum.hits += impulse > 0.0 ? 1 : 0;
    if (!(impulse >= 0.0)) {
      sum.fault = fmt::format("cable {} pushes, with {:.2g} N s at t = {:.6g}", index, impulse,
                              moment.time);
    }
  }
  if (!simulation.events().empty()) {
    look_at_events(the_case, simulation, moment, rest, sum);
    // a simulation that locates its impacts reports the impulses of these and no others
    if (!(rest.cwiseAbs().maxCoeff() <= 1e3 * subject.rounding() * the_case.body.mass)) {
      sum.fault = fmt::format(
          "the impulses of the step that ends at {:.6g} are not those of its "
          "events",
          moment.time);
    }
    return;
  }
  if (rest.maxCoeff() <= 0.0) {
    return;  // slack, or held by tensions, which are not reported
  }
  const State pose = at_the_solve(moment.before, momentum_step, subject.flight());
  Eigen::Vector3d pull = pull_of(the_case, pose, all, rest);
  pull.head<2>() += momentum_step * the_case.body.mass * the_case.gravity;
  sum.found = worse(sum.found, momentum_error(the_case, moment.before, moment.after, pull));
}

}  // namespace

Measure measure_step_momentum(const Subject& subject) {
  Measure result{0.0, momentum_limit, "the reported impulses are the change of momentum"};
  for (const std::string_view name : {"crane-load", "tilted-gravity", "plate-four-cables"}) {
    const Case the_case = shipped_case(name);
    const auto simulation = subject.start(the_case, momentum_step);
    Sum sum;
    run_whole(*simulation, momentum_step, momentum_end,
              [&](const Moment& moment) { look_at(subject, the_case, *simulation, moment, sum); });
    if (sum.fault.empty() && sum.hits == 0) {
      sum.fault = "no impulse is ever reported";
    }
    if (!sum.fault.empty()) {
      return {std::numeric_limits<double>::infinity(), momentum_limit,
              fmt::format("{}: {}", name, sum.fault)};
    }
    if (sum.found > std::max(result.found, momentum_limit)) {
      result.sentence = fmt::format(
          "{}: the momentum changes by other than the reported impulses, by {:.2g} of it", name,
          sum.found);
    }
    result.found = std::max(result.found, sum.found);
  }
  return result;
}

}  // namespace tautline::bench
