#include "simultaneous.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "linearised.hpp"

namespace tautline {
namespace {

/// True where a + b is `sum` and nothing was rounded: Knuth's sum without error.
bool add_up_to(double a, double b, double sum) {
  const double of_b = sum - a;
  return a + b == sum && (a - (sum - of_b)) + (b - of_b) == 0.0;
}

/// True where the body and `a` stand to a vertical axis as the body and `b` do, to the last bit.
bool mirrored(const Case& the_case, const State& state, const Cable& a, const Cable& b) {
  return the_case.gravity.x() == 0.0 && state.angle == 0.0 && state.velocity.x() == 0.0 &&
         state.spin == 0.0 && a.length == b.length && a.attachment.x() == -b.attachment.x() &&
         a.attachment.y() == b.attachment.y() && a.anchor.y() == b.anchor.y() &&
         add_up_to(a.anchor.x(), b.anchor.x(), 2.0 * state.position.x());
}

/// The delay of both cables of `hit` where symmetry makes them taut at one instant: an error that
/// the symmetry has not delays one as much as it hastens the other.
std::optional<StateRow> delay_of_images(const Case& the_case, const State& state, CableSet hit) {
  const std::vector<std::size_t> pair = hit.indices();
  if (pair.size() != 2) {
    return std::nullopt;
  }
  const Cable& a = the_case.cables[pair[0]];
  const Cable& b = the_case.cables[pair[1]];
  const auto one = delay_derivative(the_case, state, CableSet::of(pair[0]));
  const auto other = delay_derivative(the_case, state, CableSet::of(pair[1]));
  if (!one || !other || !mirrored(the_case, the_case.initial, a, b) ||
      !mirrored(the_case, state, a, b)) {
    return std::nullopt;
  }
  return StateRow((*one + *other) / 2.0);
}

/// True where the gap is zero and nothing was rounded. False where that is not seen.
bool is_exactly_taut(const Cable& cable, const State& state) {
  if (state.angle != 0.0) {
    return false;
  }
  std::array<double, 3> squares{};
  std::array<double, 3> rests{};
  const auto square = [&](std::size_t index, double value) {
    squares[index] = value * value;
    rests[index] = std::fma(value, value, -squares[index]);
  };
  for (const Eigen::Index axis : {0, 1}) {
    const double point = state.position[axis] + cable.attachment[axis];
    const double reach = point - cable.anchor[axis];
    if (!add_up_to(state.position[axis], cable.attachment[axis], point) ||
        !add_up_to(point, -cable.anchor[axis], reach)) {
      return false;
    }
    square(static_cast<std::size_t>(axis), reach);
  }
  square(2, cable.length);
  return add_up_to(squares[0], squares[1], squares[2]) && add_up_to(rests[0], rests[1], rests[2]);
}

}  // namespace

bool are_exactly_taut(const Case& the_case, const State& state, CableSet cables) {
  for (const std::size_t index : cables) {
    if (!is_exactly_taut(the_case.cables[index], state)) {
      return false;
    }
  }
  return true;
}

std::optional<StateRow> delay_of(const Case& the_case, const State& state, CableSet hit) {
  const auto delay = delay_derivative(the_case, state, hit);
  return delay ? delay : delay_of_images(the_case, state, hit);
}

bool merges_after(const Case& the_case, const Solution& solution, std::size_t arc) {
  const double from = solution.arcs()[arc].start;
  CableSet taut = solution.arcs()[arc].taut;
  for (const Event& event : solution.events()) {
    if (event.time <= from) {
      continue;
    }
    if (event.kind == EventKind::impact) {
      const CableSet hit = pulled(event) - taut;
      if (hit.size() > 1 && !delay_of(the_case, event.before, hit)) {
        return true;
      }
    }
    taut = taut_after(event, taut);
  }
  return false;
}

}  // namespace tautline
