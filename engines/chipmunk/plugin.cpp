// Chipmunk: planar, in double precision, and open to constraints of one's own.

#include "tautline/plugin.hpp"

#include "chipmunk.hpp"
#include "models.hpp"

namespace tautline::chipmunk {
namespace {

class ChipmunkEngine final : public TableEngine {
 public:
  ChipmunkEngine()
      : TableEngine("chipmunk", cpVersionString, precision_of<cpFloat>,
                    {row_models(), slide_joint_models(), event_models()}) {}
};

}  // namespace
}  // namespace tautline::chipmunk

TAUTLINE_PLUGIN(tautline::chipmunk::ChipmunkEngine)
