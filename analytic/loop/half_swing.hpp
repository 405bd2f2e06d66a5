#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "tautline/geometry.hpp"
#include "tautline/root_search.hpp"
#include "tautline/series.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// The arcs of a motion from one turning point to another.
template <class Real>
struct HalfSwing {
  std::size_t first;  // arc with the first turning point
  Real from;          // [s], of that point, after the start of that arc
  Real to;            // [s], of the other, after the start of the last arc
  Real period;  // [s]: of the arcs' own lengths, as instants are rounded and its error adds up

  /// The instant of the second turning point [s].
  [[nodiscard]] Real end(const std::vector<BasicArc<Real>>& arcs) const {
    return arcs.back().start + to;
  }
};

/// The Taylor coefficients of an arc, one row each, in the time since `start` [s], by Horner's
/// scheme.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, Eigen::Dynamic, 3> series_from(
    const Eigen::Matrix<Real, Eigen::Dynamic, 3>& series, const Real& start) {
  using Columns = Eigen::Matrix<Real, 4, Eigen::Dynamic>;  // of three numbers, and a zero for speed
  const Eigen::Index terms = series.rows();
  Columns given = Columns::Zero(4, terms);
  given.template topRows<3>() = series.transpose();
  Columns from = Columns::Zero(4, terms);
  for (Eigen::Index left = terms; left-- > 0;) {  // what is there, times start + the new time
    for (Eigen::Index k = terms - 1 - left; k > 0; --k) {
      from.col(k) = from.col(k - 1) + start * from.col(k);
    }
    from.col(0) = given.col(left) + start * from.col(0);
  }
  return from.template topRows<3>().transpose();
}

/// `arc` from `low` [s] after its start on, but for its instants.
template <class Real>
[[nodiscard]] BasicArc<Real> part_of(const BasicArc<Real>& arc, const Real& low) {
  BasicArc<Real> result = arc;
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
[[nodiscard]] std::optional<Real> first_zero_of_rate(const BasicArc<Real>& arc,
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

/// Watches motion on taut cables that leave one degree of freedom for its turning points, at which
/// the whole body is still for an instant. From there it goes back the way it has come, at the same
/// speeds, as time reversed shows, up to the turning point before; and so to and fro for ever. It
/// meets nothing on its way that it has not met on half a swing.
template <class Real>
class HalfSwingWatch {
 public:
  /// Goes on with the last of `arcs`, of `length` [s], which leads to `end` and which `events`
  /// events precede: the first of others begins anew. The half swing that this arc completes, if it
  /// does.
  std::optional<HalfSwing<Real>> follow(const BasicCase<Real>& the_case,
                                        const std::vector<BasicArc<Real>>& arcs,
                                        const BasicState<Real>& end, const Real& length,
                                        std::size_t events) {
    if (events_ != events) {
      *this = {};
      events_ = events;
    }
    const BasicArc<Real>& arc = arcs.back();
    most_ = max(
        most_, max(kinetic_energy(the_case.body, arc.initial), kinetic_energy(the_case.body, end)));
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
    return std::nullopt;
  }

 private:
  /// Where in the first `length` [s] of `arc`, in the time since its start [s], it turns next.
  [[nodiscard]] std::optional<Real> turning_point(const BasicCase<Real>& the_case,
                                                  const BasicArc<Real>& arc,
                                                  const Real& length) const {
    const BasicBody<Real>& body = the_case.body;
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
};

/// The swing of which `half` are the last of `arcs`. Tensions do no work: it is fastest where
/// gravity, having sped it up, begins to slow it down.
template <class Real>
[[nodiscard]] BasicSwing<Real> swing_of(const BasicCase<Real>& the_case,
                                        const HalfSwing<Real>& half,
                                        const std::vector<BasicArc<Real>>& arcs) {
  const BasicVec2<Real>& gravity = the_case.gravity;
  const Vector3<Real> down(gravity.x(), gravity.y(), Real(0));
  Real fastest(0);  // [J]
  const auto note = [&](const BasicState<Real>& state) {
    fastest = max(fastest, kinetic_energy(the_case.body, state));
  };
  for (std::size_t i = half.first; i < arcs.size(); ++i) {
    const bool is_first = i == half.first;
    const bool is_last = i + 1 == arcs.size();
    const bool falls = is_first || gravity.dot(arcs[i].initial.velocity) > 0;
    const bool rises = is_last || gravity.dot(arcs[i + 1].initial.velocity) <= 0;
    if (falls && rises) {
      const Real from = is_first ? half.from : Real(0);
      const Real to = is_last ? half.to : Real(arcs[i].end - arcs[i].start);
      const BasicArc<Real> arc = part_of(arcs[i], from);
      if (const auto lowest = first_zero_of_rate(arc, down, Real(to - from))) {
        note(arc.after(*lowest, gravity));
      }
    }
    if (!is_first) {
      note(arcs[i].initial);
    }
  }
  const Real start = arcs[half.first].after(half.from, gravity).angle;
  const Real end = arcs.back().after(half.to, gravity).angle;
  return {fastest, half.period, min(start, end), max(start, end), Real(abs(Real(end - start)) / 2)};
}

/// `arc` from `high` [s] after its start back to it, but for its instants.
template <class Real>
[[nodiscard]] BasicArc<Real> back_along(const BasicArc<Real>& arc, const Real& high) {
  BasicArc<Real> result = part_of(arc, high);
  for (Eigen::Index k = 1; k < result.series.rows(); k += 2) {
    result.series.row(k) *= Real(-1);
  }
  result.initial.velocity = -result.initial.velocity;
  result.initial.spin = -result.initial.spin;
  return result;
}

/// The arcs of the swing that follows `half`, the end of `arcs`: the way back, and forth again.
template <class Real>
[[nodiscard]] std::vector<BasicArc<Real>> swing_after(const HalfSwing<Real>& half,
                                                      const std::vector<BasicArc<Real>>& arcs) {
  const Real turn = half.end(arcs);
  const Real period = half.period;
  const std::size_t last = arcs.size() - 1;
  std::vector<BasicArc<Real>> result;
  Real now = turn;
  const auto add = [&](BasicArc<Real> arc, const Real& end) {
    arc.start = now;
    arc.end = max(now, end);
    now = arc.end;
    result.push_back(std::move(arc));
  };
  for (std::size_t i = last + 1; i-- > half.first;) {
    const BasicArc<Real>& arc = arcs[i];
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
[[nodiscard]] bool leaves_one_way(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                  CableSet pulling) {
  if (is_point_mass(the_case)) {  // which may turn on and on to the angle's limit
    return pulling.size() == 1 && (!the_case.angle_limit || state.spin == 0);
  }
  return pulling.size() == 2;
}

/// The arcs of a swing from the end of half a swing on, for ever.
template <class Real>
class EndlessSwing {
 public:
  /// After `half`, the end of `arcs`.
  EndlessSwing(const HalfSwing<Real>& half, const std::vector<BasicArc<Real>>& arcs)
      : arcs_(swing_after(half, arcs)),
        period_(half.period),
        started_(arcs.back().start),
        angle_(arcs.back().initial.angle),
        spin_(arcs.back().initial.spin) {}

  /// How its arcs come again, of which `first` is the place of the next.
  [[nodiscard]] BasicRepetition<Real> from(std::size_t first) const {
    return {first, arcs_.size(), period_};
  }

  /// The next arc, which starts `now` [s] and ends with the case at the latest.
  [[nodiscard]] BasicArc<Real> next(const BasicCase<Real>& the_case, const Real& now) {
    BasicArc<Real> arc = arcs_[next_ % arcs_.size()];
    const std::size_t periods = next_ / arcs_.size();
    const Real later = period_ * static_cast<double>(periods);
    ++next_;
    arc.start = now;
    arc.end = min(the_case.duration, Real(arc.end + later));
    if (is_point_mass(the_case)) {  // its own turn is never turned back
      arc.initial.angle = angle_ + spin_ * (now - started_);
      arc.initial.spin = spin_;
      arc.series(0, 2) = arc.initial.angle;
      arc.series(1, 2) = spin_;
    }
    return arc;
  }

 private:
  std::vector<BasicArc<Real>> arcs_;  // of a period
  Real period_;                       // [s]
  // of the arc that the half swing ends on
  Real started_;  // [s]
  Real angle_;    // [rad]
  Real spin_;     // [rad/s]
  std::size_t next_ = 0;
};

}  // namespace tautline
