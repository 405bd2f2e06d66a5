#include "tautline/first_contact.hpp"

#include <array>

#include "instantiate.hpp"
#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/root_search.hpp"

namespace tautline {
namespace {

/// f = (length^2 - distance^2) / (2 length) of one cable along a flight: smooth everywhere, zero
/// with the gap, and with the gap's rate there (Eq. 11).
///
/// Computed from the way d(s) the attachment has gone, f(s) = f(0) - (D(0) + d / 2) . d / length:
/// a short flight then has a small rounding error. Taking squared distances instead leaves 1e-16
/// however short it is, which moves the return of a bounce of speed v by 1e-16 / v.
template <class Real>
class GapAlongFlight {
 public:
  /// `at_zero`: f(0) is zero, and f'(0) too where it is within `rate_rounding` below.
  GapAlongFlight(const BasicCase<Real>& the_case, const BasicCable<Real>& cable,
                 const BasicState<Real>& start, bool at_zero, const Real& rate_rounding)
      : gravity_(the_case.gravity),
        cable_(cable),
        start_(start),
        arm_(attachment_arm(start, cable)),
        from_anchor_(start.position + arm_ - cable.anchor),
        value_(at_zero ? Real(0)
                       : (cable.length * cable.length - from_anchor_.squaredNorm()) /
                             (2 * cable.length)),
        radius_(cable.attachment.norm()),
        turning_(start.spin * start.spin * radius_),
        gravity_size_(the_case.gravity.norm()) {
    const Real rate =
        -from_anchor_.dot(start.velocity + start.spin * perpendicular(arm_)) / cable.length;
    drift_ = at_zero && rate < 0 && rate >= -rate_rounding ? Real(-rate) : Real(0);
  }

  [[nodiscard]] BasicSample<Real> at(const Real& s) const {
    // the turn by 2 h takes the arm a to a + 2 sin h (cos h a' - sin h a), a' perpendicular to a
    const Real sine = sin(s * start_.spin / 2);
    const Real cosine = cos(s * start_.spin / 2);
    const BasicVec2<Real> turned = 2 * sine * (cosine * perpendicular(arm_) - sine * arm_);
    const BasicVec2<Real> way = s * start_.velocity + Real(s * s / 2) * gravity_ + turned;
    const BasicVec2<Real> arm = arm_ + turned;
    const BasicVec2<Real> from_anchor = from_anchor_ + way;
    const BasicVec2<Real> velocity =
        start_.velocity + s * gravity_ + start_.spin * perpendicular(arm);
    const BasicVec2<Real> acceleration = gravity_ - start_.spin * start_.spin * arm;
    const Real length = cable_.length;
    return {value_ + s * drift_ - (from_anchor_ + way / Real(2)).dot(way) / length,
            drift_ - from_anchor.dot(velocity) / length,
            -(velocity.squaredNorm() + from_anchor.dot(acceleration)) / length};
  }

  /// |f'''| <= (3 V A + D J) / length (Eq. 12): V, A, J bound the attachment's speed, acceleration
  /// and jerk over the window, and D the distance, which is at most the length until the first root
  /// and at most V w beyond it after.
  [[nodiscard]] Real jerk_bound(const Real& s, const Real& window) const {
    const Real speed = (start_.velocity + s * gravity_).norm() + window * gravity_size_ +
                       abs(start_.spin) * radius_;
    const Real acceleration = gravity_size_ + turning_;
    const Real distance = cable_.length + speed * window;
    const Real jerk = abs(start_.spin) * turning_;
    return (3 * speed * acceleration + distance * jerk) / cable_.length;
  }

 private:
  BasicVec2<Real> gravity_;
  const BasicCable<Real>& cable_;
  const BasicState<Real>& start_;
  BasicVec2<Real> arm_;          // [m], centre of mass to attachment at the start
  BasicVec2<Real> from_anchor_;  // [m], anchor to attachment at the start
  Real value_;                   // [m], f at the start
  Real drift_;                   // [m/s], takes away a closing rate that is rounding
  Real radius_;                  // [m], attachment to centre of mass
  Real turning_;                 // [m/s^2], centripetal acceleration of the attachment
  Real gravity_size_;            // [m/s^2]
};

/// The same of a body that turns many times before the cable is within its reach. While the centre
/// is no farther from the anchor than the length without the arm, no angle makes the cable taut.
template <class Real>
class GapOfTurningBody {
 public:
  /// `bare` is the cable without the arm, attached at the centre.
  GapOfTurningBody(const GapAlongFlight<Real>& gap, const BasicCase<Real>& the_case,
                   const BasicCable<Real>& bare, const BasicState<Real>& start)
      : gap_(gap), centre_(the_case, bare, start, false, Real(0)) {}

  [[nodiscard]] BasicSample<Real> at(const Real& s) const { return gap_.at(s); }
  [[nodiscard]] Real jerk_bound(const Real& s, const Real& window) const {
    return gap_.jerk_bound(s, window);
  }
  [[nodiscard]] Real clear(const Real& s, const Real& window) const {
    const BasicSample<Real> now = centre_.at(s);
    return now.value > 0 ? safe_step(centre_, now, s, window) : Real(0);
  }

 private:
  const GapAlongFlight<Real>& gap_;
  GapAlongFlight<Real> centre_;
};

/// The first time within `horizon` at which the cable is taut, as `first_root`.
template <class Real>
BasicRootSearch<Real> time_to_taut(const BasicCase<Real>& the_case, const BasicCable<Real>& cable,
                                   const BasicState<Real>& state, const Real& rate_rounding,
                                   bool at_zero, const Real& horizon) {
  constexpr double many = 100.0;  // [rad]: so far the gap alone takes some hundred steps
  const GapAlongFlight<Real> f(the_case, cable, state, at_zero, rate_rounding);
  const Real arm = cable.attachment.norm();
  if (!(abs(state.spin) * horizon > many) || arm == 0 || !(arm < cable.length)) {
    return first_root(f, horizon, {at_zero});
  }
  BasicCable<Real> bare = cable;
  bare.length -= arm;
  bare.attachment.setZero();
  return first_root(GapOfTurningBody<Real>(f, the_case, bare, state), horizon, {at_zero});
}

}  // namespace

template <class Real>
BasicFirstContactSearch<Real> first_contact(const BasicCase<Real>& the_case,
                                            const BasicState<Real>& state,
                                            const BasicTouching<Real>& touching,
                                            const std::type_identity_t<Real>& horizon) {
  BasicFirstContactSearch<Real> result;
  std::array<std::optional<Real>, max_cables> roots;
  std::optional<Real> earliest;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    // nothing after the earliest contact so far matters, except what is simultaneous with it
    const Real until =
        earliest ? min(horizon, Real(*earliest * (1 + simultaneous<Real>()))) : horizon;
    const bool at_zero = touching.cables.contains(index);
    const BasicCable<Real>& cable = the_case.cables[index];
    const BasicRootSearch<Real> search =
        time_to_taut(the_case, cable, state, touching.rounding(cable), at_zero, until);
    result.steps += search.steps;
    if (search.root && isnan(*search.root)) {
      result.contact = BasicFirstContact<Real>{*search.root, {}};
      return result;
    }
    roots[index] = search.root;
    if (search.root && (!earliest || *search.root < *earliest)) {
      earliest = search.root;
    }
  }
  if (!earliest) {
    return result;
  }
  result.contact = BasicFirstContact<Real>{*earliest, {}};
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (roots[index] && *roots[index] <= *earliest * (1 + simultaneous<Real>())) {
      result.contact->cables.insert(index);
    }
  }
  return result;
}

template BasicFirstContactSearch<Instance> first_contact(const BasicCase<Instance>&,
                                                         const BasicState<Instance>&,
                                                         const BasicTouching<Instance>&,
                                                         const Instance&);

}  // namespace tautline
