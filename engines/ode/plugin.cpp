// ODE: its contact joint has exact restitution of its own, given bounce_vel 0.

#include "tautline/plugin.hpp"

#include "library.hpp"
#include "models.hpp"

namespace tautline::ode {
namespace {

class OdeEngine final : public TableEngine {
 public:
  OdeEngine()
      : TableEngine("ode", TAUTLINE_ODE_VERSION, precision(),
                    {fixed_step_models(), cable_models(), event_models()}) {}
};

}  // namespace
}  // namespace tautline::ode

TAUTLINE_PLUGIN(tautline::ode::OdeEngine)
