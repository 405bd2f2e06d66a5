#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>

#include "bench/cases/bench_case.hpp"
#include "tautline/engine.hpp"
#include "tautline/plain_scheme.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/support.hpp"

// A plain scheme with planted faults, and the systems that it runs.

namespace tautline::test {

using SystemScheme = BasicPlainScheme<SpatialSystem>;

/// A plain scheme that may do something of its own before and after each step of `dt` [s].
class Spoiled final : public SystemSimulation {
 public:
  using Spoil = std::function<void(SystemScheme&, double dt)>;

  Spoiled(const SpatialSystem& system, Spoil before, Spoil after)
      : scheme_(system, SystemScheme::Acts::late),
        before_(std::move(before)),
        after_(std::move(after)) {}

  void step(double dt) override {
    if (before_) {
      before_(scheme_, dt);
    }
    scheme_.step(dt);
    if (after_) {
      after_(scheme_, dt);
    }
  }
  [[nodiscard]] SpatialSystemState state() const override { return scheme_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return scheme_.impulses(); }

 private:
  SystemScheme scheme_;
  Spoil before_;
  Spoil after_;
};

/// One of those that are shipped in space.
inline SpatialSystem shipped(const std::string& name) {
  return bench::test::named(shipped_spatial_systems(), name);
}
/// One of the plane, in the plane z = 0.
inline SpatialSystem planar(const std::string& name) {
  return bench::in_space(bench::test::named(shipped_systems(), name));
}

/// What takes the gyroscopic term out of a flight of one body: its spin in the world goes on as it
/// is.
class NoGyroscopicTerm {
 public:
  /// Before a step.
  void remember(const SystemScheme& scheme) {
    const SpatialState& body = scheme.state().bodies[0];
    spin_ = in_the_world(body, body.spin);
  }
  /// After it.
  void keep(SystemScheme& scheme) const {
    SpatialState& body = scheme.state().bodies[0];
    if (scheme.impulses()[0] == 0.0) {
      body.spin = in_the_body(body, spin_);
    }
  }

 private:
  Eigen::Vector3d spin_ = Eigen::Vector3d::Zero();  // [rad/s], in the world
};

}  // namespace tautline::test
