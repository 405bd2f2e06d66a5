#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"
#include "tautline/detail/flight.hpp"

namespace tautline::bench::test {

inline constexpr double planted_step = 1e-3;  // [s]

/// The flight of a planted run: a parabola that an integrator's `bias` [m/s] moves faster than its
/// velocity says, under a gravity that may be wrong.
struct PlantedFlight {
  Vec2 gravity;
  Vec2 bias = Vec2::Zero();

  [[nodiscard]] State start(State state) const {
    state.velocity += bias;
    return state;
  }
  State operator()(const State& state, double dt) const {
    State result = fly(start(state), gravity, dt);
    result.velocity -= bias;
    return result;
  }
};

/// Where a planted impact is, against the exact contact of its flight, and the gap rate after it.
struct Planted {
  using Rate = std::function<double(const Case&, std::size_t cable, const State& at_contact,
                                    const State& at_jump)>;
  double delay = 0.0;                                              // [s]
  Rate rate = nullptr;                                             // [m/s]; the exact one without
  std::function<void(State&, std::size_t count)> spoil = nullptr;  // the state after
};

/// The rate with which the exact motion opens `cable` again [m/s].
double exact_rate(const Case& the_case, std::size_t cable, const State& at_contact);

/// The state after an impact that leaves `cable` with `rate` [m/s].
State bounced(const Case& the_case, const State& before, std::size_t cable, double rate);

/// A run made of exact flights and exact impacts but for what is planted, sampled every step up to
/// `end`. Impacts are named at their instants.
Trajectory planted_run(const Case& the_case, double end, const Planted& planted,
                       const PlantedFlight& flight);

}  // namespace tautline::bench::test
