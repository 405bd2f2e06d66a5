#include "bench/measure/attribution/soft_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "bench/measure/attribution/carry.hpp"
#include "bench/measure/reference.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// Steps in the time that the fastest row has by its stiffness or its damping [-].
constexpr double steps_in_time = 100.0;

/// More steps and flights than this are not taken; a flight of a system costs a motion.
template <class TheCase>
constexpr std::size_t most_soft_steps = std::is_same_v<TheCase, Case> ? 400'000 : 20'000;

/// A cable is at its length where its gap is no larger than this, in lengths [-]: some roundings.
constexpr double at_its_length = 1e-12;

/// Precision of the pulls, relative to the largest [-], and the sweeps for it at most.
constexpr double same_pull = 1e-12;
constexpr int most_sweeps = 500;

/// The accelerations that forces give all bodies.
RowOf<Case> by_forces(const Case& the_case, const State& /*state*/) {
  return {the_case.gravity.x(), the_case.gravity.y(), 0.0};
}
RowOf<SpatialSystem> by_forces(const SpatialSystem& system, const SpatialSystemState& state) {
  return free_accelerations(system, state);
}

template <class TheCase>
class SoftMotion {
 public:
  using State = StateOf<TheCase>;

  SoftMotion(const TheCase& the_case, std::span<const SoftRow> rows, double until)
      : case_(the_case),
        rows_(rows),
        until_(until),
        touching_(at_its_length * shortest_cable(the_case)),
        state_(the_case.initial) {
    for (const SoftRow& row : rows) {
      fastest_ = std::max({fastest_, std::sqrt(row.stiffness), row.damping});
    }
  }

  [[nodiscard]] SoftEnd<State> end() {
    for (std::size_t steps = 0; time_ < until_; ++steps) {
      if (steps == most_soft_steps<TheCase>) {
        return {std::nullopt,
                fmt::format("springs and dampers need more than {} steps up to then", steps)};
      }
      if (!stretched(state_).empty()) {
        step();
      } else if (!fly()) {
        return {
            std::nullopt,
            fmt::format("the motion of springs and dampers is not found after t = {:.6g}", time_)};
      }
    }
    return {state_, ""};
  }

 private:
  /// The cables that are at their lengths or beyond.
  [[nodiscard]] CableSet stretched(const State& state) const {
    CableSet result;
    for (std::size_t index = 0; index < rows_.size(); ++index) {
      if (gap(case_.cables[index], state) <= touching_) {
        result.insert(index);
      }
    }
    return result;
  }

  /// Until the first cable reaches its length, or the end. False where no motion is found.
  [[nodiscard]] bool fly() {
    const TheCase flight = restarted(case_, state_, time_, until_ - time_);
    if (!problems(flight).empty()) {
      return false;
    }
    const auto motion = solve(flight, {.max_events = 1});
    if (motion.events().empty()) {
      put(motion.at(flight.duration), until_);
      return motion.end_time() >= flight.duration;
    }
    const auto& event = motion.events().front();
    put(event.kind == EventKind::impact ? event.before : event.after, time_ + event.time);
    return true;
  }

  /// One step; a shorter one where another cable reaches its length in it.
  void step() {
    const CableSet before = stretched(state_);
    double dt = std::min(until_ - time_, 1.0 / (steps_in_time * fastest_));
    State next = after(state_, dt);
    double part = 1.0;
    for (const std::size_t index : stretched(next)) {
      if (!before.contains(index)) {
        const double from = gap(case_.cables[index], state_);
        part = std::min(part, from / (from - gap(case_.cables[index], next)));
      }
    }
    if (part < 1.0) {
      dt *= part;
      next = after(state_, dt);
    }
    put(next, dt < until_ - time_ ? time_ + dt : until_);
  }

  [[nodiscard]] State after(const State& state, double dt) const {
    return pulled(flown(case_, pulled(state, 0.5 * dt), dt), 0.5 * dt);
  }

  /// `state` after the pulls of the stretched cables in `dt` [s], all of them at this pose. A
  /// damper takes the rate of the middle.
  [[nodiscard]] State pulled(const State& state, double dt) const {
    const CableSet cables = stretched(state);
    if (cables.empty()) {
      return state;
    }
    const CableMatrix response = delassus(case_, state, cables);
    const auto forces = by_forces(case_, state);
    CableMatrix matrix = response;
    CableVector wanted(response.rows());
    Eigen::Index row = 0;
    for (const std::size_t index : cables) {
      const SoftRow& law = rows_[index];
      const auto& cable = case_.cables[index];
      const double own = response(row, row);
      matrix.row(row) *= law.load + 0.5 * dt * law.damping;
      matrix(row, row) = (1.0 + 0.5 * dt * law.damping) * own;
      wanted[row++] = -law.load * gap_gradient(cable, state).dot(forces) -
                      law.damping * gap_rate(cable, state) - law.stiffness * gap(cable, state);
    }
    return with_impulses(case_, state, cables, CableVector(dt * pulls(matrix, wanted)));
  }

  /// The pulls T >= 0 with `matrix` T >= `wanted`, equal where T > 0 (Gauss and Seidel).
  [[nodiscard]] static CableVector pulls(const CableMatrix& matrix, const CableVector& wanted) {
    CableVector result = CableVector::Zero(wanted.size());
    double change = 1.0;
    double largest = 0.0;
    for (int sweep = 0; sweep < most_sweeps && change > same_pull * largest; ++sweep) {
      change = 0.0;
      for (Eigen::Index row = 0; row < wanted.size(); ++row) {
        const double others = matrix.row(row).dot(result) - matrix(row, row) * result[row];
        const double pull = std::max(0.0, (wanted[row] - others) / matrix(row, row));
        change = std::max(change, std::abs(pull - result[row]));
        largest = std::max(largest, pull);
        result[row] = pull;
      }
    }
    return result;
  }

  void put(const State& state, double time) {
    state_ = state;
    if constexpr (TheCase::has_several_bodies) {
      state_.time = time;
    }
    time_ = time;
  }

  const TheCase& case_;
  std::span<const SoftRow> rows_;
  double until_;          // [s]
  double touching_;       // [m]
  double fastest_ = 0.0;  // [1/s]
  State state_;
  double time_ = 0.0;  // [s]
};

}  // namespace

SoftEnd<State> soft_motion(const Case& the_case, std::span<const SoftRow> rows, double time) {
  return SoftMotion(the_case, rows, time).end();
}

SoftEnd<SpatialSystemState> soft_motion(const SpatialSystem& system, std::span<const SoftRow> rows,
                                        double time) {
  return SoftMotion(system, rows, time).end();
}

}  // namespace tautline::bench
