// A cable is a constraint of our own, as DART's joint limits are: it acts while the cable is
// overstretched when a step starts (`row`), or already when the step would overstretch it
// (`early`). DART solves the rows by pivoting, so that nothing is left to tune.

#include <algorithm>
#include <utility>

#include "models.hpp"
#include "world.hpp"

namespace tautline::dart_engine {
namespace {

class RowSimulation final : public Simulation {
 public:
  RowSimulation(const Case& the_case, Activation activation, double step)
      : case_(the_case),
        activation_(activation),
        correction_(usual_correction / step),
        world_(the_case),
        impulses_(the_case.cables.size()) {}

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    const State start = world_.state();  // before gravity: DART asks constraints after it
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      const Cable& cable = case_.cables[index];
      const CableRow row = cable_row(cable, start);
      if (acts(row, activation_, dt)) {
        world_.pull(index, row, wanted_rate(row, restitution(cable, row.rate), correction_));
      } else {
        world_.let_go(index);
      }
    }
    world_.advance(dt);
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      impulses_[index] = world_.impulse(index);
    }
  }

 private:
  const Case case_;
  Activation activation_;
  double correction_;  // [1/s], part of the overstretch
  World world_;
  std::vector<double> impulses_;
};

ModelEntry entry(std::string name, std::string sentence, Activation activation) {
  return {{std::move(name), std::move(sentence), {}},
          [activation](const Case& the_case,
                       const RunSettings& settings) -> std::unique_ptr<Simulation> {
            return std::make_unique<RowSimulation>(the_case, activation, settings.step);
          },
          true};
}

}  // namespace

std::vector<ModelEntry> row_models() {
  return {
      entry("row",
            "A one-sided constraint row from the step after the cable is overstretched; it asks "
            "for the larger of the bounce and 0.2 of the overstretch per step.",
            Activation::overstretched),
      entry("early",
            "The same row already in the step that would overstretch the cable: the bounce comes "
            "up to one step early.",
            Activation::crossing)};
}

}  // namespace tautline::dart_engine
