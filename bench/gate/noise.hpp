#pragma once

#include <cstddef>

#include "bench/measure/metric_list.hpp"

namespace tautline::bench {

/// A change counts as noise up to these. All but the last two are for runs on one machine or two:
/// another compiler rounds differently, and the motion amplifies that.
struct Noise {
  /// Of a number that is not itself rounding [-].
  double relative = 1e-6;
  /// What a run's rounding comes to up to the first few impacts: this times the precision of the
  /// engine's numbers over the step. Rounding adds up like a random walk: measured is a tenth.
  double early_rounding = 2.0;
  /// By how much the motion amplifies that up to the predictability horizon [-]: its definition,
  /// 1e-12 that grow to 1e-3.
  double growth = 1e9;
  /// Factor between the extremes of two runs that go beyond the horizon, where each is one draw of
  /// a chaotic motion [-].
  double extremes = 2.0;
  /// Share of the impacts up to the horizon whose match may be lost or won, at least one [-].
  double impacts = 0.02;
  /// Factor between the costs of two machines, or two hours of one [-].
  double cost = 2.0;
  /// The least change that says anything, as a share of the larger value [-]. Errors are shown and
  /// read with two digits; half a unit of the second is up to this share, of 1.0.
  double tolerance = 0.05;
};

/// What the noise of a run's metrics depends on beside their values.
struct NoiseSetting {
  double step = 0.0;              // [s]
  double precision = 0.0;         // [-], distance from 1 to the next number of the engine
  double energy = 1.0;            // [J], the case's scale of energies
  std::size_t exact_impacts = 0;  // up to the horizon
  bool beyond_horizon = false;    // the run goes on after it
};

/// How far two values of `metric`, which is compared at all, may be apart and still be the same, in
/// its unit: by noise or within the tolerance.
[[nodiscard]] double allowed_change(const Metric& metric, double one, double two,
                                    const NoiseSetting& setting, const Noise& noise);

}  // namespace tautline::bench
