// The smallest plug-in: an engine in which nothing moves.

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tautline/plugin.hpp"

namespace {

class StillSimulation final : public tautline::Simulation {
 public:
  explicit StillSimulation(const tautline::Case& the_case)
      : state_(the_case.initial), impulses_(the_case.cables.size(), 0.0) {}

  [[nodiscard]] tautline::State state() const override { return state_; }
  void step(double /*dt*/) override {}
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

 private:
  tautline::State state_;
  std::vector<double> impulses_;
};

class StillEngine final : public tautline::Engine {
 public:
  [[nodiscard]] tautline::EngineInfo info() const override {
    return {.name = "still",
            .version = "1",
            .precision = "float64",
            .models = {{.name = "still", .sentence = "Nothing moves.", .settings = {}}}};
  }
  [[nodiscard]] std::unique_ptr<tautline::Simulation> start(
      const tautline::Case& the_case, std::string_view /*model*/,
      const tautline::RunSettings& /*settings*/) const override {
    return std::make_unique<StillSimulation>(the_case);
  }
};

}  // namespace

TAUTLINE_PLUGIN(StillEngine)
