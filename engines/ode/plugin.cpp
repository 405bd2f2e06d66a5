// ODE: its contact joint has exact restitution of its own, given bounce_vel 0.

#include "tautline/plugin.hpp"

#include "library.hpp"
#include "models.hpp"

namespace tautline::ode {
namespace {

const std::vector<ModelEntry>& table() {
  static const std::vector<ModelEntry> entries = [] {
    std::vector<ModelEntry> all = fixed_step_models();
    for (ModelEntry& entry : event_models()) {
      all.push_back(std::move(entry));
    }
    return all;
  }();
  return entries;
}

class OdeEngine final : public Engine {
 public:
  [[nodiscard]] EngineInfo info() const override {
    return {"ode", TAUTLINE_ODE_VERSION, precision(), models(table())};
  }
  [[nodiscard]] std::unique_ptr<Simulation> start(const Case& the_case, std::string_view model,
                                                  const RunSettings& settings) const override {
    return start_model(table(), model, the_case, settings);
  }
};

}  // namespace
}  // namespace tautline::ode

TAUTLINE_PLUGIN(tautline::ode::OdeEngine)
