#include <algorithm>

#include "instantiate.hpp"
#include "system/series.hpp"
#include "tautline/detail/series_impl.hpp"

// The work along a motion, from its series.

namespace tautline {

using series::add_product;
using series::polynomial;

/// Adds the power of gravity, force, moment and drag on a body [W].
template <class Real, int D>
void SystemSeries<Real, D>::add_power(const BodySeries& body, const Unit& unit,
                                      std::vector<Real>& result) const {
  for (Eigen::Index axis = 0; axis < D; ++axis) {
    const auto velocity =
        unit.rate_of(order_ + 1, [&](std::size_t k) { return body.position[k][axis]; });
    const auto force = polynomial<Real>(order_, [&](std::size_t k) {
      Real sum = -body.body->drag * velocity[k];
      sum += gravity_.empty() ? Real(0) : Real(body.body->mass * unit.of(gravity_[k][axis], k));
      return Real(sum + (body.force.empty() ? Real(0) : unit.of(body.force[k][axis], k)));
    });
    add_product(result, force, velocity);
  }
  if (body.turning.turns()) {
    body.turning.add_power(order_, unit, result);
  }
}

/// Adds the power of what changes the length of a taut cable and moves its ends [W]. `terms`: how
/// many of its pulls at an end.
template <class Real, int D>
void SystemSeries<Real, D>::add_power(const CableSeries& cable, std::size_t terms, const Unit& unit,
                                      std::vector<Real>& result) const {
  if (!cable.steady) {
    const auto tension = polynomial<Real>(
        cable.tension.size(), [&](std::size_t k) { return unit.of(cable.tension[k], k); });
    const auto slackening =
        unit.rate_of(order_ + 1, [&](std::size_t k) { return Real(-cable.length[k]); });
    add_product(result, tension, slackening);
  }
  for (std::size_t end = 0; end < cable.ends.size(); ++end) {
    if (cable.ends[end].empty()) {
      continue;
    }
    for (Eigen::Index axis = 0; axis < D; ++axis) {
      std::vector<Real> pull;  // of the support, away from the cable
      const auto add = [&](const SegmentSeries& segment, int sign) {
        const auto tight = polynomial<Real>(
            order_ - 1, [&](std::size_t k) { return unit.of(segment.pull[k][0], k); });
        const auto along = polynomial<Real>(order_ + 1, [&](std::size_t k) {
          return unit.of(Real(sign * segment.along[k][axis]), k);
        });
        add_product(pull, tight, along);
      };
      if (end < cable.segments.size()) {
        add(cable.segments[end], 1);
      }
      if (end > 0) {
        add(cable.segments[end - 1], -1);
      }
      pull.resize(std::min(pull.size(), terms));
      const auto velocity =
          unit.rate_of(order_ + 1, [&](std::size_t k) { return cable.ends[end][k][axis]; });
      add_product(result, pull, velocity);
    }
  }
}

template <class Real, int D>
Real SystemSeries<Real, D>::work(const Real& dt) const {
  const Unit unit(dt);
  std::vector<Real> power;
  for (const BodySeries& body : bodies_) {
    add_power(body, unit, power);
  }
  for (const std::size_t index : taut_) {
    add_power(cables_[index], 2 * order_, unit, power);
  }
  for (const StretchSeries& one : stretched_) {
    if (one.pulls) {
      // Its distance may grow by itself within an arc. The series of tension / distance then has no
      // sum, but its product with the segment is the tension's own: exact term by term.
      add_power(cables_[one.index], order_ - 1, unit, power);
    }
    add_power(one, unit, power);
  }
  return unit.integral(power);
}

template <class Real, int D>
Real SystemSeries<Real, D>::dissipated(std::size_t index, const Real& dt) const {
  const auto one = std::find_if(stretched_.begin(), stretched_.end(),
                                [&](const StretchSeries& each) { return each.index == index; });
  const CableSeries& cable = cables_[index];
  const Unit unit(dt);
  std::vector<Real> power;
  if (one->pulls) {
    const auto rate = unit.rate_of(order_ + 1, [&](std::size_t k) { return cable.gap[k]; });
    add_product(
        power,
        polynomial<Real>(rate.size(), [&](std::size_t k) { return Real(one->damping * rate[k]); }),
        rate);
    return unit.integral(power);
  }
  const auto stored = [&](const Real& time) {
    return spring_energy(*one->law, Real(-Polynomial<Real>(cable.gap).at(time).value),
                         Polynomial<Real>(cable.length).at(time).value);
  };
  add_power(*one, unit, power);
  return stored(Real(0)) - stored(dt) + unit.integral(power);
}

template Instance SystemSeries<Instance, instance_dimension>::work(const Instance&) const;
template Instance SystemSeries<Instance, instance_dimension>::dissipated(std::size_t,
                                                                         const Instance&) const;

}  // namespace tautline
