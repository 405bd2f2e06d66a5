#include <cmath>
#include <numbers>
#include <utility>

#include "tautline/scenarios.hpp"

namespace tautline {
namespace {

using One = Function<1>::Value;

constexpr double quarter_turn = std::numbers::pi / 2.0;  // cos(x - quarter_turn) = sin(x)

End on_body(std::size_t body, const Vec2& at = Vec2::Zero()) { return {body, at, {}}; }

End in_world(const Vec2& at) { return {std::nullopt, at, {}}; }

/// An end that goes to and fro: at + amplitude sin(frequency t).
End swinging(const Vec2& at, const Vec2& amplitude, double frequency) {
  return {std::nullopt, at, {{}, {{amplitude, frequency, -quarter_turn}}}};
}

CableOfSystem cable(End from, End to, double length, double restitution) {
  CableOfSystem result;
  result.from = std::move(from);
  result.to = std::move(to);
  result.length = Function<1>::constant(length);
  result.restitution = restitution;
  return result;
}

/// The same, elastic: with the damping ratio that belongs to its restitution.
CableOfSystem elastic_cable(End from, End to, double length, double stiffness, double restitution) {
  CableOfSystem result = cable(std::move(from), std::move(to), length, 1.0);
  result.elasticity.emplace().stiffness = {stiffness};
  result.elasticity->damping_ratio = damping_ratio_of(restitution);
  return result;
}

/// A system without bodies or cables, in SI units.
System empty_system(const std::string& name, const Vec2& gravity, double duration) {
  System result;
  result.name = name;
  result.gravity = Function<2>::constant(gravity);
  result.duration = duration;
  return result;
}

void add_body(System& system, const std::string& name, double mass, double inertia,
              const State& start) {
  BodyOfSystem& body = system.bodies.emplace_back();
  body.name = name;
  body.mass = mass;
  body.inertia = inertia;
  system.initial.bodies.push_back(start);
}

State at_rest(const Vec2& position) { return {position, 0.0, Vec2(0.0, 0.0), 0.0}; }

/// The standard breakwater, nondimensional.
System standard_breakwater(const std::string& name, double duration) {
  System result = as_system(breakwater(table_5_1().front().parameters, name));
  result.bodies.front().name = "breakwater";
  result.duration = duration;
  return result;
}

System breakwater_in_waves() {
  System result = standard_breakwater("breakwater-in-waves", 12.0);
  BodyOfSystem& body = result.bodies.front();
  body.drag = 0.05;
  body.spin_drag = 0.0005;
  body.force.waves = {{Vec2(0.3, 0.1), 1.7, 0.3}, {Vec2(0.1, 0.25), 3.1, -1.0}};
  body.moment.waves = {{One(0.005), 1.7, 0.8}};
  return result;
}

System shaken_breakwater() {
  System result = standard_breakwater("breakwater-shaken", 12.0);
  for (CableOfSystem& cable : result.cables) {
    cable.to = swinging(cable.to.at, Vec2(0.1, 0.0), 2.0);
  }
  return result;
}

System breakwater_and_ball() {
  System result = standard_breakwater("breakwater-and-ball", 6.0);
  for (CableOfSystem& cable : result.cables) {
    cable.restitution = 0.8;
  }
  add_body(result, "ball", 0.5, 0.0, {Vec2(0.25, -0.2), 0.0, Vec2(-0.5, 0.3), 0.0});
  result.cables.push_back(cable(on_body(1), on_body(0, Vec2(0.0, -0.05)), 0.4, 0.7));
  return result;
}

/// A ball on a cable whose anchor goes up and down, nondimensional. It meets the end of its cable
/// at each period of the anchor, 2, if it starts at speed 1. The phase makes the anchor rise at
/// 1/3 then, which gives back what the impact takes.
System bouncer(const std::string& name, double amplitude) {
  constexpr double push = 1e-3;  // from that motion
  const double phase = std::acos(1.0 / (3.0 * amplitude * std::numbers::pi));
  System result = empty_system(name, Vec2(0.0, -1.0), 60.0);
  add_body(result, "ball", 1.0, 0.0,
           {Vec2(0.0, amplitude * std::sin(phase) - 1.0), 0.0, Vec2(0.0, 1.0 + push), 0.0});
  result.cables = {cable(on_body(0), in_world(Vec2(0.0, 0.0)), 1.0, 0.5)};
  result.cables.front().to.motion.waves = {
      {Vec2(0.0, amplitude), std::numbers::pi, phase - quarter_turn}};
  return result;
}

System winch() {
  System result = empty_system("winch", Vec2(0.0, -9.81), 2.0);
  add_body(result, "load", 1.0, 0.02, {Vec2(0.02, -1.2), 0.0, Vec2(0.1, 0.0), 0.0});
  result.cables = {cable(on_body(0, Vec2(0.03, 0.1)), in_world(Vec2(0.0, 0.0)), 1.0, 0.3),
                   cable(on_body(0, Vec2(0.1, 0.0)), in_world(Vec2(0.5, -0.1)), 1.6, 0.5)};
  result.cables.front().length = Function<1>::linear({0.2, 1.4}, {One(1.25), One(0.65)});
  return result;
}

System buoy_heave() {
  System result = empty_system("buoy-heave", Vec2(0.0, -9.81), 8.0);
  add_body(result, "buoy", 600.0, 0.0, at_rest(Vec2(0.0, -20.0)));
  result.cables = {cable(on_body(0), swinging(Vec2(0.0, 0.0), Vec2(0.0, 1.0), 4.0), 20.0, 0.0)};
  return result;
}

System two_bodies() {
  System result = empty_system("two-bodies", Vec2(0.0, 0.0), 1.0);
  add_body(result, "thrown", 2.0, 0.0, {Vec2(0.3, 0.0), 0.0, Vec2(7.0, 0.0), 0.0});
  add_body(result, "pulled", 1.5, 0.0, at_rest(Vec2(0.0, 0.0)));
  result.cables = {cable(on_body(0), on_body(1), 1.0, 0.0)};
  return result;
}

System pulley() {
  System result = empty_system("pulley", Vec2(0.0, -9.81), 1.0);
  add_body(result, "block", 1.0, 0.0, at_rest(Vec2(-1.0, 0.0)));
  result.bodies.front().force = Function<2>::constant(Vec2(0.0, 9.81));  // of the table
  add_body(result, "weight", 1.0, 0.0, at_rest(Vec2(0.0, -0.5)));
  CableOfSystem string = cable(on_body(0), on_body(1), 1.5, 0.0);
  string.through = {in_world(Vec2(0.0, 0.0))};
  // the second one ends the slide after half a metre
  result.cables = {string, cable(on_body(0), in_world(Vec2(-1.25, 0.0)), 0.75, 0.0)};
  return result;
}

System peg() {
  System result = empty_system("peg", Vec2(0.0, -10.0), 1.5);
  add_body(result, "heavy", 0.3, 0.0, at_rest(Vec2(-0.1, 0.09)));
  add_body(result, "light", 0.1, 0.0, at_rest(Vec2(0.1, 0.09)));
  CableOfSystem string = cable(on_body(0), on_body(1), 2.02, 0.0);
  string.through = {in_world(Vec2(-0.1, 1.0)), in_world(Vec2(0.1, 1.0))};
  // the others are the floor: neither hangs lower than 0
  result.cables = {string, cable(on_body(0), in_world(Vec2(-0.1, 1.0)), 1.0, 0.0),
                   cable(on_body(1), in_world(Vec2(0.1, 1.0)), 1.0, 0.0)};
  return result;
}

System chain_of_three() {
  System result = empty_system("chain-of-three", Vec2(0.0, 0.0), 12.0);
  add_body(result, "left", 1.0, 0.02, {Vec2(0.0, 0.0), 0.0, Vec2(-1.0, 0.2), 3.0});
  add_body(result, "middle", 2.0, 0.05, {Vec2(0.5, 0.1), 0.0, Vec2(0.1, 0.0), -2.0});
  add_body(result, "right", 1.5, 1.0 / 30.0, {Vec2(1.0, -0.1), 0.0, Vec2(0.8, -0.3), 1.0});
  result.cables = {cable(on_body(0, Vec2(0.05, 0.02)), on_body(1, Vec2(-0.1, 0.0)), 0.7, 0.9),
                   cable(on_body(1, Vec2(0.1, 0.0)), on_body(2, Vec2(-0.05, 0.03)), 0.8, 0.9)};
  return result;
}

/// Seen from above: no gravity. The force is the propeller's.
System tow() {
  System result = empty_system("tow", Vec2(0.0, 0.0), 60.0);
  add_body(result, "tug", 20e3, 0.0, at_rest(Vec2(10.0, 0.0)));
  add_body(result, "barge", 60e3, 2e6, at_rest(Vec2(0.0, 0.0)));
  result.bodies[0].drag = 5e3;
  result.bodies[0].force = Function<2>::constant(Vec2(30e3, 0.0));
  result.bodies[1].drag = 8e3;
  result.bodies[1].spin_drag = 5e5;
  result.cables = {cable(on_body(0), on_body(1, Vec2(8.0, 1.0)), 40.0, 0.2)};
  result.cables.front().cut_at = 30.0;
  return result;
}

/// Its anchor speeds up at 1 m/s^2 for 4 s, goes on for 4 s, and stops as gently.
System slung_load() {
  System result = empty_system("slung-load", Vec2(0.0, -9.81), 20.0);
  add_body(result, "load", 500.0, 80.0, at_rest(Vec2(0.0, -6.5)));
  result.cables = {cable(on_body(0, Vec2(0.0, 0.5)), in_world(Vec2(0.0, 0.0)), 6.0, 0.3)};
  result.cables.front().to.motion.pieces = {
      {0.0, {Vec2(0.0, 0.0), Vec2(0.0, 0.0), Vec2(0.5, 0.0)}},
      {4.0, {Vec2(8.0, 0.0), Vec2(4.0, 0.0)}},
      {8.0, {Vec2(24.0, 0.0), Vec2(4.0, 0.0), Vec2(-0.5, 0.0)}},
      {12.0, {Vec2(32.0, 0.0)}}};
  return result;
}

System newtons_cradle() {
  System result = empty_system("newtons-cradle", Vec2(0.0, 0.0), 5.0);
  constexpr int balls = 5;
  for (int i = 0; i < balls; ++i) {
    add_body(result, "ball " + std::to_string(i), 1.0, 0.0,
             {Vec2(i, 0.0), 0.0, Vec2(i + 1 == balls ? 1.0 : 0.0, 0.0), 0.0});
  }
  for (std::size_t i = 0; i + 1 < balls; ++i) {
    result.cables.push_back(cable(on_body(i), on_body(i + 1), 1.0, 1.0));
  }
  return result;
}

System snap() {
  System result = empty_system("snap", Vec2(0.0, -9.81), 3.0);
  add_body(result, "load", 1.0, 0.0, at_rest(Vec2(0.0, -0.5)));
  result.cables = {elastic_cable(on_body(0), in_world(Vec2(0.0, 0.0)), 1.0, 1e4, 0.7)};
  return result;
}

System bungee() {
  System result = empty_system("bungee", Vec2(0.0, -9.81), 30.0);
  add_body(result, "jumper", 80.0, 0.0, at_rest(Vec2(0.0, 0.0)));
  result.cables = {cable(on_body(0), in_world(Vec2(0.0, 0.0)), 20.0, 1.0)};
  Elasticity& cord = result.cables.front().elasticity.emplace();
  cord.stiffness = {160.0};
  cord.damping_ratio = 0.05;
  return result;
}

System elastic_breakwater() {
  System result = standard_breakwater("breakwater-elastic", 6.0);
  for (CableOfSystem& one : result.cables) {
    one = elastic_cable(one.from, one.to, one.length.at(0.0)[0], 1e4, one.restitution);
  }
  return result;
}

/// The rope does not stretch, the strop does.
System elastic_strop() {
  System result = empty_system("elastic-strop", Vec2(0.0, -9.81), 5.0);
  add_body(result, "hook", 10.0, 0.0, at_rest(Vec2(0.0, -0.8)));
  add_body(result, "load", 50.0, 0.0, at_rest(Vec2(0.3, -1.5)));
  result.cables = {cable(on_body(0), in_world(Vec2(0.0, 0.0)), 1.0, 0.3),
                   cable(on_body(1), on_body(0), 1.0, 1.0)};
  Elasticity& strop = result.cables.back().elasticity.emplace();
  strop.stiffness = {2e4};
  strop.damping = 200.0;
  return result;
}

}  // namespace

std::vector<ShippedSystem> shipped_systems() {
  return {
      {breakwater_in_waves(),
       "The breakwater in waves: a force and a moment that swing, and drag. It never rests; how "
       "much of the time its cables are taut, and how hard they snap, is what is asked."},
      {shaken_breakwater(),
       "The breakwater below a support that shakes sideways, 0.1 sin 2t. The support does work at "
       "each impact, so the energy goes up and down."},
      {breakwater_and_ball(),
       "A ball hangs on a cable below the breakwater. Each snap of one cable reaches the others "
       "through the body between them."},
      {bouncer("bouncer-stable", 0.14),
       "A ball on a cable whose anchor vibrates: it snaps once in each period, 2, with impulse 2. "
       "A push of 0.001 halves at each snap, since the amplitude 0.14 is below 0.1547."},
      {bouncer("bouncer-unstable", 0.2),
       "A ball as in bouncer-stable, but its anchor vibrates by 0.2, which is above 0.1547. A push "
       "of 0.001 grows by 2.41 at each snap, until the motion is another one."},
      {winch(),
       "A winch lifts a load from slack, at 0.5 m/s from 0.2 s to 1.4 s. The cable snaps, lifts "
       "the load, goes slack when the winch stops, and snaps again."},
      {buoy_heave(),
       "A moored body of 600 kg below a point that heaves by 1 m, sin 4t. The cable is slack for "
       "61.1 % of the 8 s and snaps with 3530.4 N s in each period."},
      {two_bodies(),
       "2 kg leave at 7 m/s from 1.5 kg at rest, until the string between them is taut. Both go on "
       "at 4 m/s, after an impulse of 6 N s."},
      {pulley(),
       "A block of 1 kg slides on a table, pulled by 1 kg that hangs on a string over a peg: g/2, "
       "4.905 N. The slide ends after 0.5 m, at 2.2147 m/s; the string then stops the weight."},
      {peg(),
       "0.3 kg and 0.1 kg on a string over a peg, 0.09 m above the floor: 5 m/s^2, 1.5 N. The "
       "heavy one lands at 0.948683 m/s; the string snaps later and jerks it off at 0.237171 m/s."},
      {chain_of_three(),
       "Three spinning bodies on two cables, without gravity. Momentum and angular momentum of all "
       "three stay the same while energy is lost at each snap."},
      {tow(),
       "A tug takes up the slack of its line, snaps it taut and tows a barge, seen from above. At "
       "30 s the line is cut: the tug speeds up, the barge drifts to rest."},
      {slung_load(),
       "A load below a vehicle that speeds up, drives on and stops. The load alone moves; the "
       "anchor of its cable is given over time."},
      {snap(),
       "1 kg falls by 0.5 m into an elastic cable of 10 kN/m, whose damping ratio gives a "
       "restitution of 0.7. It snaps seven times, at first with 277.952 N, before it hangs."},
      {bungee(),
       "A jumper of 80 kg falls by 20 m, and is caught by an elastic cord of 160 N/m with a "
       "damping "
       "ratio of 0.05. The largest pull is 2924.64 N, at 3.26727 s; after 21.9 s the cord is "
       "taut."},
      {elastic_breakwater(),
       "The breakwater on elastic cables whose damping ratio gives its restitution, 0.9. Its "
       "first five contacts come in the order of its impacts, up to 48 ms earlier or later: see "
       "`tautline bridge breakwater/1910121100`."},
      {elastic_strop(),
       "A load of 50 kg on an elastic strop below a hook of 10 kg, whose rope does not stretch. "
       "The "
       "rope stops the hook by impacts until 0.322664 s, the strop the load with 2807.26 N."},
      {newtons_cradle(),
       "Five balls in a row on taut strings; the last one is pulled away. Which ball moves after "
       "that depends on the impact law: several strings take part at one instant."}};
}

}  // namespace tautline
