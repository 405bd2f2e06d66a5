#include "cable_relation.hpp"

#include <BlockVector.hpp>
#include <SiconosVector.hpp>
#include <SimpleMatrix.hpp>

#include "tautline/geometry.hpp"

namespace tautline::siconos_engine {
namespace {

State pose_of(const BlockVector& q) {
  State state;
  state.position = Vec2(q(0), q(1));
  state.angle = q(2);
  return state;
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
    put(*_jachq, gap_gradient(cable_, pose_of(q)));
  }
}

void CableRelation::computeDotJachq(const BlockVector& q, BlockVector& /*z*/,
                                    const BlockVector& rate) {
  if (_dotjachq) {
    State state = pose_of(q);
    state.velocity = Vec2(rate(0), rate(1));
    state.spin = rate(2);
    put(*_dotjachq, gap_gradient_rate(cable_, state));
  }
}

}  // namespace tautline::siconos_engine
