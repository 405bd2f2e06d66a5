#include "bench/gate/noise.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tautline::bench {

namespace {

double noise_of(const Metric& metric, double one, double two, const NoiseSetting& setting,
                const Noise& noise) {
  assert(metric.noise != NoiseKind::any && "nothing is known of its noise");
  const double rounding = noise.early_rounding * setting.precision / setting.step;
  const double larger = std::max(std::abs(one), std::abs(two));
  const double relative = noise.relative * larger;
  switch (metric.noise) {
    case NoiseKind::early:
      return rounding + relative;
    case NoiseKind::horizon:
      return rounding * noise.growth + relative;
    case NoiseKind::extreme: {
      const double scale = metric.unit == "J" ? setting.energy : 1.0;  // lengths are near 1
      const double draw = larger * (1.0 - 1.0 / noise.extremes);
      return rounding * scale + (setting.beyond_horizon ? draw : relative);
    }
    case NoiseKind::share: {
      const double impacts = std::max(1.0, static_cast<double>(setting.exact_impacts));
      // the two shares are rounded: one impact of many may come out as a little more than one
      return std::max(1.0, noise.impacts * impacts) / impacts + relative;
    }
    case NoiseKind::any:
      break;
  }
  return 0.0;
}

}  // namespace

double allowed_change(const Metric& metric, double one, double two, const NoiseSetting& setting,
                      const Noise& noise) {
  const double tolerance = noise.tolerance * std::max(std::abs(one), std::abs(two));
  return std::max(noise_of(metric, one, two, setting, noise), tolerance);
}

}  // namespace tautline::bench
