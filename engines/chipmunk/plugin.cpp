// Chipmunk: planar, in double precision, and open to constraints of one's own.

#include "tautline/plugin.hpp"

#include "chipmunk.hpp"
#include "models.hpp"

namespace tautline::chipmunk {
namespace {

EngineTable table() {
  return {.name = "chipmunk",
          .version = cpVersionString,
          .precision = precision_of<cpFloat>,
          .families = {row_models(), slide_joint_models(), event_models()}};
}

}  // namespace
}  // namespace tautline::chipmunk

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::chipmunk::table>)
