#include "newton.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tautline/geometry.hpp"

namespace tautline::simbody {
namespace {

/// Nearly dependent cables hit together take up to some ten thousand iterations; one takes two.
constexpr int most_iterations = 100'000;

/// An iteration that changes no rate by more than this part of the speed is the last [-].
constexpr double solve_rounding = 1e-15;

/// A cable in the coordinates of Simbody.
struct Row {
  SimTK::Vector force;   // of a unit impulse
  SimTK::Vector change;  // of the speeds, by it
  double response;       // of the gap rate, to it [1/kg]
};

Row row_of(PlanarBody& body, const SimTK::State& state, const Cable& cable) {
  const SimTK::MobilizedBody& mobilized = body.mobilized();
  const SimTK::Vec3 station = vector(cable.attachment);
  const SimTK::UnitVec3 towards(vector(cable.anchor) -
                                mobilized.findStationLocationInGround(state, station));
  Row row;
  body.matter().multiplyByStationJacobianTranspose(state, mobilized.getMobilizedBodyIndex(),
                                                   station, SimTK::Vec3(towards), row.force);
  body.matter().multiplyByMInv(state, row.force, row.change);
  row.response = ~row.force * row.change;
  return row;
}

}  // namespace

CableVector strike(PlanarBody& body, SimTK::State& state, CableSet cables,
                   const CableVector& rates) {
  std::vector<Row> rows;
  for (const std::size_t index : cables) {
    rows.push_back(row_of(body, state, body.the_case().cables[index]));
  }
  // projected Gauss-Seidel: one impulse after the other, none of them below zero in sum
  const double enough = solve_rounding * speed_scale(body.the_case(), body.state_of(state));
  CableVector impulses = CableVector::Zero(rates.size());
  SimTK::Vector speeds = state.getU();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    double largest = 0.0;  // [m/s]
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
  return impulses;
}

}  // namespace tautline::simbody
