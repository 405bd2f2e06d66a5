#include "rods.hpp"

#include <algorithm>

namespace tautline::simbody {
namespace {

/// Of a rate that is brought to rest [-], in Simbody's measure of constraint errors, and of an
/// acceleration, of its scale: a few thousand roundings.
constexpr double rounding = 1e-12;

}  // namespace

template <class TheCase>
Rods<TheCase>::Rods(Bodies<TheCase>& bodies) : bodies_(bodies) {
  for (std::size_t index = 0; index < bodies.the_case().cables.size(); ++index) {
    Station from = bodies.from(index);
    Station to = bodies.to(index);
    SimTK::Constraint::Rod rod(to.body, to.at, from.body, from.at, bodies.length(index));
    rod.setDisabledByDefault(true);
    rods_.push_back(rod);
  }
}

template <class TheCase>
bool Rods<TheCase>::is_on(const SimTK::State& state, std::size_t cable) const {
  return !rods_[cable].isDisabled(state);
}

template <class TheCase>
double Rods<TheCase>::overstretch(const SimTK::State& state, std::size_t cable) const {
  return rods_[cable].findLengthViolation(state);
}

template <class TheCase>
double Rods<TheCase>::tension(const SimTK::State& state, std::size_t cable) const {
  return rods_[cable].getRodTension(state);
}

template <class TheCase>
bool Rods<TheCase>::hold(SimTK::State& state, CableSet resting) {
  for (std::size_t index = 0; index < rods_.size(); ++index) {
    if (resting.contains(index)) {
      rods_[index].enable(state);
    } else {
      rods_[index].disable(state);
    }
  }
  if (!resting.empty()) {
    bodies_.system().realize(state, SimTK::Stage::Position);
    bodies_.system().projectU(state, rounding);
  }
  bodies_.system().realize(state, SimTK::Stage::Acceleration);
  // a rod that pushes is no cable: without the worst of them, until none does
  CableSet on = resting;
  while (!on.empty()) {
    const std::vector<std::size_t> indices = on.indices();
    const std::size_t loosest = *std::ranges::min_element(
        indices, {}, [&](std::size_t index) { return tension(state, index); });
    if (tension(state, loosest) > 0.0) {
      break;
    }
    rods_[loosest].disable(state);
    on.erase(loosest);
    bodies_.system().realize(state, SimTK::Stage::Acceleration);
  }
  const double least =
      -rounding * acceleration_of(bodies_.the_case(), bodies_.state_of(state));  // [m/s^2]
  const std::vector<std::size_t> off = (resting - on).indices();
  return std::ranges::all_of(
      off, [&](std::size_t index) { return gap_acceleration(state, index) >= least; });
}

/// [m/s^2], with the tensions of the rods that are on.
template <class TheCase>
double Rods<TheCase>::gap_acceleration(const SimTK::State& state, std::size_t cable) const {
  const Station from = bodies_.from(cable);
  const Station to = bodies_.to(cable);
  const SimTK::Vec3 arm = to.body.findStationLocationInGround(state, to.at) -
                          from.body.findStationLocationInGround(state, from.at);
  const SimTK::UnitVec3 towards(arm);
  const SimTK::Vec3 velocity = from.body.findStationVelocityInGround(state, from.at) -
                               to.body.findStationVelocityInGround(state, to.at);
  const SimTK::Vec3 acceleration = from.body.findStationAccelerationInGround(state, from.at) -
                                   to.body.findStationAccelerationInGround(state, to.at);
  const double along = SimTK::dot(velocity, towards);
  return SimTK::dot(acceleration, towards) - (velocity.normSqr() - along * along) / arm.norm();
}

template class Rods<Case>;
template class Rods<SpatialSystem>;

}  // namespace tautline::simbody
