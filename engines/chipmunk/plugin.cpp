// Chipmunk: planar, in double precision, and open to constraints of one's own.

#include "tautline/plugin.hpp"

#include "chipmunk.hpp"
#include "models.hpp"

namespace tautline::chipmunk {
namespace {

const std::vector<ModelEntry>& table() {
  static const std::vector<ModelEntry> entries = [] {
    std::vector<ModelEntry> all = row_models();
    for (auto more : {slide_joint_models(), event_models()}) {
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }();
  return entries;
}

class ChipmunkEngine final : public Engine {
 public:
  [[nodiscard]] EngineInfo info() const override {
    return {"chipmunk", cpVersionString, sizeof(cpFloat) == 8 ? "float64" : "float32",
            models(table())};
  }
  [[nodiscard]] std::unique_ptr<Simulation> start(const Case& the_case, std::string_view model,
                                                  const RunSettings& settings) const override {
    return start_model(table(), model, the_case, settings);
  }
};

}  // namespace
}  // namespace tautline::chipmunk

TAUTLINE_PLUGIN(tautline::chipmunk::ChipmunkEngine)
