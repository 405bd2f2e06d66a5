#pragma once

#include <LagrangianScleronomousR.hpp>

#include "tautline/case.hpp"

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

}  // namespace tautline::siconos_engine
