// A cable is a constraint class of our own, as Chipmunk's joints are: it acts while the cable is
// overstretched where a step has taken the body (`row`), or already when the next step would
// overstretch it (`early`).

#include <algorithm>

#include "cable_constraint.hpp"
#include "models.hpp"

namespace tautline::chipmunk {
namespace {

/// Two coupled rows converge by a factor per iteration; Chipmunk's 10 leave an order of cables.
constexpr int iterations = 50;

class RowSimulation final : public Simulation {
 public:
  RowSimulation(const Case& the_case, Activation activation, double step)
      : world_(the_case), impulses_(the_case.cables.size()) {
    cables_ = cable_constraints(the_case, world_);
    cpSpaceSetIterations(world_.space(), iterations);
    for (const auto& cable : cables_) {
      cable->act_in_steps({activation, usual_correction / step});
      world_.add(cable->constraint());
    }
  }

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    world_.advance(dt);
    std::transform(cables_.begin(), cables_.end(), impulses_.begin(),
                   [](const auto& cable) { return cable->impulse(); });
  }

 private:
  std::vector<std::unique_ptr<CableConstraint>> cables_;  // the world points to them: they go last
  World world_;
  std::vector<double> impulses_;
};

ModelEntry entry(std::string name, std::string sentence, Activation activation) {
  return {
      {std::move(name),
       std::move(sentence),
       {{"cpSpaceSetIterations", "50",
         "Two coupled rows converge slowly: with Chipmunk's 10 the order of the cables shows."}}},
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
            "A constraint of its own class while the cable is overstretched where a step has "
            "moved the body; it asks for the larger of the bounce and 0.2 of the overstretch "
            "per step.",
            Activation::overstretched),
      entry("early", "The same constraint already when the next step would overstretch the cable.",
            Activation::crossing)};
}

}  // namespace tautline::chipmunk
