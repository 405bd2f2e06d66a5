#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "flight/bounce.hpp"

namespace tautline {

template <class Real>
using BasicBounce = Bounce<Real, bool>;

/// What the search for one starts from.
template <class Real>
struct BounceSearch {
  Flyer<Real> from;
  CableSet left;  // the cable that the body has just left, or none
  Real horizon;   // [s], how long it may fly
};

/// The ordinary bounces of one case (bounce.hpp), in double. Many digits go the general way alone,
/// so that either is held against the other.
template <class Real>
class OrdinaryBounces {
 public:
  OrdinaryBounces(const BasicCase<Real>& the_case, const CompletionLimits& limits)
      : limits_(limits),
        world_{pair<Real>(the_case.gravity), the_case.gravity.norm(),
               the_case.body.mass,           the_case.body.inertia,
               Real(1 / the_case.body.mass), inverse_mass(the_case.body)[2],
               attachment_radius(the_case),  shortest_length(the_case)},
        exist_(std::is_same_v<Real, double> && !the_case.angle_limit && !the_case.ceiling) {
    cables_.reserve(the_case.cables.size());
    for (const BasicCable<Real>& cable : the_case.cables) {
      cables_.push_back(flight_cable(cable));
      exist_ = exist_ && !depends_on_speed(cable);
    }
  }

  /// The cable in this place of a search: first the one that the body has just `left`, if any, as
  /// it is likely to return before any other closes; then the others in their order.
  [[nodiscard]] static std::size_t cable_at(std::size_t place, CableSet left) {
    if (left.empty()) {
      return place;
    }
    const std::size_t last = *left.begin();
    return place > last ? place : place == 0 ? last : place - 1;
  }

  /// What `search` finds.
  [[nodiscard]] BasicBounce<Real> next(const BounceSearch<Real>& search) const {
    if constexpr (std::is_same_v<Real, double>) {
      const auto cable = [&](std::size_t place) { return cables_[cable_at(place, search.left)]; };
      return next_bounce(world_, search.from, cable, cables_.size(), !search.left.empty(),
                         search.horizon, limits_);
    } else {
      return {};
    }
  }

  /// The cable of `bounce`, found by a search that has `left` a cable; keeps what it says about
  /// later ones.
  std::size_t take(const BasicBounce<Real>& bounce, CableSet left) {
    const std::size_t index = cable_at(static_cast<std::size_t>(bounce.place), left);
    set_tried(index, bounce.tried);
    angle_ = bounce.before.angle;
    facing_ = bounce.before.facing;
    leaves_ = bounce.leaves;
    return index;
  }

  /// True where the body, which flies, leaves the cable it touches, if any, for good, so that a
  /// bounce may follow.
  [[nodiscard]] bool may_follow(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                const BasicTouching<Real>& touching) {
    if (exist_ && !leaves_) {
      leaves_ = leave(the_case, state, touching, touching.cables);
    }
    return exist_ && *leaves_;
  }
  /// None does, up to the next flight.
  void refuse() { leaves_ = false; }
  /// The next flight begins here.
  void forget() { leaves_.reset(); }

  /// The body in `state`. The next flight begins as it faces at the last bounce.
  [[nodiscard]] Flyer<Real> flyer(const BasicState<Real>& state,
                                  const BasicTouching<Real>& touching) const {
    Direction<Real> facing = facing_;
    if constexpr (std::is_same_v<Real, double>) {
      facing = state.angle == angle_ ? facing_ : direction(state.angle);
    }
    return {pair<Real>(state.position), state.angle, facing,
            pair<Real>(state.velocity), state.spin,  touching.rate_rounding,
            touching.spin_rounding};
  }

  /// After the bounces on `cables` have been tried as the end of an accumulation, in vain.
  void note_attempt(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                    CableSet cables) {
    for (const std::size_t index : cables) {
      set_tried(index, gap_rate(the_case.cables[index], state));
    }
    forget();
  }
  void set_tried(std::size_t index, const Real& tried) { cables_[index].tried = tried; }

  /// True where the touching `cables` open, and their bounces are not to be tried as the end of an
  /// accumulation.
  [[nodiscard]] bool leave(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                           const BasicTouching<Real>& touching, CableSet cables) {
    const Scales<Real> scale(the_case, state, limits_.margin);
    for (const std::size_t index : cables) {
      const BasicCable<Real>& cable = the_case.cables[index];
      const Real rebound = gap_rate(cable, state);
      const auto next =
          leaving(restitution_up_to(cable, rebound), rounding_of_gap(cable, state),
                  touching.rounding(cable), rebound, cables_[index].tried, limits_, scale);
      set_tried(index, next.tried);
      if (!next.leaves) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] const FlightWorld<Real>& world() const { return world_; }
  [[nodiscard]] const std::vector<FlightCable<Real>>& cables() const { return cables_; }

 private:
  const CompletionLimits& limits_;
  FlightWorld<Real> world_;
  std::vector<FlightCable<Real>> cables_;
  bool exist_;                         // false: a limit may end a flight, or restitutions vary
  std::optional<bool> leaves_;         // the cable last hit, for good; none: to be found out
  Real angle_ = not_a_number<Real>();  // [rad], at the last bounce
  Direction<Real> facing_{};           // there
};

/// The state of `flyer`.
template <class Real>
[[nodiscard]] BasicState<Real> state_of(const Flyer<Real>& flyer) {
  return {BasicVec2<Real>(flyer.position.x, flyer.position.y), flyer.angle,
          BasicVec2<Real>(flyer.velocity.x, flyer.velocity.y), flyer.spin};
}

/// The state that a bounce leads to.
template <class Real>
[[nodiscard]] BasicState<Real> state_after(const BasicBounce<Real>& bounce) {
  BasicState<Real> after = state_of(bounce.before);
  after.velocity = {bounce.velocity.x, bounce.velocity.y};
  after.spin = bounce.spin;
  return after;
}

}  // namespace tautline
