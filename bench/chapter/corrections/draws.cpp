#include "bench/chapter/corrections/draws.hpp"

#include <cmath>
#include <random>

#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// Numbers that are the same with every standard library, which the distributions are not.
class Draw {
 public:
  [[nodiscard]] double between(double low, double high) {
    constexpr double unit = 0x1p-53;
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * unit;
  }

 private:
  std::mt19937_64 engine_{chapter_seed};
};

Breakwater any_breakwater(Draw& draw) {
  Breakwater body;
  body.r = draw.between(1.2, 3.0);
  body.e = draw.between(0.0, 1.0);
  body.a = draw.between(0.05, 0.4);
  body.b = draw.between(0.0, 0.4);
  body.shape = Shape::box;
  return body;
}

State any_motion(Draw& draw) {
  State state;
  state.position = {draw.between(-0.3, 0.3), draw.between(-0.2, 0.6)};
  state.angle = draw.between(-1.5, 1.5);
  state.velocity = {draw.between(-1.0, 1.0), draw.between(-1.0, 1.0)};
  state.spin = draw.between(-3.0, 3.0);
  return state;
}

constexpr std::size_t draws = 10'000;

}  // namespace

Share slope_signs_wrong() {
  Draw draw;
  Share result{0, 0};
  for (std::size_t index = 0; index < draws; ++index) {
    const Breakwater body = any_breakwater(draw);
    const Case the_case = breakwater(body, "any");
    const Cable& right = the_case.cables[1];
    State state = any_motion(draw);
    const double s = std::sin(state.angle);
    const double c = std::cos(state.angle);
    const double across = 1.0 - state.position.x() - body.a * c + body.b * s;
    if (std::abs(across) >= body.r || across == 0.0) {  // no such pose, or no sign to have
      continue;
    }
    const double down = std::sqrt(body.r * body.r - across * across);
    state.position.y() = right.anchor.y() - body.a * s - body.b * c - down;  // Eq. 5.65
    const auto gradient = gap_gradient(right, state);
    const double slope = -gradient[0] / gradient[1];
    result.times += slope * (across / down) < 0.0 ? 1U : 0U;  // Eq. 5.66
    ++result.of;
  }
  return result;
}

Share spins_kept() {
  Draw draw;
  Share result{0, 0};
  for (std::size_t index = 0; index < draws; ++index) {
    const Case the_case = breakwater(any_breakwater(draw), "any");
    const Cable& cable = the_case.cables[index % 2];
    State before = any_motion(draw);
    const Vec2 u = (attachment_point(before, cable) - cable.anchor).normalized();
    before.position += gap(cable, before) * u;
    if (gap_rate(cable, before) >= 0.0) {  // not an impact: it would be if it ran backwards
      before.velocity = -before.velocity;
      before.spin = -before.spin;
    }
    const State after = newton_impact(the_case, before, CableSet::of(index % 2)).after;
    result.times += before.spin * after.spin > 0.0 ? 1U : 0U;
    ++result.of;
  }
  return result;
}

}  // namespace tautline::bench
