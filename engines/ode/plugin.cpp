// ODE: its contact joint has exact restitution of its own, given bounce_vel 0.

#include "tautline/plugin.hpp"

#include "library.hpp"
#include "models.hpp"

namespace tautline::ode {
namespace {

EngineTable table() {
  return {.name = "ode",
          .version = TAUTLINE_ODE_VERSION,
          .precision = precision(),
          .families = {fixed_step_models(), cable_models(), event_models()},
          .dimensions = 3};
}

}  // namespace
}  // namespace tautline::ode

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::ode::table>)
