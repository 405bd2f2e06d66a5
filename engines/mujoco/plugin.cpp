// MuJoCo: generalised coordinates, in double precision. A cable is a spatial tendon.

#include "tautline/plugin.hpp"

#include <mujoco/mujoco.h>

#include "library.hpp"
#include "models.hpp"

namespace tautline::mujoco {
namespace {

EngineTable table() {
  use_library();
  return {.name = "mujoco",
          .version = mj_versionString(),
          .precision = precision_of<mjtNum>,
          .families = {tendon_limit_models(), impulse_models(), event_models()},
          .dimensions = 3};
}

}  // namespace
}  // namespace tautline::mujoco

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::mujoco::table>)
