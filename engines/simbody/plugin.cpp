// Simbody: multibody dynamics in generalised coordinates, with error-controlled integrators.

#include "tautline/plugin.hpp"

#include <string>

#include "models.hpp"
#include "simbody.hpp"

namespace tautline::simbody {
namespace {

std::string version() {
  int major = 0;
  int minor = 0;
  int build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

EngineTable table() {
  return {.name = "simbody",
          .version = version(),
          .precision = precision_of<SimTK::Real>,
          .families = {rope_models(), event_handler_models()},
          .dimensions = 3};
}

}  // namespace
}  // namespace tautline::simbody

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::simbody::table>)
