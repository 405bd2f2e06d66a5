// Box2D: planar, in single precision, with a fixed set of joints.

#include "tautline/plugin.hpp"

#include <box2d/box2d.h>

#include <string>

#include "models.hpp"

namespace tautline::box2d {
namespace {

std::string version() {
  return std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
         std::to_string(b2_version.revision);
}

EngineTable table() {
  return {.name = "box2d",
          .version = version(),
          .precision = precision_of<float>,
          .families = {distance_joint_models(), event_models()}};
}

}  // namespace
}  // namespace tautline::box2d

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::box2d::table>)
