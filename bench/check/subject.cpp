#include "bench/check/subject.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "tautline/flight.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

Flight flight_of(const Engine& engine, const std::string& model) {
  Case fall = bouncing_ball();
  fall.cables.front().length = 100.0;
  const auto simulation = engine.start(fall, model, 1.0);
  simulation->step(1.0);
  const double fallen = fall.initial.position.y() - simulation->state().position.y();
  if (fallen > 0.75) {
    return Flight::velocity_first;
  }
  return fallen > 0.25 ? Flight::parabola : Flight::position_first;
}

/// What an engine reports, held against the case before anyone reads it.
class CheckedSimulation final : public Simulation {
 public:
  CheckedSimulation(std::unique_ptr<Simulation> inner, std::size_t cables)
      : inner_(std::move(inner)), cables_(cables) {}

  [[nodiscard]] State state() const override { return inner_->state(); }
  void step(double dt) override { inner_->step(dt); }
  [[nodiscard]] std::optional<Stop> stopped() const override { return inner_->stopped(); }

  [[nodiscard]] std::span<const double> impulses() const override {
    const std::span<const double> impulses = inner_->impulses();
    if (impulses.size() != cables_) {
      throw std::runtime_error(
          fmt::format("it gives {} impulses for {} cables", impulses.size(), cables_));
    }
    return impulses;
  }

  [[nodiscard]] std::span<const Event> events() const override {
    for (const Event& event : inner_->events()) {
      for (const std::size_t index : event.cables) {
        if (index >= cables_) {
          throw std::runtime_error("it gives an event of a cable that is not of the case");
        }
      }
      if (static_cast<std::size_t>(event.impulses.size()) != event.cables.size()) {
        throw std::runtime_error("it gives an event without an impulse for each of its cables");
      }
    }
    return inner_->events();
  }

 private:
  std::unique_ptr<Simulation> inner_;
  std::size_t cables_;
};

}  // namespace

std::string_view to_string(Flight flight) {
  switch (flight) {
    case Flight::parabola:
      return "the exact parabola";
    case Flight::velocity_first:
      return "semi-implicit Euler, velocity first";
    case Flight::position_first:
      break;
  }
  return "semi-implicit Euler, position first";
}

State slack_step(State state, const Vec2& gravity, double dt, Flight flight) {
  if (flight == Flight::parabola) {
    return fly(state, gravity, dt);
  }
  if (flight == Flight::velocity_first) {
    state.velocity += dt * gravity;
  }
  state.position += dt * state.velocity;
  state.angle += dt * state.spin;
  if (flight == Flight::position_first) {
    state.velocity += dt * gravity;
  }
  return state;
}

State at_the_solve(State before, double dt, Flight flight) {
  if (flight == Flight::position_first) {
    before.position += dt * before.velocity;
    before.angle += dt * before.spin;
  }
  return before;
}

Subject::Subject(const Engine& engine, std::string model)
    : engine_(&engine),
      model_(std::move(model)),
      in_double_(engine.info().precision == "float64"),
      flight_(flight_of(engine, model_)) {}

std::unique_ptr<Simulation> Subject::start(const Case& the_case, double step) const {
  return std::make_unique<CheckedSimulation>(engine_->start(the_case, model_, step),
                                             the_case.cables.size());
}

}  // namespace tautline::bench
