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
  for (const std::size_t index : start.elastic.stretched()) {
    const BasicElasticity<Real>& law = *system_->cables[index].elasticity;
    stretched_.push_back({index, start.elastic.engaged.contains(index), &law,
                          start.elastic.damping[index], delassus(*system_, start, index),
                          std::vector<std::vector<Real>>(law.stiffness.size() - 1)});
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

/// Sets coefficient k of the tension of a stretched cable by (E1), from coefficients up to k + 1 of
/// the poses (E3). Those before are set.
template <class Real, int D>
void SystemSeries<Real, D>::strain(StretchSeries& one, std::size_t k) {
  if (k == 0) {
    stretch(one.index, 0);
  }
  stretch(one.index, k + 1);
  const Channel gap = cables_[one.index].gap;  // the stretch, with the other sign
  Real tension = -one.law->stiffness[0] * gap[k] - one.damping * Real(number(k + 1)) * gap[k + 1];
  for (std::size_t p = 0; p < one.powers.size(); ++p) {
    Real power(0);  // of the power p + 2
    for (std::size_t j = 0; j <= k; ++j) {
      power -= gap[j] * (p == 0 ? Real(-gap[k - j]) : one.powers[p - 1][k - j]);
    }
    one.powers[p].push_back(power);
    tension += one.law->stiffness[p + 1] * power;
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
  const Channel gap = cables_[one.index].gap;
  const Real stretch = -gap[0];
  constexpr double roundings = 4.0;  // of a gap
  return tension_size(*one.law, one.damping, one.response, stretch, Real(-gap[1])) + load +
         roundings * epsilon<Real>() * abs(spring_stiffness(*one.law, stretch)) *
             cables_[one.index].length[0];
}

template void SystemSeries<Instance, instance_dimension>::find_stretched(
    const StateOf<InstanceCase>&);
template void SystemSeries<Instance, instance_dimension>::strain(StretchSeries&, std::size_t);
template void SystemSeries<Instance, instance_dimension>::pull(const StretchSeries&, std::size_t);
template void SystemSeries<Instance, instance_dimension>::expand_stretched(StretchSeries&);
template Instance SystemSeries<Instance, instance_dimension>::tension_scale(const StretchSeries&,
                                                                            const Instance&) const;

}  // namespace tautline
