#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bench/data/says.hpp"
#include "tautline/case.hpp"
#include "tautline/settling.hpp"
#include "tautline/system_turning.hpp"

// The members of cases, states and settling by their names in JSON. A visitor is called with each
// name, member, and what the schema says of it: Writer, Reader and Describer are such visitors.

namespace tautline::bench {

template <>
struct Words<EventKind> {
  static constexpr std::array all = {EventKind::impact, EventKind::taut, EventKind::slack,
                                     EventKind::entry, EventKind::exit};
};

template <class Visitor>
void fields(Visitor& visit, State& state) {
  visit("position", state.position, "of the centre of mass [m]");
  visit("angle", state.angle, "[rad]");
  visit("velocity", state.velocity, "[m/s]");
  visit("spin", state.spin, "[rad/s]");
}

template <class Visitor>
void fields(Visitor& visit, SpatialState& state) {
  visit("position", state.position, "of the centre of mass [m]");
  visit("orientation", state.orientation,
        "from the body's axes to the world's, a unit quaternion w, x, y, z");
  visit("velocity", state.velocity, "[m/s]");
  visit("spin", state.spin, "in the body's axes [rad/s]");
}

template <class Visitor>
void fields(Visitor& visit, Body& body) {
  visit("mass", body.mass);
  visit("inertia", body.inertia);
}

/// Writes and describes a cable; a case file is what is read.
template <class Visitor>
void fields(Visitor& visit, Cable& cable) {
  visit("anchor", cable.anchor, "[m]");
  visit("attachment", cable.attachment, "from the centre of mass, in the body's frame [m]");
  visit("length", cable.length, "[m]");
  visit("restitution", cable.restitution);
  std::optional<double> capture_speed;
  if (cable.capture_speed != 0.0) {  // exactly: the default
    capture_speed = cable.capture_speed;
  }
  visit.if_any("capture_speed", capture_speed, "a slower impact does not rebound [m/s]");
  std::optional<std::vector<Vec2>> table;
  for (const RestitutionPoint& point : cable.restitution_table) {
    (table ? *table : table.emplace()).emplace_back(point.speed, point.restitution);
  }
  visit.if_any("restitution_table", table, "closing speeds [m/s], each with the restitution there");
}

/// Writes and describes a case with the keys of a case file, which is what is read.
template <class Visitor>
void fields(Visitor& visit, Case& the_case) {
  visit("name", the_case.name);
  visit("duration", the_case.duration, "[s]");
  visit("gravity", the_case.gravity, "[m/s^2]");
  visit.if_any("angle_limit", the_case.angle_limit, "of |angle| [rad]");
  visit.if_any("ceiling", the_case.ceiling, "height [m]");
  visit("body", the_case.body);
  visit("cables", the_case.cables);
  visit("initial", the_case.initial);
}

template <class Visitor>
void fields(Visitor& visit, LastImpact& last) {
  visit("speed", last.speed, "impacts that close faster than this [m/s]");
  visit("time", last.time, "of the last of them [s]; null without one");
}

}  // namespace tautline::bench
