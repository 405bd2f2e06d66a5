#pragma once

#include <type_traits>

#include "tautline/detail/scalar.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// Of the error, whatever the margin of the certificate [-].
inline constexpr double error_margin = 20.0;

/// Size of the gaps' accelerations [m/s^2] and the rate [1/s] at which they change.
template <class V>
struct Scales {
  Scales(const BasicCase<V>& the_case, const BasicState<V>& state, double of_certificate)
      : Scales(the_case.gravity.norm(), attachment_radius(the_case), shortest_length(the_case),
               speed_scale(the_case, state), state.spin, of_certificate) {}

  /// Of a body whose attachments, up to `radius` [m] from the centre, are no faster than `speed`
  /// [m/s], on cables no shorter than `shortest` [m].
  Scales(const V& gravity, const V& radius, const V& shortest, const V& speed, const V& spin,
         double of_certificate)
      : margin(of_certificate) {
    const V turn = speed / shortest;
    acceleration = gravity + spin * spin * radius + speed * turn;
    rate = abs(spin) + turn + sqrt(V(acceleration / shortest));
  }

  /// These.
  Scales(const V& of_acceleration, const V& of_rate, double of_certificate)
      : acceleration(of_acceleration), rate(of_rate), margin(of_certificate) {}

  V acceleration;
  V rate;
  double margin;  // of the certificate [-]
};

/// Those of a motion in `state`.
template <class Real>
[[nodiscard]] Scales<Real> scales_of(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                     double of_certificate) {
  return {the_case, state, of_certificate};
}

/// Where bounces that begin with `rebound` [m/s] are no higher than what a gap can tell.
template <class V>
[[nodiscard]] auto is_low(const V& rounding, const V& rebound, const Scales<V>& scale) {
  return V(rebound * rebound) <= V(2 * scale.acceleration * rounding);
}

/// Where bounces that begin with `rebound` [m/s] and keep at most the part `kept` of their speed
/// may meet `limits` (CompletionLimits): where they would with a pull as large as the accelerations
/// of the motion (Eq. 20). A stronger one has to wait a little.
template <class V, class Limits>
[[nodiscard]] auto is_slow(const V& kept, const V& rounding, const V& rebound, const Limits& limits,
                           const Scales<V>& scale) {
  if (limits.speed) {
    return rebound <= V(*limits.speed);
  }
  const V lost = select(kept < V(1), V(1 - kept * kept * kept), V(1));
  const V ratio = rebound * scale.rate / scale.acceleration;
  return is_low(rounding, rebound, scale) ||
         V(2 * error_margin * ratio * ratio * ratio) <= V(3 * lost * limits.error);
}

/// Whether the bounces on a cable are to be tried as the end of an accumulation.
template <class V, class Mask>
struct NextAttempt {
  Mask is_due;  // now; or the cable does not open at all
  V tried;      // [m/s], the rebound of the last attempt, from now on; infinite: there was none
};

/// Of a cable that begins bounces with `rebound` [m/s], of which each keeps the part `kept`; it
/// rests where that is within `rate_rounding` [m/s]. An attempt costs as much as several bounces:
/// slow ones are worth it once they are half as fast as at the last one, `tried`; those too low for
/// a gap to tell after four bounces, too, and elastic ones at each. Where they are faster than at
/// the last one they are others.
template <class V, class Limits>
[[nodiscard]] auto next_attempt(const V& kept, const V& rounding, const V& rate_rounding,
                                const V& rebound, const V& tried, const Limits& limits,
                                const Scales<V>& scale) {
  const auto slow = is_slow(kept, rounding, rebound, limits, scale);
  const V last = select(slow && rebound <= tried, tried, infinity<V>());
  const V square = kept * kept;
  const V left = select(is_low(rounding, rebound, scale), most(V(0.5), V(square * square)), V(0.5));
  const auto is_due = !(rebound > rate_rounding && !(slow && rebound <= V(left * last)));
  return NextAttempt<V, std::remove_const_t<decltype(is_due)>>{is_due, last};
}

}  // namespace tautline
