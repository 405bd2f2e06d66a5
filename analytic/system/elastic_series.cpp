#include <utility>

#include "instantiate.hpp"
#include "system/elastic.hpp"
#include "system/series.hpp"
#include "tautline/detail/series_impl.hpp"
#include "tautline/system_geometry.hpp"

// Elastic cables in the series of a motion (E3): an engaged one pulls by coefficients of
// the poses that are known, so that nothing is solved.

namespace tautline {

using series::number;

template <class Real, int D>
void SystemSeries<Real, D>::find_stretched(const BasicSystemState<Real, D>& start) {
  for (const std::size_t index : start.elastic.stretched() | start.elastic.resisting) {
    const BasicElasticity<Real>& law = *system_->cables[index].elasticity;
    const bool slack = start.elastic.resisting.contains(index);
    const std::size_t past = start.elastic.corners_past(index);
    stretched_.push_back({index,
                          start.elastic.pulling().contains(index),
                          slack,
                          &law,
                          start.elastic.damping[index],
                          delassus(*system_, start, index),
                          slack ? ForcePiece<Real>() : force_piece(law, past),
                          std::vector<std::vector<Real>>(slack ? 0 : law.stiffness.size() - 1),
                          {}});
  }
}

/// Sets coefficient k of the segments and of the gap of a stretched cable, from the poses.
template <class Real, int D>
void SystemSeries<Real, D>::stretch(std::size_t index, std::size_t k) {
  CableSeries& cable = cables_[index];
  cable.gap[k] = cable.length[k];
  for (std::size_t i = 0; i < cable.segments.size(); ++i) {
    SegmentSeries& segment = cable.segments[i];
    segment.along[k] = place(index, i, k) - place(index, i + 1, k);
    set_distance(segment, k, distance_of(segment, k));
    cable.gap[k] -= segment.distance[k].x();
  }
}

/// The coefficients of what the law of a stretched cable takes, with the other sign.
template <class Real, int D>
const Real* SystemSeries<Real, D>::taken(const StretchSeries& one) const {
  return one.law->of_strain ? one.parts.data() : cables_[one.index].gap.data();
}

/// Sets coefficient k of the tension of a stretched cable by (E1), from coefficients up to k + 1 of
/// the poses (E3). Those before are set.
template <class Real, int D>
void SystemSeries<Real, D>::strain(StretchSeries& one, std::size_t k) {
  if (k == 0) {
    stretch(one.index, 0);
  }
  stretch(one.index, k + 1);
  const CableSeries& cable = cables_[one.index];
  if (one.law->of_strain) {
    Real part = cable.gap[k];
    for (std::size_t j = 1; !cable.steady && j <= k; ++j) {
      part -= cable.length[j] * one.parts[k - j];
    }
    one.parts.push_back(part / cable.length[0]);
  }
  const Real* x = taken(one);
  Real tension =
      -one.piece.slope * x[k] - one.damping * Real(number(k + 1)) * Real(cable.gap[k + 1]);
  for (std::size_t p = 0; p < one.powers.size(); ++p) {
    Real power(0);  // of the power p + 2
    for (std::size_t j = 0; j <= k; ++j) {
      power -= x[j] * (p == 0 ? Real(-x[k - j]) : one.powers[p - 1][k - j]);
    }
    one.powers[p].push_back(power);
    tension += one.law->stiffness[p + 1] * power;
  }
  if (k == 0 && one.piece.constant != 0) {
    tension += one.piece.constant;
  }
  cables_[one.index].tension[k] = tension;
}

/// Adds coefficient k of the pulls of an engaged cable.
template <class Real, int D>
void SystemSeries<Real, D>::pull(const StretchSeries& one, std::size_t k) {
  CableSeries& cable = cables_[one.index];
  for (std::size_t i = 0; i < cable.segments.size(); ++i) {
    SegmentSeries& segment = cable.segments[i];
    Vector pull = Vector::Constant(cable.tension[k]);
    if (k > 0) {
      pull -= series::products(segment.distance, segment.pull, k, 1, k + 1);
    }
    segment.pull[k] = pull / segment.distance[0].x();
    pull_segment(one.index, i, k);
  }
}

/// Sets what the motion of the bodies leaves open: all of a loose cable, the last term of an
/// engaged one.
template <class Real, int D>
void SystemSeries<Real, D>::expand_stretched(StretchSeries& one) {
  for (std::size_t k = 0; !one.pulls && k + 2 <= order_; ++k) {
    strain(one, k);
  }
  stretch(one.index, order_);
}

/// The force that the terms of a stretched cable's tension are small against [N]: it may fall to 0.
/// `load`: the largest weight.
template <class Real, int D>
Real SystemSeries<Real, D>::tension_scale(const StretchSeries& one, const Real& load) const {
  const CableSeries& cable = cables_[one.index];
  const Real stretch = one.slack ? Real(0) : Real(-cable.gap[0]);
  const Real& length = cable.length[0];
  constexpr double roundings = 4.0;  // of a gap
  return tension_size(*one.law, length, one.damping, one.response, stretch, Real(-cable.gap[1])) +
         load +
         roundings * epsilon<Real>() * abs(spring_stiffness(*one.law, stretch, length)) * length;
}

template <class Real, int D>
std::vector<Real> SystemSeries<Real, D>::beyond(std::size_t index, const Real& corner) const {
  const CableSeries& cable = cables_[index];
  const bool of_strain = system_->cables[index].elasticity->of_strain;
  return series::polynomial<Real>(order_ + 1, [&](std::size_t k) {
    const Real base = of_strain ? cable.length[k] : Real(k == 0 ? 1 : 0);
    return Real(-cable.gap[k] - corner * base);
  });
}

/// Adds the power [W] with which the changing length of a stretched cable changes what its law of
/// strain stores: that is L E(x) at the strain x, and grows with L by E - x f.
template <class Real, int D>
void SystemSeries<Real, D>::add_power(const StretchSeries& one, const Unit& unit,
                                      std::vector<Real>& result) const {
  const CableSeries& cable = cables_[one.index];
  if (!one.law->of_strain || cable.steady || one.slack) {
    return;
  }
  const auto strain = series::polynomial<Real>(
      one.parts.size(), [&](std::size_t k) { return unit.of(Real(-one.parts[k]), k); });
  const auto lengthening = unit.rate_of(order_ + 1, [&](std::size_t k) { return cable.length[k]; });
  std::vector<Real> growth{one.piece.energy};
  std::vector<Real> power = strain;
  for (std::size_t i = 1; i <= one.law->stiffness.size(); ++i) {
    const Real& k = i == 1 ? one.piece.slope : one.law->stiffness[i - 1];
    const Real factor = -k * series::number(i) / series::number(i + 1);
    std::vector<Real> next;
    series::add_product(next, power, strain);
    power = std::move(next);
    series::add_product(growth, {factor}, power);
  }
  series::add_product(result, growth, lengthening);
}

template void SystemSeries<Instance, instance_dimension>::find_stretched(
    const StateOf<InstanceCase>&);
template void SystemSeries<Instance, instance_dimension>::strain(StretchSeries&, std::size_t);
template void SystemSeries<Instance, instance_dimension>::pull(const StretchSeries&, std::size_t);
template void SystemSeries<Instance, instance_dimension>::expand_stretched(StretchSeries&);
template Instance SystemSeries<Instance, instance_dimension>::tension_scale(const StretchSeries&,
                                                                            const Instance&) const;
template std::vector<Instance> SystemSeries<Instance, instance_dimension>::beyond(
    std::size_t, const Instance&) const;
template void SystemSeries<Instance, instance_dimension>::add_power(
    const StretchSeries&, const series::TimeUnit<Instance>&, std::vector<Instance>&) const;

}  // namespace tautline
