// What an impact makes of errors.

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "error_flow.hpp"
#include "error_tracker.hpp"
#include "simultaneous.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// The least value [m] that a gap has between two instants `dt` apart and at the second, from its
/// values and rates there (Hermite's cubic). The first instant does not count: it may start at
/// zero.
double least_gap(double g0, double r0, double g1, double r1, double dt) {
  const double a = 2 * (g0 - g1) + dt * (r0 + r1);
  const double b = 3 * (g1 - g0) - dt * (2 * r0 + r1);
  const double c = dt * r0;
  double least = g1;
  const double root = b * b - 3 * a * c;
  if (root > 0.0) {
    const double s = (-b + std::sqrt(root)) / (3 * a);  // where the second derivative is positive
    const double at = std::abs(a) > 1e-9 * std::abs(b) ? s : -c / (2 * b);
    if (at > 0.0 && at < 1.0 && (a != 0.0 || b > 0.0)) {
      least = std::min(least, ((a * at + b) * at + c) * at + g0);
    }
  }
  return least;
}

/// The derivatives of the impulses of `active` cables, whose restitution is constant, under
/// Newton's law, in closed form: with G L = -(1 + E) rate,
///   G dL = -(1 + E) d rate - dJ M^-1 J^T L - J M^-1 dJ^T L,
/// and row i of dJ w is w times the curvature of gap i.
Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 3, 6> impulse_slopes(
    const Case& the_case, const CableViews& views, const Event& event, CableSet active,
    const Eigen::Vector3d& change, const Eigen::Matrix3d& turned) {
  const auto count = static_cast<Eigen::Index>(active.size());
  const Eigen::Vector3d weight = inverse_mass(the_case.body);
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> j(count, 3);
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 3, 6> right(count, 6);
  Eigen::Index row = 0;
  for (const std::size_t index : active) {
    const CableView& view = views[index];
    j.row(row) = view.gradient().transpose();
    right.row(row) = -(1.0 + the_case.cables[index].restitution) * view.rate_row(event.before);
    right.row(row).head<3>() -= change.transpose() * view.curvature();
    right.row(row).head<3>() -= j.row(row) * weight.asDiagonal() * turned;
    ++row;
  }
  if (count == 1) {
    return right / j.row(0).cwiseAbs2().dot(weight);
  }
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> g =
      j * weight.asDiagonal() * j.transpose();
  return g.inverse() * right;
}

}  // namespace

/// Looks at the cables at the pose of `state`.
void ErrorTracker::look_at(const State& state) {
  if (!seen_ || state.position != seen_->position || state.angle != seen_->angle) {
    views_ = cable_views(case_, state);
    seen_ = state;
  }
}

/// How much earlier than in `event` the first of `hit` may become taut [s].
double ErrorTracker::earlier(const Event& event, CableSet hit) const {
  double result = 0.0;
  for (const std::size_t index : hit) {
    const auto delay = delay_derivative(case_, event.before, CableSet::of(index));
    result = std::max(result, delay ? bound(*delay, now_.topLeftCorner<6, 6>()) : event.time);
  }
  return result;
}

/// Adds the error of the instant at which `hit` become taut. False where first order does not say
/// what happens.
bool ErrorTracker::arrive(const Event& event, CableSet hit) {
  look_at(before_->initial);
  start_views_ = views_;
  look_at(event.before);
  double place = 0.0;
  for (const std::size_t index : hit) {
    place = std::max(place, gap_error(index, event.before));
  }
  now_.diagonal().head<2>().array() += place * place;
  if (!order_is_sure(event)) {
    return false;
  }
  const auto delay = delay_of(event, hit);
  if (!delay) {  // which of them is first is open; what is before them is not
    tie_ = hit.size() > 1 ? std::optional(Tie{EventKind::impact, hit}) : std::nullopt;
    sure_to_ = std::max(sure_to_, event.time - earlier(event, hit));
    return false;
  }
  const StateMatrix squares = now_.topLeftCorner<6, 6>();
  if (!(bound(*delay, squares) <= trusted_part * (event.time - before_->start))) {
    return false;
  }
  const double dt = before_->end - before_->start;
  const StateVector rate_then = rate_at(*before_, dt, event.before, case_.gravity);
  now_ = delayed(now_, *delay, rate_then);
  // where the rounded gap is zero the gap is not: what the delay has taken out of the pose stays
  double early = 0.0;  // [s]
  for (const std::size_t index : hit) {
    early = std::max(early, place / std::abs(views_[index].rate(event.before)));
  }
  add_late(now_, early * early, rate_then);
  StateVector moved = rate_then.cwiseAbs();  // the instant is a double, and the gap closed there
  for (const std::size_t index : hit) {
    moved.head<2>().array() += std::abs(views_[index].rate(event.before));
  }
  add_errors(now_, one_rounding * dt * moved);
  for (const std::size_t index : hit) {
    const Cable& cable = case_.cables[index];
    const double rate = views_[index].rate(event.before);
    const double error =
        bound(views_[index].rate_row(event.before), now_.topLeftCorner<6, 6>(), curvature_);
    if (!(error <= trusted_part * std::abs(rate)) ||
        (depends_on_speed(cable) && std::abs(-rate - cable.capture_speed) <= error)) {
      return false;
    }
    curvature_ = std::max(curvature_, error / rate * (error / rate));
  }
  now_(6, 6) += tick_square(event.time);
  return true;
}

std::optional<StateRow> ErrorTracker::delay_of(const Event& event, CableSet hit) const {
  return tautline::delay_of(case_, options_.law, event.before, {met_, hit});
}

/// True where no cable that stays slack along the arc before `event` might have been hit.
bool ErrorTracker::order_is_sure(const Event& event) const {
  const double dt = before_->end - before_->start;
  const StateMatrix squares = now_.topLeftCorner<6, 6>();
  for (std::size_t index = 0; index < case_.cables.size(); ++index) {
    if (event.cables.contains(index) || before_->taut.contains(index)) {
      continue;
    }
    const double least =
        least_gap(start_views_[index].gap(), start_views_[index].rate(before_->initial),
                  views_[index].gap(), views_[index].rate(event.before), dt);
    const double rounding = bound_margin * 2 * one_rounding * gap_scale(case_, index, event.before);
    if (!(bound(views_[index].gap_row(), squares) + rounding <= least)) {
      return false;
    }
  }
  return true;
}

/// What the impact's results gain per unit of the state before: in closed form under Newton's law.
ErrorTracker::Kick ErrorTracker::kick_of(const Event& event) const {
  const CableSet pulling = pulled(event);
  const CableSet active = pulling.size() > 1 ? basis(case_, event.before, pulling) : pulling;
  bool speeds = false;
  for (const std::size_t index : active) {
    speeds = speeds || depends_on_speed(case_.cables[index]);
  }
  const bool newton = options_.law == ImpactLaw::simultaneous || event.cables.size() == 1 ||
                      active != pulling;  // of which differences would break the tie
  if (!newton || (speeds && active == pulling)) {
    const auto slopes = rebound_slopes(case_, options_.law, event, taut_);
    return {slopes.after.bottomRows<3>() - StateMatrix::Identity().bottomRows<3>(),
            slopes.impulses};
  }
  Kick result;
  result.impulses.setZero(event.impulses.size(), 6);
  if (active.empty()) {
    return result;
  }
  const Eigen::Vector3d weight = inverse_mass(case_.body);
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  // J^T L
  Eigen::Matrix3d turned = Eigen::Matrix3d::Zero();    // its derivative at constant impulses
  Eigen::Index row = 0;
  for (const std::size_t index : event.cables) {
    if (const double impulse = event.impulses[row++]; impulse > 0.0) {
      momentum += impulse * views_[index].gradient();
      turned += impulse * views_[index].curvature();
    }
  }
  const auto slopes =
      impulse_slopes(case_, views_, event, active, momentum.cwiseProduct(weight), turned);
  result.velocity.leftCols<3>() = turned;
  row = 0;
  Eigen::Index of_active = 0;
  for (const std::size_t index : event.cables) {
    if (active.contains(index)) {
      result.velocity += views_[index].gradient() * slopes.row(of_active);
      result.impulses.row(row) = slopes.row(of_active++);
    }
    ++row;
  }
  if (active != pulling) {  // the others share with these: none changes by more than all of them
    const StateRow all = slopes.colwise().sum();
    row = 0;
    for (const std::size_t index : event.cables) {
      if (pulling.contains(index)) {
        result.impulses.row(row) = all;
      }
      ++row;
    }
  }
  result.velocity = (weight.asDiagonal() * result.velocity).eval();
  return result;
}

EventErrors ErrorTracker::take_impact(const Event& event) {
  look_at(event.before);
  const StateMatrix squares = now_.topLeftCorner<6, 6>();
  EventErrors errors{bound(now_(6, 6)),
                     0.0,
                     CableVector(event.impulses.size()),
                     bounds(squares, sizes_, event.before),
                     {},
                     {}};
  const double unit = 2 * one_rounding * std::max(fastest_, sizes_.speed(event.before));
  const Eigen::Vector3d weight = inverse_mass(case_.body);
  const Kick kick = kick_of(event);
  double fastest = 0.0;
  StateVector rounding = StateVector::Zero();  // what that of the rates makes of the velocities
  Eigen::Index row = 0;
  for (const std::size_t index : event.cables) {
    const CableView& view = views_[index];
    if (const double rate = -view.rate(event.before); rate >= fastest) {
      fastest = rate;
      errors.rate = bound(view.rate_row(event.before), squares, curvature_) + bound_margin * unit;
    }
    const Eigen::Vector3d gradient = view.gradient();
    const double off = unit / gradient.cwiseAbs2().dot(weight);
    errors.impulses[row] = bound(StateRow(kick.impulses.row(row)), squares, curvature_) +
                           bound_margin * (one_rounding * std::abs(event.impulses[row]) + off);
    rounding.tail<3>() += off * gradient.cwiseProduct(weight).cwiseAbs();
    ++row;
  }
  if (row > 1) {  // nearly dependent cables share it out by large impulses that almost cancel
    const CableSet rows = basis(case_, event.before, event.cables);
    rounding /= std::max(delassus(case_, event.before, rows).ldlt().rcond(), epsilon<double>());
  }
  now_ = kicked(now_, kick.velocity);
  add_errors(now_, rounding);
  errors.after = bounds(now_.topLeftCorner<6, 6>(), sizes_, event.after);
  errors.indeterminate = indeterminate(options_.law, case_, event);
  return errors;
}

}  // namespace tautline
