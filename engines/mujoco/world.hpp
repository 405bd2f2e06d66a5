#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "world_xml.hpp"

namespace tautline::mujoco {

/// A MuJoCo model of a case and its data. Throws std::runtime_error where MuJoCo refuses the case,
/// reports an error or warns.
class World {
 public:
  World(const Case& the_case, Integrator integrator, const std::vector<TendonLimit>& limits = {});

  [[nodiscard]] State state() const;

  /// Puts the body there.
  void place(const State& state);

  /// Adds `change` to the body's velocity [m/s].
  void kick(const Vec2& change);

  /// One `mj_step` of `dt` [s].
  void advance(double dt);

  /// The force of the limit of each tendon [N], >= 0, in the latest evaluation of an `advance`.
  [[nodiscard]] std::vector<double> limit_forces() const;

  /// Every cable at the present pose, as MuJoCo measures its tendon.
  [[nodiscard]] std::vector<CableRow> look();

  /// The impulses [N s], >= 0, after which the gap of each of `cables` opens with at least its rate
  /// of `rates` [m/s], found with MuJoCo's `ten_J` and mass matrix, and applied. MuJoCo's own
  /// solver gives forces of a limit that takes time, and no impulses.
  CableVector pull(CableSet cables, const CableVector& rates);

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };

  const Case case_;
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
};

/// The settings every model needs: those of `World`.
[[nodiscard]] std::vector<Setting> world_settings();

}  // namespace tautline::mujoco
