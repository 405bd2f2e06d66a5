#include "bench/cases/bench_case.hpp"

#include <stdexcept>
#include <utility>

namespace tautline::bench {
namespace {

Eigen::Vector3d from_plane(const Vec2& v) { return {v.x(), v.y(), 0.0}; }

/// A turn, or a moment, about the normal of the plane.
Eigen::Vector3d about_normal(const Eigen::Matrix<double, 1, 1>& turn) {
  return {0.0, 0.0, turn[0]};
}

template <int N, class Map>
Function<3> mapped(const Function<N>& function, const Map& map) {
  Function<3> result;
  for (const auto& piece : function.pieces) {
    result.pieces.push_back({piece.from, {}});
    for (const auto& coefficient : piece.coefficients) {
      result.pieces.back().coefficients.push_back(map(coefficient));
    }
  }
  for (const auto& wave : function.waves) {
    result.waves.push_back({map(wave.amplitude), wave.frequency, wave.phase});
  }
  return result;
}

SpatialEnd from_plane(const End& end) {
  return {end.body, from_plane(end.at),
          mapped(end.motion, [](const Vec2& v) { return from_plane(v); })};
}

SpatialState from_plane(const State& state) {
  SpatialState result;
  result.position = from_plane(state.position);
  result.orientation = quaternion_of<double>(Eigen::Vector3d(0.0, 0.0, state.angle));
  result.velocity = from_plane(state.velocity);
  result.spin.z() = state.spin;
  return result;
}

}  // namespace

BenchCase bench_case_from(const std::string& text, const std::string& source_name) {
  SystemReading reading = read_system_text(text, source_name);
  if (reading.in_space) {
    return std::move(*reading.in_space);
  }
  if (!reading.the_case) {
    throw std::runtime_error(reading.problems.empty() ? source_name + ": a system in the plane"
                                                      : reading.problems.front());
  }
  return std::move(*reading.the_case);
}

SpatialSystem in_space(const System& system) {
  const auto vector = [](const Vec2& v) { return from_plane(v); };
  SpatialSystem result;
  result.name = system.name;
  result.duration = system.duration;
  result.gravity = mapped(system.gravity, vector);
  for (const BodyOfSystem& body : system.bodies) {
    result.bodies.push_back({body.name, body.mass, Eigen::Vector3d::Constant(body.inertia),
                             body.drag, body.spin_drag, mapped(body.force, vector),
                             mapped(body.moment, about_normal)});
  }
  for (const State& state : system.initial.bodies) {
    result.initial.bodies.push_back(from_plane(state));
  }
  for (const CableOfSystem& cable : system.cables) {
    SpatialCable& made = result.cables.emplace_back();
    made.from = from_plane(cable.from);
    for (const End& ring : cable.through) {
      made.through.push_back(from_plane(ring));
    }
    made.to = from_plane(cable.to);
    made.length = cable.length;
    made.restitution = cable.restitution;
    made.capture_speed = cable.capture_speed;
    made.elasticity = cable.elasticity;
    made.restitution_table = cable.restitution_table;
    made.from_time = cable.from_time;
    made.cut_at = cable.cut_at;
  }
  return result;
}

}  // namespace tautline::bench
