// A world as it is stepped, with its audit.

#pragma once

#include <memory>

#include "engines/cables/worlds/audit.hpp"

namespace tautline::test {

struct Playing {
  double rate = 60.0;  // steps a second
  Stepping stepping = Stepping::fixed;
  bool quick = false;  // ODE's iterative solver
};

class Run {
 public:
  Run(const World& world, const Playing& playing);

  void step();
  /// Steps until `time` [s], or until a number is none.
  void go_on_until(double time);

  [[nodiscard]] double time() const { return static_cast<double>(steps_) * scene_->dt(); }  // [s]
  [[nodiscard]] double dt() const { return scene_->dt(); }                                  // [s]
  [[nodiscard]] const Findings& findings() const { return audit_->findings(); }
  [[nodiscard]] const Moment& now() const { return audit_->now(); }
  [[nodiscard]] bool is_over() const { return findings().not_a_number.value > 0.0; }

 private:
  World world_;
  Playing playing_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Audit> audit_;
  long steps_ = 0;
};

/// The findings of `seconds` of a world.
[[nodiscard]] Findings findings_of(const World& world, const Playing& playing, double seconds);

}  // namespace tautline::test
