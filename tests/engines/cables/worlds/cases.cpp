#include "engines/cables/worlds/cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engines/cables/draw.hpp"
#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

constexpr int random_starts = 40;
constexpr double top = 6.0;  // [m] of anchors

/// A body of a box's size and inertia that touches nothing.
Load free_box(double mass, const Vec3& position) {
  return {mass, box_side / std::sqrt(6.0), position, Vec3::Zero(), Vec3::Zero(), false};
}

Case swinging(const std::string& name, World world) {
  world.kind = name;
  return {name, std::move(world), false, {}, {}};
}

/// A ball that goes around a vertical line, its cable 45 degrees off it.
Case circling_ball() {
  const double length = 5.0;
  const double side = length * std::sqrt(0.5);
  World world;
  const Vec3 around(0.0, 0.0, std::sqrt(world_gravity * side));  // v^2 / r = g tan 45 degrees
  world.loads.push_back({1.0, 0.1, Vec3(side, top - side, 0.0), around, Vec3::Zero(), false});
  tie(world, {0, Vec3::Zero()}, {-1, Vec3(0.0, top, 0.0)}, 0.0, 0.3);
  return swinging("ball circling on 5 m, e 0.3", std::move(world));
}

/// A box on cables from corners of its lid, or from one corner, thrown about at the start.
Case thrown_box(const std::string& name, int cables, double restitution, int start) {
  Draw draw(static_cast<std::uint64_t>(start));
  const double half = 0.5 * box_side;
  World world;
  world.seed = static_cast<std::uint64_t>(start);
  world.loads.push_back(free_box(2.0, Vec3(0.0, top - 2.0, 0.0)));
  const std::vector<Vec3> corners = {Vec3(-half, half, -half), Vec3(half, half, half),
                                     Vec3(-half, half, half), Vec3(half, half, -half)};
  for (int cable = 0; cable < cables; ++cable) {
    const Vec3& corner = corners[static_cast<std::size_t>(cable)];
    const Vec3 above(corner.x(), top, corner.z());
    tie(world, {0, corner}, {-1, above}, 0.0, restitution);
  }
  // from above, so that no cable begins overstretched
  Load& load = world.loads.front();
  load.position.y() += draw.between(0.0, 0.5);
  load.velocity = draw.within(2.0, false);
  load.spin = draw.within(3.0, false);
  return swinging(name, std::move(world));
}

Case moving_platform() {
  const double half = 0.5;
  World world;
  world.loads.push_back({20.0, 0.3, Vec3(0.0, top - 2.0, 0.0), Vec3::Zero(), Vec3::Zero(), false});
  for (const double x : {-half, half}) {
    for (const double z : {-half, half}) {
      const Vec3 hook(x, top, z);
      world.hooks.push_back({hook, Vec3(0.5, 0.1, 0.2), 1.0, 0.0});
      const int index = world.hook(static_cast<int>(world.hooks.size()) - 1);
      tie(world, {0, Vec3(x, 0.1, z)}, {index, Vec3::Zero()}, 0.0, 0.3);
    }
  }
  return swinging("moving platform on 4 cables, e 0.3", std::move(world));
}

void add_mass_ratios(std::vector<Case>& list) {
  for (const double ratio : {50.0, 100.0, 1000.0}) {
    for (const double restitution : {0.0, 0.8, 0.9, 1.0}) {
      for (const double slack : {0.0, 0.1}) {
        char name[64];
        std::snprintf(name, sizeof name, "1:%g in series, e %g, %s", ratio, restitution,
                      slack > 0.0 ? "dropped" : "at rest");
        list.push_back(series_of(name, {1.0, ratio}, 1.0, restitution, slack));
      }
    }
  }
}

std::vector<Case> all_cases() {
  std::vector<Case> list;
  list.push_back(series_of("two balls in series, e 0.5, at rest", {1.0, 1.0}, 1.0, 0.5, 0.0));
  list.push_back(series_of("two balls in series, e 0.5, dropped", {1.0, 1.0}, 1.0, 0.5, 0.3));
  list.push_back(circling_ball());
  for (int start = 0; start < random_starts; ++start) {
    list.push_back(thrown_box("box at a corner, e 0.2", 1, 0.2, start));
  }
  for (int start = 0; start < random_starts; ++start) {
    list.push_back(thrown_box("box on two cables, e 0.3", 2, 0.3, start));
  }
  for (int start = 0; start < random_starts; ++start) {
    list.push_back(thrown_box("box on four cables, e 0.5", 4, 0.5, start));
  }
  const std::vector<double> ten(10, 1.0);
  list.push_back(series_of("chain of 10, e 0.5, at rest", ten, 0.3, 0.5, 0.0));
  list.push_back(series_of("chain of 10, e 0.5, dropped", ten, 0.3, 0.5, 0.02));
  list.push_back(series_of("chain of 10, e 1, dropped", ten, 0.3, 1.0, 0.02));
  list.push_back(moving_platform());
  add_mass_ratios(list);
  return list;
}

}  // namespace

Case series_of(const std::string& name, const std::vector<double>& masses, double length,
               double restitution, double slack) {
  Case result;
  result.name = name;
  result.world.kind = name;
  // elastic loads bounce on for ever once they are dropped
  result.rests = restitution < 1.0 || !(slack > 0.0);
  CableEnd from{-1, Vec3(0.0, top, 0.0)};
  double lengths = 0.0;
  for (std::size_t index = 0; index < masses.size(); ++index) {
    lengths += length;
    const Vec3 rest(0.0, top - lengths, 0.0);
    const Vec3 raised = rest + slack * static_cast<double>(index + 1) * Vec3::UnitY();
    result.world.loads.push_back({masses[index], 0.1, raised, Vec3::Zero(), Vec3::Zero(), false});
    result.world.cables.push_back(
        {{static_cast<int>(index), Vec3::Zero()}, from, length, restitution});
    result.at_rest.push_back(rest);
    double below = 0.0;
    for (std::size_t other = index; other < masses.size(); ++other) {
      below += masses[other] * world_gravity;
    }
    result.tensions.push_back(below);
    from = {static_cast<int>(index), Vec3::Zero()};
  }
  return result;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> list = all_cases();
  return list;
}

CaseFindings findings_of(const Case& the_case, const Playing& playing, double seconds) {
  Run run(the_case.world, playing);
  CaseFindings result;
  run.go_on_until(seconds - 10.0);
  std::vector<double> impulses(the_case.world.cables.size(), 0.0);
  const double start = run.time();
  while (run.time() < seconds && !run.is_over()) {
    run.step();
    const Moment& now = run.now();
    for (std::size_t cable = 0; cable < impulses.size(); ++cable) {
      const CableData& data = the_case.world.cables[cable];
      impulses[cable] += now.impulses[cable];
      result.overstretch =
          std::max(result.overstretch, line_of(data, now.bodies).distance - data.length);
    }
    for (std::size_t load = 0; load < the_case.at_rest.size(); ++load) {
      const Vec3 off = now.bodies[load].position - the_case.at_rest[load];
      result.off = std::max(result.off, off.norm());
    }
  }
  for (std::size_t cable = 0; cable < the_case.tensions.size(); ++cable) {
    const double tension = impulses[cable] / (run.time() - start);
    result.tension_error =
        std::max(result.tension_error, std::abs(tension / the_case.tensions[cable] - 1.0));
  }
  result.findings = run.findings();
  return result;
}

bool is_broken(const Case& the_case, const CaseFindings& found, Stepping stepping) {
  const bool off = the_case.rests &&
                   (!(found.off <= allowed_off) || !(found.tension_error <= allowed_tension_error));
  return off || broken(found.findings, claims(stepping, !the_case.world.hooks.empty())).any();
}

}  // namespace tautline::test
