#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/system_loads.hpp"
#include "world_xml.hpp"

namespace tautline::mujoco {

/// A MuJoCo model and its data. Throws std::runtime_error where MuJoCo refuses the model, reports
/// an error or warns.
class BareWorld {
 public:
  /// The force of the limit of each tendon [N], >= 0, in the latest evaluation of an `advance`.
  [[nodiscard]] std::vector<double> limit_forces() const;

 protected:
  explicit BareWorld(const std::string& xml);

  /// One `mj_step` of `dt` [s].
  void step(double dt);

  /// Measures the tendons at the present pose.
  void measure();

  /// The impulses [N s], >= 0, after which the ways of the bodies let each of `cables` open with at
  /// least its rate of `rates` [m/s], found with MuJoCo's `ten_J` and mass matrix, and applied.
  /// `Freedoms` is how many coordinates have velocities, `Most` at most.
  template <int Freedoms, int Most, class TheCase>
  CableVector apply(CableSet cables, const CableVector& rates, double rounding);

  [[nodiscard]] mjModel& model() { return *model_; }
  [[nodiscard]] mjData& data() { return *data_; }
  [[nodiscard]] const mjData& data() const { return *data_; }

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };

  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
};

/// The model of a case.
class World : public BareWorld {
 public:
  using Rows = std::vector<CableRow>;

  World(const Case& the_case, Integrator integrator, const std::vector<TendonLimit>& limits = {});

  [[nodiscard]] State state() const;

  /// Puts the body there.
  void place(const State& state);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// One `mj_step` of `dt` [s].
  void advance(double dt) { step(dt); }

  /// Every cable at the present pose, as MuJoCo measures its tendon, for a step of `dt` [s].
  [[nodiscard]] Rows look(double dt = 0.0);

  /// The impulses [N s], >= 0, after which the gap of each of `cables` opens with at least its rate
  /// of `rates` [m/s], applied. MuJoCo's own solver gives forces of a limit that takes time, and no
  /// impulses.
  CableVector pull(CableSet cables, const CableVector& rates);

 private:
  const Case case_;
};

/// The model of a system.
class SystemWorld : public BareWorld {
 public:
  using Rows = std::vector<SystemRow>;

  SystemWorld(const SpatialSystem& system, Integrator integrator,
              const std::vector<TendonLimit>& limits = {});

  [[nodiscard]] SpatialSystemState state() const;
  void place(const SpatialSystemState& state);
  void advance(double dt);                       // under what is given to act
  void add(const std::vector<BodyLoad>& loads);  // in the next step, too
  [[nodiscard]] Rows look(double dt = 0.0);
  CableVector pull(CableSet cables, const CableVector& rates);

 private:
  /// Puts moving ends and lengths where they are now, and lets the limits of cables act that do.
  void set_cables();

  const SpatialSystem system_;
  double time_ = 0.0;          // [s]
  bool limits_;                // its tendons have limits
  std::vector<double> given_;  // what a step of a `look` adds to the rate of each gap [m/s]
};

/// The settings every model needs: those of `World`.
[[nodiscard]] std::vector<Setting> world_settings();

/// Settings of models that run systems.
[[nodiscard]] std::vector<Setting> system_settings();

}  // namespace tautline::mujoco
