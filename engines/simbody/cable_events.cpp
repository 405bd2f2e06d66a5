#include "cable_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tautline/geometry.hpp"

namespace tautline::simbody {
namespace {

/// A cable this near to its length, or longer, is at it [-], of the length. Events are located to
/// 1e-14 s, and up to a thousand of them leave a few roundings each.
constexpr double touch_rounding = 1e-12;

/// Above the length at which an event leaves a cable, so that the next event is a change of sign
/// again [-], of the length: more than its rounding.
constexpr double level_rounding = 16.0 * std::numeric_limits<double>::epsilon();

/// What impacts leave of a rate [-], of the speed of the body.
constexpr double rate_rounding = 1e-12;

/// A bounce that would be slower than this is none, and the cable is taut [m/s]: what is left of
/// impacts that accumulate is then 1e-12 of a metre.
constexpr double capture_speed = 1e-6;

/// Nearly dependent cables hit together take up to some ten thousand iterations; one takes two.
constexpr int most_iterations = 100'000;

/// An iteration that changes no rate by more than this part of the speed is the last [-].
constexpr double solve_rounding = 1e-15;

/// A step with more reactions is given up.
constexpr std::size_t most_reactions = 10'000;

/// A cable longer than this was not struck when it should have been [-], of the length: far above
/// rounding and the constraint tolerance of rods.
constexpr double overlooked = 1e-6;

/// Zero is no sign: Simbody's search for an event fails an assertion if it meets one.
double with_sign(double value) { return value == 0.0 ? std::numeric_limits<double>::min() : value; }

}  // namespace

CableEvents::CableEvents(PlanarBody& body)
    : body_(body),
      levels_(body.the_case().cables.size()),
      impulses_(body.the_case().cables.size()) {
  for (const Cable& cable : body.the_case().cables) {
    SimTK::Constraint::Rod rod(body.ground(), vector(cable.anchor), body.mobilized(),
                               vector(cable.attachment), cable.length);
    rod.setDisabledByDefault(true);
    rods_.push_back(rod);
  }
}

double CableEvents::overstretch(const SimTK::State& state, std::size_t cable) const {
  if (is_taut(state, cable)) {
    return -1.0;  // any
  }
  return with_sign(rods_[cable].findLengthViolation(state) - levels_[cable]);
}

double CableEvents::tension(const SimTK::State& state, std::size_t cable) const {
  return is_taut(state, cable) ? with_sign(rods_[cable].getRodTension(state)) : 1.0;  // any
}

void CableEvents::react(SimTK::State& state) {
  if (++reactions_ > most_reactions) {
    trouble_ = "more than " + std::to_string(most_reactions) + " events in one step";
    return;
  }
  body_.system().realize(state, SimTK::Stage::Dynamics);
  const CableSet cables = touching(state);
  strike(state, cables);
  const State now = body_.state_of(state);
  CableSet resting;
  for (const std::size_t index : cables) {
    if (gap_rate(body_.the_case().cables[index], now) <= capture_speed) {
      resting.insert(index);
    }
  }
  hold(state, resting);
  for (std::size_t index = 0; index < rods_.size(); ++index) {
    levels_[index] = std::max(0.0, rods_[index].findLengthViolation(state)) +
                     level_rounding * body_.the_case().cables[index].length;
  }
  state.invalidateAll(SimTK::Stage::Position);  // Simbody keeps the values it watches with the pose
}

void CableEvents::start_step() {
  events_.clear();
  std::fill(impulses_.begin(), impulses_.end(), 0.0);
  reactions_ = 0;
}

void CableEvents::check(const SimTK::State& state) {
  for (std::size_t index = 0; index < rods_.size(); ++index) {
    if (rods_[index].findLengthViolation(state) >
        overlooked * body_.the_case().cables[index].length) {
      trouble_ = "cable " + std::to_string(index) + " is overstretched: an impact was overlooked";
    }
  }
}

CableSet CableEvents::touching(const SimTK::State& state) const {
  CableSet result;
  for (std::size_t index = 0; index < rods_.size(); ++index) {
    const double length = body_.the_case().cables[index].length;
    if (is_taut(state, index) ||
        rods_[index].findLengthViolation(state) >= -touch_rounding * length) {
      result.insert(index);
    }
  }
  return result;
}

bool CableEvents::is_taut(const SimTK::State& state, std::size_t cable) const {
  return !rods_[cable].isDisabled(state);
}

/// Strikes those of `cables` that close or rest, if one of them closes.
void CableEvents::strike(SimTK::State& state, CableSet cables) {
  const Case& the_case = body_.the_case();
  const State before = body_.state_of(state);
  const double rounding = rate_rounding * speed_scale(the_case, before);
  CableSet struck;
  std::vector<double> wanted;
  double fastest = 0.0;
  for (const std::size_t index : cables) {
    const double rate = gap_rate(the_case.cables[index], before);
    if (is_taut(state, index) || rate <= rounding) {
      struck.insert(index);
      const double rebound = -rate * restitution(the_case.cables[index], rate);
      wanted.push_back(rebound > capture_speed ? rebound : 0.0);
      fastest = std::max(fastest, is_taut(state, index) ? 0.0 : -rate);
    }
  }
  if (fastest <= rounding) {
    return;
  }
  CableVector impulses = CableVector::Zero(static_cast<Eigen::Index>(wanted.size()));
  const CableVector rates =
      Eigen::Map<const Eigen::VectorXd>(wanted.data(), static_cast<Eigen::Index>(wanted.size()));
  solve(state, struck, rates, impulses);
  Eigen::Index row = 0;
  for (const std::size_t index : struck) {
    impulses_[index] += impulses[row++];
  }
  events_.push_back({state.getTime(), EventKind::impact, struck, std::move(impulses), before,
                     body_.state_of(state)});
}

/// Newton's law as a complementarity problem (Eq. 14), by projected Gauss-Seidel: each gap opens
/// with at least its rate, no cable is pushed. Adds to `impulses`.
void CableEvents::solve(SimTK::State& state, CableSet cables, const CableVector& rates,
                        CableVector& impulses) {
  struct Row {
    SimTK::Vector force;   // of a unit impulse, in the coordinates' directions
    SimTK::Vector change;  // of the speeds, by it
    double response;       // of the gap rate, to it [1/kg]
  };
  const auto& matter = body_.matter();
  std::vector<Row> rows;
  for (const std::size_t index : cables) {
    const Cable& cable = body_.the_case().cables[index];
    const auto body = body_.mobilized().getMobilizedBodyIndex();
    const SimTK::Vec3 point =
        body_.mobilized().findStationLocationInGround(state, vector(cable.attachment));
    const SimTK::UnitVec3 towards(vector(cable.anchor) - point);
    Row row;
    matter.multiplyByStationJacobianTranspose(state, body, vector(cable.attachment),
                                              SimTK::Vec3(towards), row.force);
    matter.multiplyByMInv(state, row.force, row.change);
    row.response = ~row.force * row.change;
    rows.push_back(row);
  }
  SimTK::Vector speeds = state.getU();
  const double enough = solve_rounding * speed_scale(body_.the_case(), body_.state_of(state));
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    double largest = 0.0;
    Eigen::Index position = 0;
    for (const Row& row : rows) {
      const double missing = rates[position] - ~row.force * speeds;
      const double impulse = std::max(-impulses[position], missing / row.response);
      impulses[position++] += impulse;
      speeds += impulse * row.change;
      largest = std::max(largest, std::abs(impulse) * row.response);
    }
    if (largest <= enough) {
      break;
    }
  }
  state.updU() = speeds;
}

/// Switches the rods of `resting` on, and off again as long as one of them pushes.
void CableEvents::hold(SimTK::State& state, CableSet resting) {
  for (std::size_t index = 0; index < rods_.size(); ++index) {
    if (resting.contains(index)) {
      rods_[index].enable(state);
    } else {
      rods_[index].disable(state);
    }
  }
  if (!resting.empty()) {
    body_.system().realize(state, SimTK::Stage::Position);
    body_.system().projectU(state, rate_rounding);  // what capture left of the rates
  }
  body_.system().realize(state, SimTK::Stage::Acceleration);
  CableSet taut = resting;
  while (!taut.empty()) {
    const std::vector<std::size_t> indices = taut.indices();
    const std::size_t loosest = *std::ranges::min_element(
        indices, {}, [&](std::size_t index) { return rods_[index].getRodTension(state); });
    if (rods_[loosest].getRodTension(state) > 0.0) {
      break;
    }
    rods_[loosest].disable(state);
    taut.erase(loosest);
    body_.system().realize(state, SimTK::Stage::Acceleration);
  }
  const State now = body_.state_of(state);
  const double rounding = rate_rounding * acceleration_scale(body_.the_case(), now);
  for (const std::size_t index : resting - taut) {
    if (gap_acceleration(state, index) < -rounding) {
      trouble_ = "no tensions are found that hold the cables at rest";
    }
  }
}

/// [m/s^2], with the tensions of the cables that are taut.
double CableEvents::gap_acceleration(const SimTK::State& state, std::size_t cable) const {
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
