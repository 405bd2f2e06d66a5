#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "loop/attempts.hpp"
#include "loop/present.hpp"
#include "shortcuts/bounce.hpp"
#include "tautline/solve.hpp"

namespace tautline {

/// A single bounce as the loop takes it: a free flight to one cable, and the impact there.
template <class TheCase>
struct Landing {
  using Real = RealOf<TheCase>;

  Real dt;                       // [s], of the flight
  std::size_t cable;             // index
  StateOf<TheCase> before;       // the impact
  TouchingOf<TheCase> touching;  // there, but for the rounding of time
  Real impulse;                  // [N s]
  StateOf<TheCase> after;        // the impact
  Real tried;                    // of the cable, see `Attempts` [m/s]
};

/// Finds single bounces faster than the general path does: the same, to rounding. This primary
/// template finds none, so that each path checks the other.
template <class TheCase>
class SingleBounces {
 public:
  struct Search {};
  struct Bounce {
    static constexpr bool is_all = false;
  };

  SingleBounces(const TheCase&, const SolveOptions&) {}
  [[nodiscard]] static bool may_follow(const Present<TheCase>&, const Attempts<TheCase>&) {
    return false;
  }
  [[nodiscard]] static Search search(const Present<TheCase>&, const Attempts<TheCase>&) {
    return {};
  }
  [[nodiscard]] static Bounce next(const Search&) { return {}; }
  [[nodiscard]] static Landing<TheCase> land(const Bounce&, CableSet) { return {}; }
  static void forget() {}
};

/// In double (bounce.hpp).
template <>
class SingleBounces<Case> {
 public:
  using Bounce = tautline::Bounce<double, bool>;

  /// What the search for one starts from.
  struct Search {
    Flyer<double> from;
    CableSet last_hit;     // the cable that the body has just been hit by, or none
    double horizon = 0.0;  // [s], how long it may fly
    const Attempts<Case>* attempts = nullptr;
  };

  /// Of `the_case`: none where a limit may end a flight, or restitutions vary with the speed.
  SingleBounces(const Case& the_case, const SolveOptions& options)
      : limits_(options.completion),
        world_{pair<double>(the_case.gravity),
               the_case.gravity.norm(),
               the_case.body.mass,
               the_case.body.inertia,
               1 / the_case.body.mass,
               inverse_mass(the_case.body)[2],
               attachment_radius(the_case),
               shortest_length(the_case)},
        exist_(options.single_bounces && !the_case.angle_limit && !the_case.ceiling) {
    cables_.reserve(the_case.cables.size());
    for (const Cable& cable : the_case.cables) {
      cables_.push_back(flight_cable(cable));
      exist_ = exist_ && !depends_on_speed(cable);
    }
  }

  /// The cable in this place of a search: first the one that has been hit last, if any, as it is
  /// likely to be hit again before any other; then the others in their order.
  [[nodiscard]] static std::size_t cable_at(std::size_t place, CableSet last_hit) {
    if (last_hit.empty()) {
      return place;
    }
    const std::size_t last = *last_hit.begin();
    return place > last ? place : place == 0 ? last : place - 1;
  }

  /// True where one may be all that happens next: the body flies, and the bounces on the cable that
  /// it touches, if any, are not due.
  [[nodiscard]] bool may_follow(const Present<Case>& now, Attempts<Case>& attempts) {
    const std::optional<bool> is_due = std::exchange(is_due_, std::nullopt);
    return exist_ && now.is_free() &&
           !(is_due ? *is_due
                    : attempts.are_due(now.the_case, now.state, now.touching, now.touching.cables));
  }

  /// The body faces as it did at the last bounce.
  [[nodiscard]] Search search(const Present<Case>& now, const Attempts<Case>& attempts) const {
    const State& state = now.state;
    const Direction<double> facing = state.angle == angle_ ? facing_ : direction(state.angle);
    return {{pair<double>(state.position), state.angle, facing, pair<double>(state.velocity),
             state.spin, now.touching.rate_rounding, now.touching.spin_rounding},
            now.touching.cables,
            now.remaining,
            &attempts};
  }

  /// What `search` finds.
  [[nodiscard]] Bounce next(const Search& search) const {
    const auto cable = [&](std::size_t place) { return cable_of(search, place); };
    return next_bounce(world_, search.from, cable, cables_.size(), !search.last_hit.empty(),
                       search.horizon, limits_);
  }

  /// The cable in this place of `search`.
  [[nodiscard]] FlightCable<double> cable_of(const Search& search, std::size_t place) const {
    FlightCable<double> cable = cables_[cable_at(place, search.last_hit)];
    cable.tried = tried_of(search, place);
    return cable;
  }

  /// Of these what changes from search to search: its last attempt [m/s].
  [[nodiscard]] static double tried_of(const Search& search, std::size_t place) {
    return search.attempts->tried(cable_at(place, search.last_hit));
  }

  /// `bounce`, found by a search after `last_hit`; keeps what it says about the next.
  [[nodiscard]] Landing<Case> land(const Bounce& bounce, CableSet last_hit) {
    const std::size_t index = cable_at(static_cast<std::size_t>(bounce.place), last_hit);
    const Flyer<double>& flyer = bounce.before;
    angle_ = flyer.angle;
    facing_ = flyer.facing;
    is_due_ = bounce.is_due;
    const State before{{flyer.position.x, flyer.position.y},
                       flyer.angle,
                       {flyer.velocity.x, flyer.velocity.y},
                       flyer.spin};
    const State after{
        before.position, flyer.angle, {bounce.velocity.x, bounce.velocity.y}, bounce.spin};
    return {bounce.dt,      index,
            before,         {CableSet::of(index), flyer.rate_rounding, flyer.spin_rounding},
            bounce.impulse, after,
            bounce.tried};
  }

  /// The body is no longer as the last bounce has left it.
  void forget() { is_due_.reset(); }

  [[nodiscard]] const FlightWorld<double>& world() const { return world_; }

 private:
  const CompletionLimits& limits_;
  FlightWorld<double> world_;
  std::vector<FlightCable<double>> cables_;
  bool exist_;
  std::optional<bool> is_due_;             // of the cable last hit; none: to be found out
  double angle_ = not_a_number<double>();  // [rad], at the last bounce
  Direction<double> facing_{};             // there
};

}  // namespace tautline
