// Bullet, in the precision it is compiled for: two modules from the same sources. The two builds of
// Bullet export the same symbols; never load both in one process.

#include "tautline/plugin.hpp"

#include <string>

#include "models.hpp"
#include "world.hpp"

namespace tautline::bullet {
namespace {

std::string version() {
  const int number = btGetVersion();  // 324 is 3.24; an inline function: the header's version
  return std::to_string(number / 100) + "." + std::to_string(number % 100);
}

EngineTable table() {
  return {.name = in_double_precision ? "bullet64" : "bullet32",
          .version = version(),
          .precision = precision_of<btScalar>,
          .families = {row_models(), two_phase_models(), contact_models(), bounce_limit_models(),
                       cable_models(), event_models()},
          .dimensions = 3};
}

}  // namespace
}  // namespace tautline::bullet

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::bullet::table>)
