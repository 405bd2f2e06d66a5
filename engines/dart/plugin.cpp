// DART: rigid bodies in generalised coordinates, double precision, open to constraints of one's
// own. The namespace is not `dart`, which is the library's.

#include "tautline/plugin.hpp"

#include "models.hpp"
#include "world.hpp"

namespace tautline::dart_engine {
namespace {

EngineTable table() {
  return {.name = "dart",
          .version = version(),
          .precision = precision_of<double>,
          .families = {row_models(), event_models()},
          .dimensions = 3};
}

}  // namespace
}  // namespace tautline::dart_engine

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::dart_engine::table>)
