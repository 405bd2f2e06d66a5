#include "newton.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

template <class TheCase>
Row row_of(Bodies<TheCase>& bodies, const SimTK::State& state, std::size_t cable) {
  const Station from = bodies.from(cable);
  const Station to = bodies.to(cable);
  const SimTK::UnitVec3 towards(to.body.findStationLocationInGround(state, to.at) -
                                from.body.findStationLocationInGround(state, from.at));
  Row row;
  bodies.matter().multiplyByStationJacobianTranspose(state, from.body.getMobilizedBodyIndex(),
                                                     from.at, SimTK::Vec3(towards), row.force);
  if (!to.body.isGround()) {
    SimTK::Vector other;
    bodies.matter().multiplyByStationJacobianTranspose(state, to.body.getMobilizedBodyIndex(),
                                                       to.at, -SimTK::Vec3(towards), other);
    row.force += other;
  }
  bodies.matter().multiplyByMInv(state, row.force, row.change);
  row.response = ~row.force * row.change;
  return row;
}

}  // namespace

template <class TheCase>
CableVector strike(Bodies<TheCase>& bodies, SimTK::State& state, CableSet cables,
                   const CableVector& rates) {
  std::vector<Row> rows;
  for (const std::size_t index : cables) {
    rows.push_back(row_of(bodies, state, index));
  }
  // projected Gauss-Seidel: one impulse after the other, none of them below zero in sum
  const double enough = solve_rounding * speed_of(bodies.the_case(), bodies.state_of(state));
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

template CableVector strike(Bodies<Case>&, SimTK::State&, CableSet, const CableVector&);
template CableVector strike(Bodies<SpatialSystem>&, SimTK::State&, CableSet, const CableVector&);

}  // namespace tautline::simbody
