#include "cable_relation.hpp"

#include <BlockVector.hpp>
#include <SiconosVector.hpp>
#include <SimpleMatrix.hpp>

#include "tautline/system_geometry.hpp"

namespace tautline::siconos_engine {
namespace {

State pose_of(const BlockVector& q) {
  State state;
  state.position = Vec2(q(0), q(1));
  state.angle = q(2);
  return state;
}

/// `row`, or no direction where an end lies on the other one: such a cable is slack.
template <class Row>
Row where_it_has_one(const Row& row) {
  return row.allFinite() ? row : Row(Row::Zero(row.size()));
}

/// The row of a matrix that a cable has.
void put(SimpleMatrix& row, const Eigen::Vector3d& values) {
  for (unsigned int column = 0; column < 3; ++column) {
    row(0, column) = values[column];
  }
}

}  // namespace

void CableRelation::computeh(const BlockVector& q, BlockVector& /*z*/, SiconosVector& y) {
  y(0) = gap(cable_, pose_of(q));
}

void CableRelation::computeJachq(const BlockVector& q, BlockVector& /*z*/) {
  if (_jachq) {
    put(*_jachq, where_it_has_one(gap_gradient(cable_, pose_of(q))));
  }
}

void CableRelation::computeDotJachq(const BlockVector& q, BlockVector& /*z*/,
                                    const BlockVector& rate) {
  if (_dotjachq) {
    State state = pose_of(q);
    state.velocity = Vec2(rate(0), rate(1));
    state.spin = rate(2);
    put(*_dotjachq, where_it_has_one(gap_gradient_rate(cable_, state)));
  }
}

SpatialSystemState SystemCableRelation::state_of(double time, const BlockVector& places) const {
  SpatialSystemState result;
  result.time = time;
  result.bodies.resize(bodies_);
  unsigned int first = 0;
  for (const std::size_t body : on_) {
    SpatialState& place = result.bodies[body];
    for (unsigned int i = 0; i < 3; ++i) {
      place.position[i] = places(first + i);
    }
    for (unsigned int i = 0; i < 4; ++i) {
      place.orientation[i] = places(first + 3 + i);
    }
    place.orientation.normalize();
    first += place_numbers;
  }
  return result;
}

void SystemCableRelation::computeh(double time, const BlockVector& places, SiconosVector& y) {
  y(0) = gap(cable_, state_of(time, places));
}

void SystemCableRelation::computeJachqT(Interaction& /*interaction*/,
                                        std::shared_ptr<BlockVector> places) {
  const RowOf<SpatialSystem> gradient =
      where_it_has_one(gap_gradient(cable_, state_of(0.0, *places)));
  unsigned int first = 0;
  for (const std::size_t body : on_) {
    for (unsigned int i = 0; i < twist_numbers; ++i) {
      (*_jachqT)(0, first + i) = gradient[static_cast<Eigen::Index>(twist_numbers * body + i)];
    }
    first += twist_numbers;
  }
}

}  // namespace tautline::siconos_engine
