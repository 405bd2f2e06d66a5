#include <algorithm>

#include "instantiate.hpp"
#include "system/series.hpp"
#include "tautline/detail/series_impl.hpp"

// The work along a motion, from its series.

namespace tautline {

using series::add_product;
using series::number;
using series::polynomial;
using series::rate_of;

/// Adds the power of gravity, force, moment and drag on a body [W].
template <class Real, int D>
void SystemSeries<Real, D>::add_power(const BodySeries& body, std::vector<Real>& result) const {
  for (Eigen::Index axis = 0; axis < D; ++axis) {
    const auto velocity =
        rate_of<Real>(order_ + 1, [&](std::size_t k) { return body.position[k][axis]; });
    const auto force = polynomial<Real>(order_, [&](std::size_t k) {
      Real sum = -body.body->drag * velocity[k];
      sum += gravity_.empty() ? Real(0) : Real(body.body->mass * gravity_[k][axis]);
      return Real(sum + (body.force.empty() ? Real(0) : body.force[k][axis]));
    });
    add_product(result, force, velocity);
  }
  if (body.turning.turns()) {
    body.turning.add_power(order_, result);
  }
}

/// Adds the power of what changes the length of a taut cable and moves its ends [W].
template <class Real, int D>
void SystemSeries<Real, D>::add_power(const CableSeries& cable, std::vector<Real>& result) const {
  const auto slackening =
      rate_of<Real>(order_ + 1, [&](std::size_t k) { return Real(-cable.length[k]); });
  if (!cable.steady) {
    add_product(result, {cable.tension.begin(), cable.tension.end()}, slackening);
  }
  for (std::size_t end = 0; end < cable.ends.size(); ++end) {
    if (cable.ends[end].empty()) {
      continue;
    }
    for (Eigen::Index axis = 0; axis < D; ++axis) {
      std::vector<Real> pull;  // of the support, away from the cable
      const auto add = [&](const SegmentSeries& segment, int sign) {
        const auto tight =
            polynomial<Real>(order_ - 1, [&](std::size_t k) { return segment.pull[k][0]; });
        const auto along = polynomial<Real>(
            order_ + 1, [&](std::size_t k) { return Real(sign * segment.along[k][axis]); });
        add_product(pull, tight, along);
      };
      if (end < cable.segments.size()) {
        add(cable.segments[end], 1);
      }
      if (end > 0) {
        add(cable.segments[end - 1], -1);
      }
      const auto velocity =
          rate_of<Real>(order_ + 1, [&](std::size_t k) { return cable.ends[end][k][axis]; });
      add_product(result, pull, velocity);
    }
  }
}

template <class Real, int D>
Real SystemSeries<Real, D>::work(const Real& dt) const {
  std::vector<Real> power;
  for (const BodySeries& body : bodies_) {
    add_power(body, power);
  }
  for (const std::size_t index : taut_) {
    add_power(cables_[index], power);
  }
  for (const StretchSeries& one : stretched_) {
    if (one.pulls) {
      add_power(cables_[one.index], power);
    }
    add_power(one, power);
  }
  return series::integral<Real>(power, dt);
}

template <class Real, int D>
Real SystemSeries<Real, D>::dissipated(std::size_t index, const Real& dt) const {
  const auto one = std::find_if(stretched_.begin(), stretched_.end(),
                                [&](const StretchSeries& each) { return each.index == index; });
  const CableSeries& cable = cables_[index];
  std::vector<Real> power;
  if (one->pulls) {
    const auto rate = rate_of<Real>(order_ + 1, [&](std::size_t k) { return cable.gap[k]; });
    add_product(
        power,
        polynomial<Real>(rate.size(), [&](std::size_t k) { return Real(one->damping * rate[k]); }),
        rate);
    return series::integral<Real>(power, dt);
  }
  const auto stored = [&](const Real& time) {
    return spring_energy(*one->law, Real(-Polynomial<Real>(cable.gap).at(time).value),
                         Polynomial<Real>(cable.length).at(time).value);
  };
  add_power(*one, power);
  return stored(Real(0)) - stored(dt) + series::integral<Real>(power, dt);
}

template Instance SystemSeries<Instance, instance_dimension>::work(const Instance&) const;
template Instance SystemSeries<Instance, instance_dimension>::dissipated(std::size_t,
                                                                         const Instance&) const;

}  // namespace tautline
