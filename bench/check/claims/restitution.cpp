// A rebound is that over the whole of the contact where an engine takes several steps for it.

#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "bench/check/cases.hpp"
#include "bench/check/hit.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// What a spring that acts over `longest_contact` steps leaves of its restitution, by where in a
/// step the contact begins and ends [-].
constexpr double spring_scatter = 0.02;

/// What the iterations of a solver, or rounding to float, leave of a contact of one step [-].
constexpr double solver_scatter = 2e-3;

/// What a hit showed.
struct Rebound {
  double declared = 0.0;     // [-]
  double restitution = 0.0;  // [-]; not a number if there was no hit
  double limit = 0.0;        // [-], of their difference

  /// Infinite if there was no hit.
  [[nodiscard]] double error() const { return worse(0.0, std::abs(restitution - declared)); }
  [[nodiscard]] bool holds() const { return error() <= limit; }
};

/// The one that is further beyond its limit, or nearer to it.
const Rebound& worse_of(const Rebound& a, const Rebound& b) {
  return b.error() / b.limit > a.error() / a.limit ? b : a;
}

/// The first hit of `the_case`, a `Case` or a `SpatialSystem`. While a contact lasts, the rate
/// changes by the gap's acceleration in flight, which is gravity's part and the turning of the
/// cable. A contact of one step, or one that is located, is given one step of it; a spring's the
/// longest fair contact, and its scatter.
template <class TheCase>
Rebound rebound(const Subject& subject, const TheCase& the_case, double step, double end) {
  const auto& cable = the_case.cables.front();
  Rebound result{cable.restitution, std::nan(""), solver_scatter};
  if (const auto hit = first_hit(subject, the_case, step, end)) {
    const bool spring = hit->steps > 1;
    const double before = gap_rate(cable, hit->before);
    result.restitution = -gap_rate(cable, hit->after) / before;
    result.limit = (spring ? spring_scatter : solver_scatter) +
                   (1.0 + cable.restitution) * (spring ? longest_contact : 1) * step *
                       std::abs(free_gap_acceleration(the_case, 0, hit->before) / before);
  }
  return result;
}

bool is_near(double a, double b) { return std::abs(a - b) < 0.05; }

/// What seems to be wrong with two rebounds of different declared restitution.
std::string defect_of(const Rebound& low, const Rebound& high) {
  if (std::isnan(low.restitution) || std::isnan(high.restitution)) {
    return "the cable is never hit: no impulse is reported";
  }
  const std::string numbers =
      fmt::format("{:.3g} where {:g} is declared, {:.3g} where {:g} is", low.restitution,
                  low.declared, high.restitution, high.declared);
  if (is_near(low.restitution, high.restitution)) {
    return "the restitution is ignored: hits rebound with " + numbers;
  }
  if (is_near(low.restitution, low.declared * low.declared) &&
      is_near(high.restitution, high.declared * high.declared)) {
    return "the restitution is applied twice, as e^2: hits rebound with " + numbers;
  }
  if (low.restitution > low.declared || high.restitution > high.declared) {
    return "something adds to the bounce: hits rebound with " + numbers;
  }
  return "hits rebound too little: with " + numbers;
}

/// Both rebounds as one measure.
Measure measure_of(const Rebound& low, const Rebound& high) {
  const Rebound& worst = worse_of(low, high);
  return {worst.error(), worst.limit,
          worst.holds()
              ? fmt::format("hits rebound with {:.4g} and {:.4g}, declared are {:g} and "
                            "{:g}",
                            low.restitution, high.restitution, low.declared, high.declared)
              : defect_of(low, high)};
}

constexpr double pair_end = 0.04;  // [s], long after a pair is hit

constexpr double low_restitution = 0.4;
constexpr double high_restitution = 0.8;

Case off_centre_hit(double restitution) {
  Case result = spinning_on_one_cable(0.05);
  result.gravity = Vec2::Zero();
  result.cables.front().restitution = restitution;
  return result;
}

/// The rebound on the cable of `pair`, where impulses are reckoned as if `body` alone could move.
double rebound_alone(const SpatialSystem& pair, Eigen::Index body) {
  const SpatialCable& cable = pair.cables.front();
  const auto row = gap_gradient(cable, pair.initial);
  const auto yields = row.cwiseProduct(row).cwiseProduct(inverse_mass(pair.bodies)).eval();
  return (1.0 + cable.restitution) * yields.sum() / yields.segment<6>(6 * body).sum() - 1.0;
}

/// A body that hits its cable through the centre, without gravity, at `speed` [m/s], after 20.3
/// steps of 1e-3 s.
Case central_hit(double speed) {
  Case result = bouncing_ball(0.5);
  result.gravity = Vec2::Zero();
  result.initial.position = Vec2(0.0, 0.0203 * speed);
  result.initial.velocity = Vec2(0.0, -speed);
  return result;
}

}  // namespace

Measure measure_central_restitution(const Subject& subject) {
  return measure_of(rebound(subject, bouncing_ball(low_restitution), 1e-3, 2.0),
                    rebound(subject, bouncing_ball(high_restitution), 1e-3, 2.0));
}

Measure measure_off_centre_restitution(const Subject& subject) {
  return measure_of(rebound(subject, off_centre_hit(low_restitution), 1e-4, 0.25),
                    rebound(subject, off_centre_hit(high_restitution), 1e-4, 0.25));
}

Measure measure_pair_restitution(const Subject& subject) {
  const SpatialSystem low_pair = pair_on_a_cable(low_restitution);
  const SpatialSystem high_pair = pair_on_a_cable(high_restitution);
  const Rebound low = rebound(subject, low_pair, 1e-4, pair_end);
  const Rebound high = rebound(subject, high_pair, 1e-4, pair_end);
  Measure result = measure_of(low, high);
  for (const Eigen::Index body : {0, 1}) {
    if (!(result.found <= result.limit) &&
        is_near(low.restitution, rebound_alone(low_pair, body)) &&
        is_near(high.restitution, rebound_alone(high_pair, body))) {
      result.sentence = fmt::format(
          "a mass is left out: a cable between two bodies rebounds as if body {} alone could move, "
          "with {:.3g} where {:g} is declared, {:.3g} where {:g} is",
          body, low.restitution, low.declared, high.restitution, high.declared);
    }
  }
  return result;
}

Measure measure_slow_restitution(const Subject& subject) {
  constexpr std::array speeds = {1.0, 0.3, 0.15, 0.05, 0.02};  // [m/s]
  double kept = 0.0;             // [m/s], the slowest hit that rebounds as it should
  double lost = 0.0;             // [m/s], the fastest that does not rebound at all
  double slow = speeds.front();  // [m/s], the worst
  Rebound worst = rebound(subject, central_hit(slow), 1e-3, 0.2);
  for (const double speed : speeds) {
    const Rebound one = rebound(subject, central_hit(speed), 1e-3, 0.2);
    if (one.holds()) {
      kept = speed;
    } else if (lost == 0.0 && one.restitution < 0.5 * one.declared) {
      lost = speed;
    }
    if (&worse_of(worst, one) == &one) {
      worst = one;
      slow = speed;
    }
  }
  std::string sentence = fmt::format("a hit at {:g} m/s rebounds with {:.3g}, declared is {:g}",
                                     slow, worst.restitution, worst.declared);
  if (worst.holds()) {
    sentence = fmt::format("hits at {:g} to {:g} m/s rebound alike", speeds.back(), speeds.front());
  } else if (lost > 0.0 && kept > lost) {
    sentence = fmt::format(
        "restitution is lost below a threshold: hits at {:g} m/s do not rebound, those at {:g} m/s "
        "do",
        lost, kept);
  }
  return {worst.error(), worst.limit, sentence};
}

}  // namespace tautline::bench
