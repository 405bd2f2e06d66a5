#include "bench/check/subject.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "bench/check/measure.hpp"

namespace tautline::bench {
namespace {

/// "x is NaN", "vy is -infinity" for the first number of `state` that is not finite; else "".
std::string fault_of(const State& state) {
  const std::pair<const char*, double> numbers[] = {
      {"x", state.position.x()},  {"y", state.position.y()},  {"the angle", state.angle},
      {"vx", state.velocity.x()}, {"vy", state.velocity.y()}, {"the spin", state.spin}};
  for (const auto& [name, number] : numbers) {
    if (!std::isfinite(number)) {
      return fmt::format("{} is {}", name, not_finite(number));
    }
  }
  return "";
}

/// What an engine reports, compared with the case before anyone reads it.
class CheckedSimulation final : public Simulation {
 public:
  CheckedSimulation(std::unique_ptr<Simulation> inner, std::size_t cables)
      : inner_(std::move(inner)), cables_(cables) {}

  [[nodiscard]] State state() const override {
    const State state = inner_->state();
    if (const std::string fault = fault_of(state); !fault.empty()) {
      throw NoMotion(fmt::format("{} at t = {:.4g}", fault, time_));
    }
    return state;
  }
  void step(double dt) override {
    inner_->step(dt);
    time_ += dt;
  }
  [[nodiscard]] std::optional<Stop> stopped() const override { return inner_->stopped(); }

  [[nodiscard]] std::span<const double> impulses() const override {
    const std::span<const double> impulses = inner_->impulses();
    if (impulses.size() != cables_) {
      throw NoMotion(fmt::format("it gives {} impulses for {} cables", impulses.size(), cables_));
    }
    for (std::size_t index = 0; index < cables_; ++index) {
      if (!std::isfinite(impulses[index])) {
        throw NoMotion(fmt::format("the impulse of cable {} is {} at t = {:.4g}", index,
                                   not_finite(impulses[index]), time_));
      }
    }
    return impulses;
  }

  [[nodiscard]] std::span<const Event> events() const override {
    for (const Event& event : inner_->events()) {
      for (const std::size_t index : event.cables) {
        if (index >= cables_) {
          throw NoMotion("it gives an event of a cable that is not of the case");
        }
      }
      if (static_cast<std::size_t>(event.impulses.size()) != event.cables.size()) {
        throw NoMotion("it gives an event without an impulse for each of its cables");
      }
    }
    return inner_->events();
  }

 private:
  std::unique_ptr<Simulation> inner_;
  std::size_t cables_;
  double time_ = 0.0;  // [s]
};

}  // namespace

Subject::Subject(const Engine& engine, std::string model, std::map<std::string, double> parameters)
    : engine_(&engine),
      model_(std::move(model)),
      parameters_(std::move(parameters)),
      in_double_(engine.info().precision == "float64"),
      flight_(flight_of(engine, model_, rounding())),
      turn_(turn_of(engine, model_, rounding())) {}

std::unique_ptr<Simulation> Subject::start(const Case& the_case, double step) const {
  RunSettings settings = step;
  settings.parameters = parameters_;
  return std::make_unique<CheckedSimulation>(engine_->start(the_case, model_, settings),
                                             the_case.cables.size());
}

}  // namespace tautline::bench
