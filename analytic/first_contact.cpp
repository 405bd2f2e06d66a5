#include "tautline/detail/first_contact.hpp"

#include <array>

#include "flight/gap_along_flight.hpp"
#include "instantiate.hpp"

namespace tautline {
namespace {

/// The gap of a body that turns many times before the cable is within its reach. While the centre
/// is no farther from the anchor than the length without the arm, no angle makes the cable taut.
template <class Real>
class GapOfTurningBody {
 public:
  /// `bare` is the cable without the arm, attached at the centre.
  GapOfTurningBody(const GapAlongFlight<Real>& gap, const Flight<Real>& flight,
                   const BasicCable<Real>& bare)
      : gap_(gap), centre_(flight, flight_cable(bare), false, Real(0)) {}

  [[nodiscard]] BasicSample<Real> at(const Real& s) const { return gap_.at(s); }
  [[nodiscard]] Real snap_bound(const Real& s, const Real& window) const {
    return gap_.snap_bound(s, window);
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
BasicRootSearch<Real> time_to_taut(const Flight<Real>& flight, const BasicCable<Real>& cable,
                                   const Real& rate_rounding, bool at_zero, const Real& horizon) {
  const FlightCable<Real> flown = flight_cable(cable);
  const GapAlongFlight<Real> f(flight, flown, at_zero, rate_rounding);
  if (!(abs(flight.spin) * horizon > many_turns) || flown.radius == 0 ||
      !(flown.radius < cable.length)) {
    return first_root(f, horizon, {at_zero});
  }
  BasicCable<Real> bare = cable;
  bare.length -= flown.radius;
  bare.attachment.setZero();
  return first_root(GapOfTurningBody<Real>(f, flight, bare), horizon, {at_zero});
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
  const auto [cosine, sine] = heading(state.angle);
  const Flight<Real> flight{pair<Real>(state.position),   {cosine, sine},
                            pair<Real>(state.velocity),   state.spin,
                            pair<Real>(the_case.gravity), the_case.gravity.norm(),
                            Real(state.velocity.norm()),  Real(state.spin * state.spin)};
  const CableSet all = CableSet::first(the_case.cables.size());
  // those just hit first: they are likely to return before any other closes, and nothing after the
  // earliest contact so far matters, except what is simultaneous with it
  for (const CableSet cables : {touching.cables, all - touching.cables}) {
    for (const std::size_t index : cables) {
      const Real until =
          earliest ? min(horizon, Real(*earliest * (1 + simultaneous<Real>()))) : horizon;
      const bool at_zero = touching.cables.contains(index);
      const BasicCable<Real>& cable = the_case.cables[index];
      const BasicRootSearch<Real> search =
          time_to_taut(flight, cable, touching.rounding(cable), at_zero, until);
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
  }
  if (!earliest) {
    return result;
  }
  result.contact = BasicFirstContact<Real>{*earliest, {}};
  for (const std::size_t index : all) {
    if (roots[index] && *roots[index] <= *earliest * (1 + simultaneous<Real>())) {
      result.contact->cables.insert(index);
    }
  }
  return result;
}

template BasicFirstContactSearch<Instance> first_contact(const InstanceCase&,
                                                         const BasicState<Instance>&,
                                                         const BasicTouching<Instance>&,
                                                         const Instance&);

}  // namespace tautline
