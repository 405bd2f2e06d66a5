#include "simultaneous.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "linearised.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// True where a + b is `sum` and nothing was rounded: Knuth's sum without error.
bool add_up_to(double a, double b, double sum) {
  const double of_b = sum - a;
  return a + b == sum && (a - (sum - of_b)) + (b - of_b) == 0.0;
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

/// `a` + `b` - `c` where nothing is rounded.
std::optional<double> exact_sum(double a, double b, double c) {
  const double sum = a + b;
  const double all = sum - c;
  return add_up_to(a, b, sum) && add_up_to(sum, -c, all) ? std::optional(all) : std::nullopt;
}

bool rebound_alike(const Cable& a, const Cable& b) {
  return a.restitution == b.restitution && a.capture_speed == b.capture_speed &&
         std::equal(a.restitution_table.begin(), a.restitution_table.end(),
                    b.restitution_table.begin(), b.restitution_table.end(),
                    [](const RestitutionPoint& one, const RestitutionPoint& other) {
                      return one.speed == other.speed && one.restitution == other.restitution;
                    });
}

/// Where the attachment of `cable` starts from its anchor, of a body that is not turned; none where
/// that is rounded.
std::optional<Vec2> exact_reach(const Case& the_case, const Cable& cable) {
  const Vec2& position = the_case.initial.position;
  const auto x = exact_sum(position.x(), cable.attachment.x(), cable.anchor.x());
  const auto y = exact_sum(position.y(), cable.attachment.y(), cable.anchor.y());
  return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

/// The motion of a body that is its own mirror image: along an axis through its centre, without a
/// turn, for ever, whatever the cables do that are each other's images.
class Mirror {
 public:
  /// The axis is that of y where `across` is 0, of x where it is 1.
  Mirror(const Case& the_case, Eigen::Index across)
      : case_(the_case), across_(across), along_(1 - across) {}

  /// True where gravity, the start and the cables of `all` have the symmetry, and images rebound
  /// alike.
  [[nodiscard]] bool holds(const Hit& hit) const {
    const State& start = case_.initial;
    return case_.gravity[across_] == 0.0 && start.angle == 0.0 && start.spin == 0.0 &&
           start.velocity[across_] == 0.0 && has_images(hit.now, false) &&
           has_images(hit.earlier, true);
  }

  /// True where `cables` are taut at one place on the axis: congruent, or exactly there.
  [[nodiscard]] bool close_at_one_place(CableSet cables) const {
    const Cable& first = case_.cables[*cables.begin()];
    const auto reach = exact_reach(case_, first);
    bool congruent = reach.has_value();
    bool images = cables.size() == 2;  // the sums of both are rounded alike
    for (const std::size_t index : cables) {
      const Cable& other = case_.cables[index];
      const auto its = exact_reach(case_, other);
      congruent = congruent && its && other.length == first.length &&
                  std::abs((*its)[across_]) == std::abs((*reach)[across_]) &&
                  (*its)[along_] == (*reach)[along_];
      images = images && (index == *cables.begin() || are_images(first, other));
    }
    return congruent || images || are_taut_at_one_place(cables);
  }

 private:
  [[nodiscard]] bool are_images(const Cable& a, const Cable& b) const {
    return a.length == b.length && a.attachment[across_] == -b.attachment[across_] &&
           a.attachment[along_] == b.attachment[along_] && a.anchor[along_] == b.anchor[along_] &&
           add_up_to(a.anchor[across_], b.anchor[across_], 2.0 * case_.initial.position[across_]);
  }

  [[nodiscard]] bool has_images(CableSet cables, bool rebounding) const {
    for (const std::size_t index : cables) {
      bool found = false;
      for (const std::size_t other : cables) {
        const Cable& a = case_.cables[index];
        const Cable& b = case_.cables[other];
        found = found || (are_images(a, b) && (!rebounding || rebound_alike(a, b)));
      }
      if (!found) {
        return false;
      }
    }
    return true;
  }

  /// True where a double is a place at which all gaps are zero to the last bit.
  [[nodiscard]] bool are_taut_at_one_place(CableSet cables) const {
    for (const std::size_t index : cables) {
      const Cable& cable = case_.cables[index];
      const double aside =
          case_.initial.position[across_] + cable.attachment[across_] - cable.anchor[across_];
      const double reach = std::sqrt(cable.length * cable.length - aside * aside);
      for (const double side : {-reach, reach}) {
        State there = case_.initial;
        there.position[along_] = cable.anchor[along_] - cable.attachment[along_] + side;
        if (are_exactly_taut(case_, there, cables)) {
          return true;
        }
      }
    }
    return false;
  }

  const Case& case_;
  Eigen::Index across_;
  Eigen::Index along_;
};

/// True where the body moves without a turn, and all cables so far are one cable at several places
/// of it, between which its centre is: it moves as a point on that cable.
bool moves_as_a_point(const Case& the_case, const Hit& hit) {
  const State& start = the_case.initial;
  const Cable& first = the_case.cables[*hit.now.begin()];
  const auto reach = exact_reach(the_case, first);
  if (start.angle != 0.0 || start.spin != 0.0 || !reach) {
    return false;
  }
  bool left = false;
  bool right = false;
  for (const std::size_t index : hit.now | hit.earlier) {
    const Cable& cable = the_case.cables[index];
    const auto its = exact_reach(the_case, cable);
    if (!its || *its != *reach || cable.length != first.length) {
      return false;
    }
    if (hit.earlier.empty()) {
      continue;  // nothing has turned it yet
    }
    // how far the force of the cable passes the centre, to both sides of it
    const double aside = cross(cable.attachment, *reach);
    left = left || aside <= 0.0;
    right = right || aside >= 0.0;
    if (!rebound_alike(cable, first)) {
      return false;
    }
  }
  // along the motion the direction changes, but where it falls along the cable
  const bool straight =
      cross(*reach, the_case.gravity) == 0.0 && cross(*reach, start.velocity) == 0.0;
  return hit.earlier.empty() || (left && right && straight);
}

/// The delay of all cables of `hit`, which do not come apart: an error that the symmetry has not
/// delays one as much as it hastens the other.
std::optional<StateRow> mean_delay(const Case& the_case, const State& state, CableSet hit) {
  StateRow sum = StateRow::Zero();
  for (const std::size_t index : hit) {
    const auto delay = delay_derivative(the_case, state, CableSet::of(index));
    if (!delay) {
      return std::nullopt;
    }
    sum += *delay;
  }
  return StateRow(sum / static_cast<double>(hit.size()));
}

/// True where a symmetry makes the cables taut at one instant. One cable after the other may break
/// it: it holds where nothing is seen of that in the last bit.
bool are_in_step(const Case& the_case, ImpactLaw law, const State& state, const Hit& hit) {
  const bool untouched = state.angle == 0.0 && state.spin == 0.0;
  if (hit.now.empty() || (law == ImpactLaw::sequential && hit.earlier.size() > 1 && !untouched)) {
    return false;
  }
  if (law != ImpactLaw::energetic && moves_as_a_point(the_case, hit)) {
    return true;
  }
  for (const Eigen::Index across : {0, 1}) {
    const Mirror mirror(the_case, across);
    const bool aside = law == ImpactLaw::sequential && state.velocity[across] != 0.0;
    if (!aside && mirror.holds(hit) && mirror.close_at_one_place(hit.now)) {
      return true;
    }
  }
  return false;
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

std::optional<StateRow> delay_of(const Case& the_case, ImpactLaw law, const State& state,
                                 const Hit& hit) {
  const auto delay = delay_derivative(the_case, state, hit.now);
  return delay || !are_in_step(the_case, law, state, hit) ? delay
                                                          : mean_delay(the_case, state, hit.now);
}

bool merges_after(const Case& the_case, ImpactLaw law, const Solution& solution, std::size_t arc) {
  const double from = solution.arcs()[arc].start;
  CableSet taut = solution.arcs()[arc].taut;
  CableSet met;
  for (const Event& event : solution.events()) {
    const CableSet earlier = std::exchange(met, met | event.cables);
    if (event.time <= from) {
      continue;
    }
    if (event.kind == EventKind::impact) {
      const CableSet hit = pulled(event) - taut;
      if (hit.size() > 1 && !delay_of(the_case, law, event.before, {earlier, hit})) {
        return true;
      }
    }
    taut = taut_after(event, taut);
  }
  return false;
}

}  // namespace tautline
