#include "bench/check/subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// A contact that goes on for longer is a cable that is held taut [steps].
constexpr int longest_hit = 200;

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

void run(Simulation& simulation, double step, double end,
         const std::function<void(const Moment&)>& look) {
  const auto steps = static_cast<long>(std::llround(end / step));
  for (long k = 1; k <= steps; ++k) {
    const State before = simulation.state();
    simulation.step(step);
    const auto stop = simulation.stopped();
    look({stop ? stop->time : static_cast<double>(k) * step, before, simulation.state()});
    if (stop) {
      return;
    }
  }
}

void run_whole(Simulation& simulation, double step, double end,
               const std::function<void(const Moment&)>& look) {
  run(simulation, step, end, look);
  if (const auto stop = simulation.stopped()) {
    throw RunStopped(fmt::format("the run stopped at t = {:.4g}: {}", stop->time, stop->reason));
  }
}

std::optional<Hit> first_hit(const Subject& subject, const Case& the_case, double step,
                             double end) {
  const auto simulation = subject.start(the_case, step);
  std::optional<Hit> hit;
  bool over = false;
  run_whole(*simulation, step, end, [&](const Moment& moment) {
    const double impulse = simulation->impulses()[0];
    over = over || (hit && (impulse <= 0.0 || hit->steps >= longest_hit));
    if (over || impulse <= 0.0) {
      return;
    }
    if (!simulation->events().empty()) {
      const Event& event = simulation->events().front();
      hit = {event.before, event.after, event.impulses[0], 0};
      over = true;
      return;
    }
    const State pose = at_the_solve(moment.before, step, subject.flight());
    if (!hit) {
      hit = {pose, pose, 0.0, 0};
    }
    hit->after = pose;
    hit->after.velocity = moment.after.velocity;
    hit->after.spin = moment.after.spin;
    hit->impulse += impulse;
    ++hit->steps;
  });
  return hit;
}

double worse(double a, double b) {
  return std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b);
}

double largest_difference(const State& a, const State& b) {
  double largest = 0.0;
  for (const double apart :
       {a.position.x() - b.position.x(), a.position.y() - b.position.y(), a.angle - b.angle,
        a.velocity.x() - b.velocity.x(), a.velocity.y() - b.velocity.y(), a.spin - b.spin}) {
    largest = worse(largest, std::abs(apart));
  }
  return largest;
}

Case shipped_case(std::string_view name) {
  for (const Case& the_case : shipped_cases()) {
    if (the_case.name == name) {
      return the_case;
    }
  }
  throw std::invalid_argument("no case ships under the name " + std::string(name));
}

Case standard_breakwater(double restitution) {
  Breakwater parameters = table_5_1().front().parameters;
  parameters.e = restitution;
  return breakwater(parameters, "standard");
}

State mirrored(State state) {
  state.position.x() = -state.position.x();
  state.angle = -state.angle;
  state.velocity.x() = -state.velocity.x();
  state.spin = -state.spin;
  return state;
}

Case mirrored(const Case& the_case) {
  Case result = the_case;
  result.gravity.x() = -result.gravity.x();
  result.initial = mirrored(result.initial);
  for (Cable& cable : result.cables) {
    cable.anchor.x() = -cable.anchor.x();
    cable.attachment.x() = -cable.attachment.x();
  }
  std::reverse(result.cables.begin(), result.cables.end());
  return result;
}

}  // namespace tautline::bench
