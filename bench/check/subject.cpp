#include "bench/check/subject.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <string_view>
#include <utility>

#include "bench/check/measure.hpp"
#include "bench/data/coordinates.hpp"

namespace tautline::bench {
namespace {

/// "x is NaN", "vy is -infinity" for the first number of `state` that is not finite; else "".
template <class OneBody>
std::string fault_of(const OneBody& state) {
  for (const auto& [name, unit, is_rate, number] : coordinates(state)) {
    if (!std::isfinite(number)) {
      const std::string_view word = name;
      return fmt::format("{}{} is {}", word == "angle" || word == "spin" ? "the " : "", word,
                         not_finite(number));
    }
  }
  return "";
}

/// Throws NoMotion unless `state` has all bodies of `the_case`.
void expect_bodies(const Case& /*the_case*/, const State& /*state*/) {}
void expect_bodies(const SpatialSystem& system, const SpatialSystemState& state) {
  if (state.bodies.size() != system.bodies.size()) {
    throw NoMotion(fmt::format("it gives a state of {} bodies for {}", state.bodies.size(),
                               system.bodies.size()));
  }
}

/// The first fault of a body of a system; else empty.
std::string fault_of(const SpatialSystemState& state) {
  for (const SpatialState& body : state.bodies) {
    if (std::string fault = fault_of(body); !fault.empty()) {
      return fault;
    }
  }
  return "";
}

/// What an engine reports, compared with the case before anyone reads it.
template <class TheCase>
class CheckedSimulation final : public BasicSimulation<TheCase> {
 public:
  CheckedSimulation(std::unique_ptr<BasicSimulation<TheCase>> inner, const TheCase& the_case)
      : inner_(std::move(inner)), case_(the_case), cables_(the_case.cables.size()) {}

  [[nodiscard]] StateOf<TheCase> state() const override {
    StateOf<TheCase> state = inner_->state();
    expect_bodies(case_, state);
    if (const std::string fault = fault_of(state); !fault.empty()) {
      throw NoMotion(fmt::format("{} at t = {:.4g}", fault, time_));
    }
    return state;
  }
  void step(double dt) override {
    inner_->step(dt);
    time_ += dt;
  }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override { return inner_->stopped(); }

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

  [[nodiscard]] std::span<const BasicEvent<TheCase>> events() const override {
    for (const BasicEvent<TheCase>& event : inner_->events()) {
      for (const std::size_t index : event.cables) {
        if (index >= cables_) {
          throw NoMotion("it gives an event of a cable that is not of the case");
        }
      }
      expect_bodies(case_, event.before);
      expect_bodies(case_, event.after);
      if (static_cast<std::size_t>(event.impulses.size()) != event.cables.size()) {
        throw NoMotion("it gives an event without an impulse for each of its cables");
      }
    }
    return inner_->events();
  }

 private:
  std::unique_ptr<BasicSimulation<TheCase>> inner_;
  TheCase case_;
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

RunSettings Subject::settings(double step) const {
  RunSettings result = step;
  result.parameters = parameters_;
  return result;
}

std::unique_ptr<Simulation> Subject::start(const Case& the_case, double step) const {
  return std::make_unique<CheckedSimulation<Case>>(engine_->start(the_case, model_, settings(step)),
                                                   the_case);
}

std::unique_ptr<SystemSimulation> Subject::start(const SpatialSystem& system, double step) const {
  try {
    return std::make_unique<CheckedSimulation<SpatialSystem>>(
        engine_->start_system(system, model_, settings(step)), system);
  } catch (const std::exception& error) {
    const std::string_view said = error.what();
    if (said.starts_with(refusal)) {
      throw NotRun(std::string(said.substr(refusal.size())));
    }
    throw;
  }
}

}  // namespace tautline::bench
