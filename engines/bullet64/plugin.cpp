// Bullet in double precision (Debian's bullet-float64). Its float build exports the same symbols
// and can never share a process with it.

#include "tautline/plugin.hpp"

#include <string>

#include "models.hpp"
#include "world.hpp"

namespace tautline::bullet {
namespace {

static_assert(sizeof(btScalar) == sizeof(double), "bullet64 needs BT_USE_DOUBLE_PRECISION");

const std::vector<ModelEntry>& table() {
  static const std::vector<ModelEntry> entries = [] {
    std::vector<ModelEntry> all;
    for (auto family : {row_models(), contact_models(), bounce_limit_models(), event_models()}) {
      all.insert(all.end(), family.begin(), family.end());
    }
    return all;
  }();
  return entries;
}

class BulletEngine final : public Engine {
 public:
  [[nodiscard]] EngineInfo info() const override {
    const int version = btGetVersion();  // 324 is 3.24; an inline function: the header's version
    return {"bullet64", std::to_string(version / 100) + "." + std::to_string(version % 100),
            "float64", models(table())};
  }
  [[nodiscard]] std::unique_ptr<Simulation> start(const Case& the_case, std::string_view model,
                                                  const RunSettings& settings) const override {
    return start_model(table(), model, the_case, settings);
  }
};

}  // namespace
}  // namespace tautline::bullet

TAUTLINE_PLUGIN(tautline::bullet::BulletEngine)
