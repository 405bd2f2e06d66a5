#include "rods.hpp"

#include <algorithm>

#include "tautline/geometry.hpp"

namespace tautline::simbody {
namespace {

/// Of a rate that is brought to rest [-], in Simbody's measure of constraint errors, and of an
/// acceleration, of its scale: a few thousand roundings.
constexpr double rounding = 1e-12;

}  // namespace

Rods::Rods(PlanarBody& body) : body_(body) {
  for (const Cable& cable : body.the_case().cables) {
    SimTK::Constraint::Rod rod(body.ground(), vector(cable.anchor), body.mobilized(),
                               vector(cable.attachment), cable.length);
    rod.setDisabledByDefault(true);
    rods_.push_back(rod);
  }
}

bool Rods::is_on(const SimTK::State& state, std::size_t cable) const {
  return !rods_[cable].isDisabled(state);
}

double Rods::overstretch(const SimTK::State& state, std::size_t cable) const {
  return rods_[cable].findLengthViolation(state);
}

double Rods::tension(const SimTK::State& state, std::size_t cable) const {
  return rods_[cable].getRodTension(state);
}

bool Rods::hold(SimTK::State& state, CableSet resting) {
  for (std::size_t index = 0; index < rods_.size(); ++index) {
    if (resting.contains(index)) {
      rods_[index].enable(state);
    } else {
      rods_[index].disable(state);
    }
  }
  if (!resting.empty()) {
    body_.system().realize(state, SimTK::Stage::Position);
    body_.system().projectU(state, rounding);
  }
  body_.system().realize(state, SimTK::Stage::Acceleration);
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
    body_.system().realize(state, SimTK::Stage::Acceleration);
  }
  const double least =
      -rounding * acceleration_scale(body_.the_case(), body_.state_of(state));  // [m/s^2]
  const std::vector<std::size_t> off = (resting - on).indices();
  return std::ranges::all_of(
      off, [&](std::size_t index) { return gap_acceleration(state, index) >= least; });
}

/// [m/s^2], with the tensions of the rods that are on.
double Rods::gap_acceleration(const SimTK::State& state, std::size_t cable) const {
  const SimTK::Vec3 station = vector(body_.the_case().cables[cable].attachment);
  const SimTK::MobilizedBody& body = body_.mobilized();
  const SimTK::Vec3 arm = vector(body_.the_case().cables[cable].anchor) -
                          body.findStationLocationInGround(state, station);
  const SimTK::UnitVec3 towards(arm);
  const SimTK::Vec3 velocity = body.findStationVelocityInGround(state, station);
  const double along = SimTK::dot(velocity, towards);
  return SimTK::dot(body.findStationAccelerationInGround(state, station), towards) -
         (velocity.normSqr() - along * along) / arm.norm();
}

}  // namespace tautline::simbody
