#include <cassert>
#include <cmath>
#include <numbers>
#include <random>

#include "problems.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/geometry.hpp"

namespace tautline::peers {
namespace {

constexpr double shallowest = 1e-12;  // [m], of depths; 1e4 roundings of the cable's length
constexpr double deepest = 1e-2;      // [m]
constexpr double least_bend = 0.5;    // [m/s^2], of the gap there: it opens again within its width
constexpr double open_at_start = 1e-3;  // [m], at least
constexpr double afterwards = 0.1;      // [s], that a run goes on
constexpr int samples = 200;            // of the gap before, which must be positive

/// Uniform in [low, high), the same on any machine.
double uniform(std::mt19937_64& bits, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(bits() >> 11U), -53);
}

/// The gap of a cable of length 1 from the origin, `time` after the start, in long doubles.
long double precise_gap(const Case& the_case, double time) {
  const State& start = the_case.initial;
  const long double t = time;
  const long double angle = start.angle + t * start.spin;
  const Vec2& arm = the_case.cables.front().attachment;
  const auto along = [&](int axis) {
    return start.position[axis] + t * start.velocity[axis] + t * t / 2 * the_case.gravity[axis];
  };
  const long double x = along(0) + std::cos(angle) * arm.x() - std::sin(angle) * arm.y();
  const long double y = along(1) + std::sin(angle) * arm.x() + std::cos(angle) * arm.y();
  return 1 - std::sqrt(x * x + y * y);
}

/// One draw, which may not be a graze.
Graze draw(std::mt19937_64& bits) {
  constexpr double pi = std::numbers::pi;
  Graze result;
  Case& the_case = result.the_case;
  const double size = uniform(bits, 0.0, 0.3);  // [m]
  const double at = uniform(bits, -pi, pi);
  the_case.name = "graze";
  the_case.body.inertia = 0.02;
  the_case.cables.push_back(
      {.attachment = {size * std::cos(at), size * std::sin(at)}, .restitution = 0.9});
  result.depth = std::pow(10.0, uniform(bits, std::log10(shallowest), std::log10(deepest)));
  result.deepest = uniform(bits, 0.3, 1.0);

  State there;
  there.angle = uniform(bits, -pi, pi);
  there.spin = uniform(bits, -6.0, 6.0);
  const double direction = uniform(bits, -pi, pi);
  const double across = uniform(bits, -2.0, 2.0);  // [m/s]
  const Vec2 along(std::cos(direction), std::sin(direction));
  const Vec2 arm = attachment_arm(there, the_case.cables.front());
  there.position = (1.0 + result.depth) * along - arm;
  there.velocity = across * perpendicular(along) - there.spin * perpendicular(arm);
  the_case.initial = fly(there, the_case.gravity, -result.deepest);
  the_case.duration = result.deepest + afterwards;
  const Vec2 acceleration = the_case.gravity - there.spin * there.spin * arm;
  const double bend = -(across * across / (1.0 + result.depth) + along.dot(acceleration));
  result.width = bend > least_bend ? std::sqrt(2.0 * result.depth / bend) : 0.0;
  return result;
}

/// Whether the gap bends upwards at its smallest, and is positive until shortly before.
bool is_graze(const Graze& draw) {
  const double until = draw.deepest - 2.0 * draw.width;
  if (draw.width == 0.0 || until <= 0.0 || precise_gap(draw.the_case, 0.0) < open_at_start) {
    return false;
  }
  for (int sample = 1; sample <= samples; ++sample) {
    if (precise_gap(draw.the_case, until * sample / samples) <= 0.0L) {
      return false;
    }
  }
  return precise_gap(draw.the_case, draw.deepest) < -draw.depth / 2;
}

}  // namespace

std::vector<Graze> grazes(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  std::vector<Graze> result;
  while (result.size() < count) {
    Graze candidate = draw(bits);
    if (is_graze(candidate)) {
      result.push_back(std::move(candidate));
    }
  }
  return result;
}

bool has_graze(const Graze& graze, const std::vector<Located>& found) {
  return !found.empty() && std::abs(found.front().time - graze.deepest) <= 2.0 * graze.width;
}

Stop stop_of(const Graze& graze) { return {graze.the_case.duration, 1}; }

}  // namespace tautline::peers
