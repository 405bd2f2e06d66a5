#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "tautline/detail/root_search.hpp"
#include "tautline/detail/series.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// The arcs of a motion from one turning point to another, or those of a whole turn.
template <class Real>
struct HalfSwing {
  std::size_t first;  // arc with the first turning point, or at whose start the turn begins
  Real from;          // [s], of that point, after the start of that arc
  Real to;            // [s], of the other, after the start of the last arc
  Real period;  // [s]: of the arcs' own lengths, as instants are rounded and its error adds up
  bool goes_round = false;  // a whole turn: it comes back to its start

  /// The instant at which it ends [s].
  [[nodiscard]] Real end(const std::vector<BasicArc<BasicCase<Real>>>& arcs) const {
    return arcs.back().start + to;
  }
};

/// The body as far as the cables move it: the turn of a point mass is no part of that, whatever its
/// inertia.
template <class Real>
[[nodiscard]] BasicBody<Real> moved_body(const BasicCase<Real>& the_case) {
  return {the_case.body.mass, is_point_mass(the_case) ? Real(0) : the_case.body.inertia};
}

/// The Taylor coefficients of an arc, one row each, in the time since `start` [s], by Horner's
/// scheme.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, Eigen::Dynamic, 3> series_from(
    const Eigen::Matrix<Real, Eigen::Dynamic, 3>& series, const Real& start) {
  const Eigen::Index terms = series.rows();
  using Series = Eigen::Matrix<Real, Eigen::Dynamic, 3>;
  Series backwards = Series::Zero(terms, 3);  // the last coefficient first
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Real* const from = backwards.col(axis).data();
    for (Eigen::Index left = terms; left-- > 0;) {  // what is there, times start + the new time
      for (Eigen::Index k = left; k + 1 < terms; ++k) {
        from[k] = from[k + 1] + start * from[k];
      }
      from[terms - 1] = series(left, axis) + start * from[terms - 1];
    }
  }
  return backwards.colwise().reverse();
}

/// `arc` from `low` [s] after its start on, but for its instants.
template <class Real>
[[nodiscard]] BasicArc<BasicCase<Real>> part_of(const BasicArc<BasicCase<Real>>& arc,
                                                const Real& low) {
  BasicArc<BasicCase<Real>> result = arc;
  if (low > 0) {
    result.series = series_from(arc.series, low);
    result.initial = arc.after(low, BasicVec2<Real>(BasicVec2<Real>::Zero()));
  }
  return result;
}

/// Where in the first `horizon` [s] of `arc`, which is on taut cables, the product of its rates and
/// `weights` falls to zero, in the time since its start [s]; none: nowhere, or overflow. `zeros`: 1
/// where it is zero at the start, else 0.
template <class Real>
[[nodiscard]] std::optional<Real> first_zero_of_rate(const BasicArc<BasicCase<Real>>& arc,
                                                     const Vector3<Real>& weights,
                                                     const Real& horizon, std::size_t zeros = 0) {
  std::vector<Real> rate;
  rate.reserve(static_cast<std::size_t>(arc.series.rows()));
  for (Eigen::Index k = 1; k < arc.series.rows(); ++k) {
    rate.push_back(static_cast<double>(k) * arc.series.row(k).dot(weights));
  }
  const auto zero = first_root_if_any(Polynomial<Real>(rate, zeros), horizon).root;
  return zero && !isnan(*zero) ? zero : std::nullopt;
}

/// Watches motion on taut cables that leave one degree of freedom for its return to a state that it
/// has been in. On its one way the energy gives the speed, so that it returns where it passes the
/// same pose in the same direction. It goes round and round from there on, and meets nothing that
/// it has not met in the first turn.
template <class Real>
class ReturnWatch {
 public:
  /// Goes on with the last of `arcs`, as HalfSwingWatch does. The whole turn that this arc
  /// completes, if it does.
  std::optional<HalfSwing<Real>> follow(const BasicCase<Real>& the_case,
                                        const std::vector<BasicArc<BasicCase<Real>>>& arcs,
                                        const BasicState<Real>& end, const Real& length) {
    const BasicArc<BasicCase<Real>>& arc = arcs.back();
    const BasicBody<Real> body = moved_body(the_case);
    turns_ = !is_point_mass(the_case);
    // a pose at which it is slow tells its direction badly: take one at which it is faster
    const Real energy = kinetic_energy(body, arc.initial);
    if (!start_ || energy > 4 * energy_) {
      start_ = arcs.size() - 1;
      energy_ = energy;
      since_ = length;
      return std::nullopt;
    }
    const BasicState<Real>& from = arcs[*start_].initial;
    const Vector3<Real> weights(body.mass * from.velocity.x(), body.mass * from.velocity.y(),
                                turns_ ? Real(body.inertia * from.spin) : Real(0));
    const Real before = apart(from, arc.initial).dot(weights);
    if (before < 0 && apart(from, end).dot(weights) >= 0) {
      std::vector<Real> way{Real(-before)};  // that is left, which falls to zero
      for (Eigen::Index k = 1; k < arc.series.rows(); ++k) {
        way.push_back(-arc.series.row(k).dot(weights));
      }
      const auto root = first_root_if_any(Polynomial<Real>(way), length).root;
      const Real to = root ? min(*root, length) : length;
      if (returns(the_case, from, arc.after(to, the_case.gravity))) {
        return HalfSwing<Real>{*start_, Real(0), to, Real(since_ + to), true};
      }
    }
    since_ += length;
    return std::nullopt;
  }

 private:
  /// The way from one pose to the other, by less than half a turn.
  [[nodiscard]] Vector3<Real> apart(const BasicState<Real>& from,
                                    const BasicState<Real>& to) const {
    const BasicVec2<Real> way = to.position - from.position;
    if (!turns_) {
      return {way.x(), way.y(), Real(0)};
    }
    const Real full_turn = 2 * pi<Real>();  // [rad]
    const Real angle = to.angle - from.angle;
    return {way.x(), way.y(), Real(angle - full_turn * round(Real(angle / full_turn)))};
  }

  /// True where `state` is `from` again, and no limit of the case comes nearer with each turn.
  /// Rounding is far less than what is allowed, and another place of the way is farther away.
  [[nodiscard]] bool returns(const BasicCase<Real>& the_case, const BasicState<Real>& from,
                             const BasicState<Real>& state) const {
    const Real same = sqrt(epsilon<Real>());  // [-]
    const Vector3<Real> way = apart(from, state);
    const Real size = from.position.norm() + state.position.norm();
    BasicState<Real> change = state;
    change.velocity -= from.velocity;
    change.spin = turns_ ? Real(state.spin - from.spin) : Real(0);
    const bool nearer = turns_ && the_case.angle_limit && abs(Real(state.angle - from.angle)) > 1;
    return !nearer && way.template head<2>().norm() <= same * size && abs(way[2]) <= same &&
           kinetic_energy(moved_body(the_case), change) <= same * same * energy_;
  }

  std::optional<std::size_t> start_;  // arc, with whose start poses are compared
  Real energy_ = Real(0);             // [J], there
  Real since_ = Real(0);              // [s], from there to the start of the next arc
  bool turns_ = false;                // its angle is a part of the motion
};

/// Watches motion on taut cables that leave one degree of freedom for its turning points, at which
/// the whole body is still for an instant. From there it goes back the way it has come, at the same
/// speeds, as time reversed shows, up to the turning point before; and so to and fro for ever. It
/// meets nothing on its way that it has not met on half a swing. A motion that does not turn may
/// return: see ReturnWatch.
template <class Real>
class HalfSwingWatch {
 public:
  /// Goes on with the last of `arcs`, of `length` [s], which leads to `end` and which `events`
  /// events precede: the first of others begins anew. The half swing or the whole turn that this
  /// arc completes, if it does.
  std::optional<HalfSwing<Real>> follow(const BasicCase<Real>& the_case,
                                        const std::vector<BasicArc<BasicCase<Real>>>& arcs,
                                        const BasicState<Real>& end, const Real& length,
                                        std::size_t events) {
    if (events_ != events) {
      *this = {};
      events_ = events;
    }
    const BasicArc<BasicCase<Real>>& arc = arcs.back();
    const BasicBody<Real> body = moved_body(the_case);
    most_ = max(most_, max(kinetic_energy(body, arc.initial), kinetic_energy(body, end)));
    auto turn = turning_point(the_case, arc, length);
    if (turn && !turn_) {
      turn_ = HalfSwing<Real>{arcs.size() - 1, *turn, Real(0), Real(0)};
      since_ = -*turn;
      // an arc of a small swing may be longer than half of it
      const auto next = turning_point(the_case, part_of(arc, *turn), Real(length - *turn));
      turn = next ? std::optional(Real(*turn + *next)) : std::nullopt;
    }
    if (turn) {
      return HalfSwing<Real>{turn_->first, turn_->from, *turn, Real(2 * (since_ + *turn))};
    }
    since_ += length;
    return turn_ ? std::nullopt : round_.follow(the_case, arcs, end, length);
  }

 private:
  /// Where in the first `length` [s] of `arc`, in the time since its start [s], it turns next.
  [[nodiscard]] std::optional<Real> turning_point(const BasicCase<Real>& the_case,
                                                  const BasicArc<BasicCase<Real>>& arc,
                                                  const Real& length) const {
    const BasicBody<Real> body = moved_body(the_case);
    const Vector3<Real> mass(body.mass, body.mass, body.inertia);
    // it turns where its velocity is against that at the start, or against where it goes from there
    const bool still = is_still(body, arc.initial);
    const Vector3<Real> along = arc.series.row(still ? 2 : 1).transpose().cwiseProduct(mass);
    auto turn = first_zero_of_rate(arc, along, length, still ? 1 : 0);
    if (!turn || is_still(body, arc.after(*turn, the_case.gravity))) {
      return turn;
    }
    // it has but changed direction
    const auto next = turning_point(the_case, part_of(arc, *turn), Real(length - *turn));
    return next ? std::optional(Real(*turn + *next)) : std::nullopt;
  }

  [[nodiscard]] bool is_still(const BasicBody<Real>& body, const BasicState<Real>& state) const {
    return kinetic_energy(body, state) <= epsilon<Real>() * most_;
  }

  std::optional<std::size_t> events_;
  std::optional<HalfSwing<Real>> turn_;  // its first turning point
  Real since_ = Real(0);                 // [s], from there to the start of the next arc
  Real most_ = Real(0);                  // [J], of the kinetic energies where arcs start and end
  ReturnWatch<Real> round_;
};

/// The swing of which `half` are the last of `arcs`, on the cables `pulling`. Tensions do no work:
/// it is fastest where gravity, having sped it up, begins to slow it down.
template <class Real>
[[nodiscard]] BasicSwing<Real> swing_of(const BasicCase<Real>& the_case,
                                        const HalfSwing<Real>& half,
                                        const std::vector<BasicArc<BasicCase<Real>>>& arcs,
                                        CableSet pulling) {
  const BasicVec2<Real>& gravity = the_case.gravity;
  const Vector3<Real> down(gravity.x(), gravity.y(), Real(0));
  Real fastest(0);  // [J]
  const auto note = [&](const BasicState<Real>& state) {
    fastest = max(fastest, kinetic_energy(moved_body(the_case), state));
  };
  for (std::size_t i = half.first; i < arcs.size(); ++i) {
    const bool is_first = i == half.first;
    const bool is_last = i + 1 == arcs.size();
    const bool falls = is_first || gravity.dot(arcs[i].initial.velocity) > 0;
    const bool rises = is_last || gravity.dot(arcs[i + 1].initial.velocity) <= 0;
    if (falls && rises && !gravity.isZero(0)) {
      const Real from = is_first ? half.from : Real(0);
      const Real to = is_last ? half.to : Real(arcs[i].end - arcs[i].start);
      const BasicArc<BasicCase<Real>> arc = part_of(arcs[i], from);
      if (const auto lowest = first_zero_of_rate(arc, down, Real(to - from))) {
        note(arc.after(*lowest, gravity));
      }
    }
    if (!is_first || half.goes_round) {
      note(arcs[i].initial);
    }
  }
  const bool turns = !is_point_mass(the_case);
  const SwingAngle body = turns ? SwingAngle::body : SwingAngle::cable;
  if (half.goes_round) {
    return {fastest, half.period, Real(0), Real(0), Real(0), body, true};
  }
  const auto swing = [&](const Real& start, const Real& end, SwingAngle angle) {
    return BasicSwing<Real>{
        fastest, half.period, min(start, end), max(start, end), Real(abs(Real(end - start)) / 2),
        angle};
  };
  const BasicState<Real> start = arcs[half.first].after(half.from, gravity);
  const BasicState<Real> end = arcs.back().after(half.to, gravity);
  const BasicSwing<Real> of_body = swing(start.angle, end.angle, SwingAngle::body);
  if (turns && of_body.amplitude > sqrt(epsilon<Real>())) {
    return of_body;
  }
  const BasicCable<Real>& cable = the_case.cables[*pulling.begin()];
  const BasicSwing<Real> of_cable = swing(cable_angle(cable, start, gravity),
                                          cable_angle(cable, end, gravity), SwingAngle::cable);
  // the turn of a body that its cables do not turn is rounding
  return turns && of_body.amplitude > sqrt(epsilon<Real>()) * of_cable.amplitude ? of_body
                                                                                 : of_cable;
}

/// `arc` from `high` [s] after its start back to it, but for its instants.
template <class Real>
[[nodiscard]] BasicArc<BasicCase<Real>> back_along(const BasicArc<BasicCase<Real>>& arc,
                                                   const Real& high) {
  BasicArc<BasicCase<Real>> result = part_of(arc, high);
  for (Eigen::Index k = 1; k < result.series.rows(); k += 2) {
    result.series.row(k) *= Real(-1);
  }
  result.initial.velocity = -result.initial.velocity;
  result.initial.spin = -result.initial.spin;
  return result;
}

/// The arcs of the swing that follows `half`, the end of `arcs`: the way back, and forth again.
template <class Real>
[[nodiscard]] std::vector<BasicArc<BasicCase<Real>>> swing_after(
    const HalfSwing<Real>& half, const std::vector<BasicArc<BasicCase<Real>>>& arcs) {
  const Real turn = half.end(arcs);
  const Real period = half.period;
  const std::size_t last = arcs.size() - 1;
  std::vector<BasicArc<BasicCase<Real>>> result;
  Real now = turn;
  const auto add = [&](BasicArc<BasicCase<Real>> arc, const Real& end) {
    arc.start = now;
    arc.end = max(now, end);
    now = arc.end;
    result.push_back(std::move(arc));
  };
  for (std::size_t i = last + 1; i-- > half.first;) {
    const BasicArc<BasicCase<Real>>& arc = arcs[i];
    add(back_along(arc, i == last ? half.to : Real(arc.end - arc.start)),
        i == half.first ? Real(turn + period / 2) : Real(turn + (turn - arc.start)));
  }
  for (std::size_t i = half.first; i <= last; ++i) {
    add(part_of(arcs[i], i == half.first ? half.from : Real(0)),
        i == last ? Real(turn + period) : Real(arcs[i].end + period));
  }
  return result;
}

/// True where the cables `pulling` leave one way to move, and no limit of the case but those on it.
template <class Real>
[[nodiscard]] bool has_one_freedom(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                   CableSet pulling) {
  if (is_point_mass(the_case)) {  // which may turn on and on to the angle's limit
    return pulling.size() == 1 && (!the_case.angle_limit || state.spin == 0);
  }
  return pulling.size() == 2;
}

/// Lets the motion of which `half` are the last of `arcs` repeat to the duration of the case:
/// appends what a whole period lacks. None where the duration ends it before.
template <class Real>
[[nodiscard]] std::optional<BasicRepetition<Real>> repetition_of(
    const BasicCase<Real>& the_case, const HalfSwing<Real>& half,
    std::vector<BasicArc<BasicCase<Real>>>& arcs) {
  const bool turns = !is_point_mass(the_case);
  const Real end = half.end(arcs);
  arcs.back().end = min(the_case.duration, end);
  std::size_t first = half.first;
  const BasicState<Real> start = arcs[first].initial;
  Real turn = turns ? Real(arcs.back().after(half.to, the_case.gravity).angle - start.angle)
                    : Real(half.period * start.spin);
  if (!half.goes_round) {
    turn = turns ? Real(0) : turn;
    first = arcs.size();
    const Real started = arcs.back().start;
    const Real angle = arcs.back().initial.angle;
    arcs.back().end = end;  // the way back starts there
    for (BasicArc<BasicCase<Real>>& arc : swing_after(half, arcs)) {
      if (!(arc.start < the_case.duration)) {
        break;
      }
      if (!turns) {  // its own turn is never turned back
        arc.initial.angle = angle + start.spin * (arc.start - started);
        arc.initial.spin = start.spin;
        arc.series(0, 2) = arc.initial.angle;
        arc.series(1, 2) = start.spin;
      }
      arc.end = min(the_case.duration, arc.end);
      arcs.push_back(std::move(arc));
    }
  }
  return arcs.back().end < the_case.duration
             ? std::optional(BasicRepetition<Real>{first, half.period, turn, the_case.duration})
             : std::nullopt;
}

}  // namespace tautline
