#pragma once

#include <LagrangianScleronomousR.hpp>
#include <NewtonEulerR.hpp>

#include <utility>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/system.hpp"

namespace tautline::siconos_engine {

/// A cable as Siconos' relation between the body's coordinates q = (x, y, angle) and one output:
/// y = gap, its rate H q' and its acceleration H q'' + H' q'.
class CableRelation final : public LagrangianScleronomousR {
 public:
  explicit CableRelation(Cable cable) : cable_(std::move(cable)) {}

  void computeh(const BlockVector& q, BlockVector& z, SiconosVector& y) override;
  void computeJachq(const BlockVector& q, BlockVector& z) override;
  void computeDotJachq(const BlockVector& q, BlockVector& z, const BlockVector& rate) override;

 private:
  const Cable cable_;
};

/// A body's place as Siconos has it: a position and a quaternion.
inline constexpr unsigned int place_numbers = 7;
/// Its twist: a velocity in the world and a spin in the body's axes.
inline constexpr unsigned int twist_numbers = 6;

/// A cable of a system as a relation between the places of its bodies, one after the other, and
/// the gap. Its gradient is that along their twists.
class SystemCableRelation final : public NewtonEulerR {
 public:
  /// `on` are the bodies that it pulls at, in the order in which they are linked.
  SystemCableRelation(SpatialCable cable, std::vector<std::size_t> on, std::size_t bodies)
      : cable_(std::move(cable)), on_(std::move(on)), bodies_(bodies) {}

  void computeh(double time, const BlockVector& places, SiconosVector& y) override;
  void computeJachqT(Interaction& interaction, std::shared_ptr<BlockVector> places) override;

 private:
  [[nodiscard]] SpatialSystemState state_of(double time, const BlockVector& places) const;

  const SpatialCable cable_;
  const std::vector<std::size_t> on_;
  std::size_t bodies_;
};

}  // namespace tautline::siconos_engine
