#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/clock.hpp"
#include "tautline/model_table.hpp"
#include "tautline/system_loads.hpp"

// For engines that take constraint rows of their user's own. `Rows` is what such an engine has: a
// one-sided row for each cable of a case.
//
//   void pull(index, row, rate)  from now on it acts: after a solve the gap of `row` opens with at
//                                least `rate` [m/s]
//   void let_go(index)           from now on it does not
//   double impulse(index)        of the latest step or solve [N s], >= 0
//
// A `RowWorld` has them too, and a body that steps:
//
//   RowWorld(the_case, own...)
//   State state() const
//   void place(state)            puts the body there
//   void advance(dt, look)       one step of `dt` [s], which calls look() where it wants to know
//                                what the rows ask for: with the pose and velocity of then
//   bool asleep() const          optional: true if the engine has left the body out of the step
//   void add(loads)              optional: forces and moments that act in the next step, too
//   using InSpace = ...          optional: the same for a system, whose rows are SystemRows

namespace tautline {

/// A cable is a row while `activation` says so; it asks for the larger of the bounce and what
/// `push_rate` takes out of the overstretch. `out_of_overstretch` does the rest.
template <class RowWorld, class TheCase = Case>
class RowSimulation final : public BasicSimulation<TheCase>, public TensionImpulses {
 public:
  template <class... Own>
  RowSimulation(const TheCase& the_case, const RunSettings& run, Activation activation,
                const Own&... own)
      : case_(the_case),
        activation_(activation),
        correction_(usual_correction / run.step),
        world_(the_case, own...),
        impulses_(the_case.cables.size()),
        tension_impulses_(the_case.cables.size()) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::span<const double> tension_impulses() const override {
    return tension_impulses_;
  }

  /// Adds these to the loads of the next step.
  void pull(const std::vector<BodyLoad>& loads) {
    pulls_ = loads;
    world_.add(loads);
  }

  void step(double dt) override {
    world_.advance(dt, [this, dt] { look(dt); });
    clock_.advance(dt);
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      impulses_[index] = asleep() ? 0.0 : world_.impulse(index);
      tension_impulses_[index] =
          asleep() ? std::numeric_limits<double>::quiet_NaN() : impulses_[index];
    }
    if (asleep()) {
      return;
    }
    if (const auto moved = out_of_overstretch(case_, world_.state(), correction_, dt, pulls_)) {
      world_.place(*moved);
    }
  }

 private:
  [[nodiscard]] bool asleep() const {
    if constexpr (requires { world_.asleep(); }) {
      return world_.asleep();
    }
    return false;
  }

  /// Tells each row what it asks for in a step of `dt` [s].
  void look(double dt) {
    const StateOf<TheCase> now = at_time_of_step(world_.state(), clock_);
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      const auto& cable = case_.cables[index];
      const auto row = row_in_step(cable, now, dt);
      if (acts(row, activation_, dt)) {
        const double rate = wanted_rate(row, restitution(cable, row.rate), correction_,
                                        change_in_step(case_, index, now, dt, pulls_));
        world_.pull(index, row, rate_of_bodies(row, rate));
      } else {
        world_.let_go(index);
      }
    }
  }

  const TheCase case_;
  Activation activation_;
  double correction_;  // [1/s], part of the overstretch
  RowWorld world_;
  Clock clock_;
  std::vector<BodyLoad> pulls_;  // of the step; empty: none
  std::vector<double> impulses_;
  std::vector<double> tension_impulses_;
};

/// A model of such rows; `own` goes to the world.
template <class RowWorld, class... Own>
// NOLINTNEXTLINE(performance-unnecessary-value-param): as in event_model
[[nodiscard]] ModelEntry row_model(Model model, Activation activation, Own... own) {
  ModelEntry result = {.model = std::move(model),
                       .start = makes<RowSimulation<RowWorld>>(activation, own...),
                       .follows_speed = true};
  if constexpr (requires { typename RowWorld::InSpace; } && sizeof...(Own) == 0) {
    result.start_system =
        makes<RowSimulation<typename RowWorld::InSpace, SpatialSystem>>(activation);
  }
  return result;
}

/// What `row` and `early` say of themselves where the engine looks at the rows as a step starts.
struct RowSentences {
  std::string row =
      "A one-sided constraint row from the step after the cable is overstretched; it asks for the "
      "bounce, and takes 0.2 of the overstretch out per step without throwing the body back.";
  std::string early =
      "The same row already in the step that would overstretch the cable: the bounce comes up to "
      "one step early.";
};

/// The models `row` and `early`.
template <class RowWorld>
[[nodiscard]] std::vector<ModelEntry> row_and_early(const std::vector<Setting>& settings,
                                                    const RowSentences& sentences = {},
                                                    const std::vector<Setting>& in_space = {}) {
  std::vector<ModelEntry> result = {
      row_model<RowWorld>({.name = "row", .sentence = sentences.row, .settings = settings},
                          Activation::overstretched),
      row_model<RowWorld>({.name = "early", .sentence = sentences.early, .settings = settings},
                          Activation::crossing)};
  for (ModelEntry& entry : result) {
    if (entry.start_system) {
      entry.model.in_space = in_space;
    }
  }
  return result;
}

/// The impulses [N s] of one solve of the rows of `cables`, which ask for `rates` [m/s] in `state`.
/// `solve` is the engine's, without moving.
template <class Rows, class TheCase, class Solve>
[[nodiscard]] CableVector solve_rows(Rows& rows, const TheCase& the_case,
                                     const StateOf<TheCase>& state, CableSet cables,
                                     const CableVector& rates, Solve solve) {
  Eigen::Index position = 0;
  for (const std::size_t index : cables) {
    const auto row = cable_row(the_case.cables[index], state);
    rows.pull(index, row, rate_of_bodies(row, rates[position++]));
  }
  solve();
  CableVector impulses(rates.size());
  position = 0;
  for (const std::size_t index : cables) {
    impulses[position++] = rows.impulse(index);
    rows.let_go(index);
  }
  return impulses;
}

}  // namespace tautline
