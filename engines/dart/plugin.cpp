// DART: rigid bodies in generalised coordinates, double precision, open to constraints of one's
// own. The namespace is not `dart`, which is the library's.

#include "tautline/plugin.hpp"

#include "models.hpp"
#include "world.hpp"

namespace tautline::dart_engine {
namespace {

class DartEngine final : public TableEngine {
 public:
  DartEngine()
      : TableEngine("dart", version(), precision_of<double>, {row_models(), event_models()}) {}
};

}  // namespace
}  // namespace tautline::dart_engine

TAUTLINE_PLUGIN(tautline::dart_engine::DartEngine)
