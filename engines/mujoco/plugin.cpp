// MuJoCo: generalised coordinates, in double precision. A cable is a spatial tendon.

#include "tautline/plugin.hpp"

#include <mujoco/mujoco.h>

#include "library.hpp"
#include "models.hpp"

namespace tautline::mujoco {
namespace {

class MujocoEngine final : public TableEngine {
 public:
  MujocoEngine()
      : TableEngine("mujoco", mj_versionString(), precision_of<mjtNum>,
                    {tendon_limit_models(), impulse_models(), event_models()}) {
    use_library();
  }
};

}  // namespace
}  // namespace tautline::mujoco

TAUTLINE_PLUGIN(tautline::mujoco::MujocoEngine)
