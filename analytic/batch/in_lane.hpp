#pragma once

#include <cstddef>

#include "batch/bounce_lanes.hpp"

namespace tautline {

/// Sets the numbers of one lane in what has numbers of all.
struct InLane {
  std::size_t lane;

  void operator()(LaneNumbers& into, double number) const { into.of[lane] = number; }

  void operator()(Pair<LaneNumbers>& into, const Pair<double>& pair) const {
    (*this)(into.x, pair.x);
    (*this)(into.y, pair.y);
  }

  void operator()(FlightWorld<LaneNumbers>& into, const FlightWorld<double>& world) const {
    (*this)(into.gravity, world.gravity);
    (*this)(into.gravity_size, world.gravity_size);
    (*this)(into.mass, world.mass);
    (*this)(into.inertia, world.inertia);
    (*this)(into.per_mass, world.per_mass);
    (*this)(into.per_inertia, world.per_inertia);
    (*this)(into.radius, world.radius);
    (*this)(into.shortest, world.shortest);
  }

  void operator()(Flyer<LaneNumbers>& into, const Flyer<double>& flyer) const {
    (*this)(into.position, flyer.position);
    (*this)(into.angle, flyer.angle);
    (*this)(into.velocity, flyer.velocity);
    (*this)(into.spin, flyer.spin);
    (*this)(into.rate_rounding, flyer.rate_rounding);
    (*this)(into.spin_rounding, flyer.spin_rounding);
  }

  void operator()(FlightCable<LaneNumbers>& into, const FlightCable<double>& cable) const {
    (*this)(into.anchor, cable.anchor);
    (*this)(into.attachment, cable.attachment);
    (*this)(into.length, cable.length);
    (*this)(into.per_length, cable.per_length);
    (*this)(into.radius, cable.radius);
    (*this)(into.operand, cable.operand);
    (*this)(into.restitution, cable.restitution);
    (*this)(into.tried, cable.tried);
  }
};

}  // namespace tautline
