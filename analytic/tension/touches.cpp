// Where the tension of a taut cable touches zero, and where taut cables pass a dead point.

#include <algorithm>
#include <array>
#include <utility>

#include "instantiate.hpp"
#include "sensitivity/linearised.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/detail/rows.hpp"
#include "tautline/geometry.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline {
namespace {

/// Tensions this small against the forces of the motion, and sines whose squares are, are looked
/// at: errors that are larger are trusted nowhere [-].
constexpr double near_zero = 1e-2;

/// A square of a sine up to this is that of a dead point [-]: three quarters of the digits.
template <class Real>
Real rounding_of_zero() {
  const Real half = sqrt(epsilon<Real>());
  return half * sqrt(half);
}

/// Something that depends on the state along an arc, as a function of the time since its start.
template <class Real, class Value>
class AlongArc {
 public:
  AlongArc(const BasicCase<Real>& the_case, const BasicArc<BasicCase<Real>>& arc, Value value)
      : case_(the_case), arc_(arc), value_(std::move(value)) {
    const Real scale = acceleration_scale(the_case, arc.initial);
    // differences of fourth roots: the rounding of a second derivative is then its square root; an
    // arc's series holds for a few lengths of the arc
    const Real most = (arc.end - arc.start) / 4;
    step_ = min(most, Real(sqrt(Real(shortest_length(the_case) / scale)) *
                           sqrt(Real(sqrt(epsilon<Real>())))));
  }

  [[nodiscard]] Real at(const Real& time) const { return value_(arc_.after(time, case_.gravity)); }

  /// Where its parabola at the end of the arc, of `length` [s], is least: from values within the
  /// arc.
  [[nodiscard]] std::optional<BasicTouch<Real>> bottom_beyond(const Real& length) const {
    return bottom(Real(length - step_));
  }

  /// Where its parabola at `time` is least; none where it bends down.
  [[nodiscard]] std::optional<BasicTouch<Real>> bottom(const Real& time) const {
    const Real here = at(time);
    const Real later = at(Real(time + step_));
    const Real earlier = at(Real(time - step_));
    const Real slope = (later - earlier) / (2 * step_);
    const Real bend = (later - 2 * here + earlier) / (step_ * step_);
    if (!(bend > 0)) {
      return std::nullopt;
    }
    return BasicTouch<Real>{{}, {}, time - slope / bend, here - slope * slope / (2 * bend), bend};
  }

  /// The minimum near `time`, by Newton's method.
  [[nodiscard]] std::optional<BasicTouch<Real>> minimum(Real time) const {
    constexpr int enough = 12;  // from a part of an arc: it doubles the digits each time
    for (int iteration = 0; iteration < enough; ++iteration) {
      const auto found = bottom(time);
      if (!found) {
        return std::nullopt;
      }
      const bool done = abs(Real(found->time - time)) <= step_;
      time = found->time;
      if (done) {
        return BasicTouch<Real>{{}, {}, time, at(time), found->bend};
      }
    }
    return std::nullopt;
  }

 private:
  const BasicCase<Real>& case_;
  const BasicArc<BasicCase<Real>>& arc_;
  Value value_;
  Real step_;  // [s]
};

/// True where an event of `kind` with one of `cables`, or any if no kind is given, is at `time`.
template <class Real>
bool has_event(const BasicSolution<BasicCase<Real>>& solution, const Real& time, CableSet cables,
               std::optional<EventKind> kind) {
  const auto& events = solution.events();
  auto event = std::lower_bound(events.begin(), events.end(), time,
                                [](const BasicEvent<BasicCase<Real>>& one, const Real& instant) {
                                  return one.time < instant;
                                });
  for (; event != events.end() && event->time == time; ++event) {
    if (!kind || (event->kind == *kind && !(event->cables & cables).empty())) {
      return true;
    }
  }
  return false;
}

/// False where the parabola through three values stays above `most`, with a margin for what an
/// arc, a part of the radius of convergence, bends more.
template <class Real>
bool comes_near(const Real& start, const Real& middle, const Real& end, const Real& most) {
  const Real low = min(start, min(middle, end));
  const Real high = max(start, max(middle, end));
  constexpr double margin = 0.5;  // [-]
  return low - margin * (high - low) <= most;
}

/// Which ends of an arc a minimum may lie at.
struct Ends {
  bool start;     // false: the motion, or this taut motion, starts there
  bool releases;  // at the end, beyond which the motion is no longer this one
};

/// Where `along` has a minimum up to `most` in an arc of this length [s].
template <class Real, class Value>
std::vector<BasicTouch<Real>> minima(const AlongArc<Real, Value>& along, const Real& length,
                                     const Real& most, Ends ends) {
  std::vector<BasicTouch<Real>> result;
  const auto add = [&](const std::optional<BasicTouch<Real>>& found) {
    if (found && found->value <= most) {
      result.push_back(*found);
    }
  };
  if (!comes_near(along.at(Real(0)), along.at(Real(length / 2)), along.at(length), most)) {
    return result;
  }
  if (ends.releases) {
    add(along.bottom_beyond(length));
  }
  constexpr int parts = 8;
  const Real near_end = length * 1e-6;  // of two arcs that meet at a minimum either may have it
  std::array<Real, parts + 1> values;
  for (int part = 0; part <= parts; ++part) {
    values[static_cast<std::size_t>(part)] = along.at(Real(length * part / parts));
  }
  for (std::size_t part = ends.start ? 0 : 1; part <= (ends.releases ? parts - 1U : parts);
       ++part) {
    const bool falls = part == 0 || values[part] <= values[part - 1];
    const bool rises = part == parts || values[part] <= values[part + 1];
    if (falls && rises) {
      const auto found = along.minimum(Real(length * static_cast<double>(part) / parts));
      if (found && found->time >= -near_end && found->time <= length + near_end) {
        add(found);
      }
    }
  }
  return result;
}

/// True where `cables`, all taut in `state`, are at a dead point, and leave it if the body turns.
template <class Real>
bool is_dead_point(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                   CableSet cables) {
  if (cables.size() < 2 || !(independence(the_case, state, cables) <= rounding_of_zero<Real>())) {
    return false;
  }
  constexpr double aside = 1e-3;  // [rad]
  BasicState<Real> turned = state;
  turned.angle += Real(aside);
  // cables side by side at one point are alike at every pose
  return independence(the_case, turned, cables) > Real(aside * aside * aside);
}

}  // namespace

template <class Real>
BasicCableVector<Real> tensions(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                CableSet pulling) {
  BasicCableVector<Real> free(static_cast<Eigen::Index>(pulling.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : pulling) {
    free[row++] = free_gap_acceleration(the_case, index, state);
  }
  return -multipliers(the_case, state, pulling, free);
}

template <class Real>
Real independence(const BasicCase<Real>& the_case, const BasicState<Real>& state, CableSet cables) {
  const RowsOf<BasicCase<Real>> shapes =
      CableRows<BasicCase<Real>>(the_case, state, cables).shapes();
  Real largest(0);
  for (Eigen::Index i = 0; i < shapes.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const Vector3<Real> a = shapes.row(i).transpose();
      const Vector3<Real> b = shapes.row(j).transpose();
      largest = max(largest, Real(a.cross(b).squaredNorm() / (a.squaredNorm() * b.squaredNorm())));
    }
  }
  return largest;
}

template <class Real>
CableSet dead_at_start(const BasicCase<Real>& the_case) {
  const BasicState<Real>& start = the_case.initial;
  const Real speed = speed_scale(the_case, start);
  if (!(speed > 0)) {
    return {};
  }
  CableSet resting;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const BasicCable<Real>& cable = the_case.cables[index];
    const Real rounding = few_roundings * rounding_of_rate(cable, start);
    if (starts_at_zero(cable, start) && abs(gap_rate(cable, start)) <= rounding) {
      resting.insert(index);
    }
  }
  return is_dead_point(the_case, start, resting) ? resting : CableSet{};
}

template <class Real>
std::vector<BasicTouch<Real>> dead_points(const BasicCase<Real>& the_case,
                                          const BasicSolution<BasicCase<Real>>& solution,
                                          std::size_t index) {
  const BasicArc<BasicCase<Real>>& arc = solution.arcs()[index];
  std::vector<BasicTouch<Real>> result;
  const Real length = arc.end - arc.start;
  if (arc.taut.size() < 2 || arc.series.rows() == 0 || is_rest(arc) || !(length > 0) ||
      basis(the_case, arc.initial, arc.taut).size() < 2) {
    return result;
  }
  const auto value = [&](const BasicState<Real>& state) {
    return independence(the_case, state, arc.taut);
  };
  const AlongArc<Real, decltype(value)> along(the_case, arc, value);
  result = minima<Real>(along, length, Real(near_zero), {true, false});
  for (BasicTouch<Real>& found : result) {
    found.kind = EventKind::taut;
    found.cables = arc.taut;
    found.time += arc.start;
  }
  if (has_event<Real>(solution, arc.end, arc.taut, EventKind::slack)) {
    const Real last = along.at(length);
    const auto bottom = along.bottom_beyond(length);
    if (last <= Real(near_zero) && bottom) {
      result.push_back({EventKind::taut, arc.taut, arc.end, last, bottom->bend});
    }
  }
  return result;
}

template <class Real>
bool passes_dead_point(const BasicCase<Real>& the_case,
                       const BasicSolution<BasicCase<Real>>& solution, const Real& from) {
  for (std::size_t index = solution.arcs().size(); index-- > 0;) {
    if (solution.arcs()[index].start < from) {
      break;
    }
    for (const BasicTouch<Real>& touch : dead_points(the_case, solution, index)) {
      if (touch.value <= rounding_of_zero<Real>()) {
        return true;
      }
    }
  }
  return false;
}

template <class Real>
std::vector<BasicTouch<Real>> touches(const BasicCase<Real>& the_case,
                                      const BasicSolution<BasicCase<Real>>& solution,
                                      std::size_t index) {
  const BasicArc<BasicCase<Real>>& arc = solution.arcs()[index];
  const Real length = arc.end - arc.start;
  std::vector<BasicTouch<Real>> result = dead_points(the_case, solution, index);
  if (arc.series.rows() == 0 || is_rest(arc) || !(length > 0)) {
    return result;
  }
  const CableSet pulling = basis(the_case, arc.initial, arc.taut);
  if (pulling != arc.taut) {  // redundant cables have no tensions of their own
    return result;
  }
  const bool begins = index == 0 || has_event<Real>(solution, arc.start, {}, std::nullopt);
  const Real force = the_case.body.mass * acceleration_scale(the_case, arc.initial);
  Eigen::Index row = 0;
  for (const std::size_t cable : pulling) {
    const CableSet one = CableSet::of(cable);
    const auto value = [&, row](const BasicState<Real>& state) {
      return Real(tensions(the_case, state, pulling)[row]);
    };
    const AlongArc<Real, decltype(value)> along(the_case, arc, value);
    const Ends ends{!begins, has_event<Real>(solution, arc.end, one, EventKind::slack)};
    for (BasicTouch<Real> found : minima<Real>(along, length, Real(near_zero * force), ends)) {
      found.kind = EventKind::slack;
      found.cables = one;
      found.time += arc.start;
      result.push_back(found);
    }
    ++row;
  }
  return result;
}

template BasicCableVector<Instance> tensions(const InstanceCase&, const BasicState<Instance>&,
                                             CableSet);
template Instance independence(const InstanceCase&, const BasicState<Instance>&, CableSet);
template CableSet dead_at_start(const InstanceCase&);
template bool passes_dead_point(const InstanceCase&, const BasicSolution<InstanceCase>&,
                                const Instance&);
template std::vector<BasicTouch<Instance>> touches(const InstanceCase&,
                                                   const BasicSolution<InstanceCase>&, std::size_t);

}  // namespace tautline
