#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tautline/cable_row.hpp"
#include "tautline/clock.hpp"
#include "tautline/elastic_step.hpp"
#include "tautline/model_table.hpp"
#include "tautline/system_loads.hpp"

// For engines that take forces of their user's own. `Stepped` is a simulation of a system with such
// an engine in fixed steps, whose cables are inextensible. It is a SteppedSystemSimulation, or a
// RowSimulation, and has:
//
//   Stepped(system, run, own...)
//   void pull(const std::vector<BodyLoad>& loads)   adds these forces and moments to those of the
//                                                   next step
//
// It throws CableRefused for a cable that it cannot do.

namespace tautline {

/// Elastic cables pull in a step as the law (E1) has it at the start of the step; the inextensible
/// ones are those of `Stepped`, which sees no others.
template <class Stepped>
class SpringSimulation final : public SteppedSystemSimulation {
 public:
  template <class... Own>
  SpringSimulation(const SpatialSystem& system, const RunSettings& run, const Own&... own)
      : system_(system),
        stepped_(of_the_others(system, run, own...)),
        impulses_(system.cables.size()) {}

  [[nodiscard]] SpatialSystemState state() const override { return stepped_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override { return stepped_.stopped(); }

  void step(double dt) override {
    std::fill(impulses_.begin(), impulses_.end(), 0.0);
    if (stopped()) {
      return;
    }
    SpatialSystemState start = at_time_of_step(stepped_.state(), clock_);
    start.elastic = zones_;
    start = with_zones_of_step(system_, std::move(start));
    stepped_.pull(elastic_loads(system_, start));
    stepped_.step(dt);
    if (stopped()) {
      return;
    }
    clock_.advance(dt);
    zones_ = start.elastic;
    impulses_ = elastic_impulses(system_, start, dt);
    auto next = stepped_.impulses().begin();
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      if (!system_.cables[index].elasticity) {
        impulses_[index] = *next++;
      }
    }
  }

 private:
  /// A run without the elastic cables, whose refusals name the cables by their numbers in `system`.
  template <class... Own>
  [[nodiscard]] static Stepped of_the_others(const SpatialSystem& system, const RunSettings& run,
                                             const Own&... own) {
    SpatialSystem others = system;
    others.cables.clear();
    std::vector<std::size_t> numbers;  // of its cables in `system`
    for (std::size_t index = 0; index < system.cables.size(); ++index) {
      if (!system.cables[index].elasticity) {
        others.cables.push_back(system.cables[index]);
        numbers.push_back(index);
      }
    }
    try {
      return Stepped(others, run, own...);
    } catch (const CableRefused& refused) {
      throw refused.of(numbers[refused.index()]);
    }
  }

  const SpatialSystem system_;
  Stepped stepped_;
  Clock clock_;
  ElasticZones zones_;  // of the step before
  std::vector<double> impulses_;
};

/// The model `spring`, whose inextensible cables are those of the model `others`; in space it has
/// the settings of that and `more`. `own` goes to `Stepped`.
template <class Stepped, class... Own>
// NOLINTNEXTLINE(performance-unnecessary-value-param): as in event_model
[[nodiscard]] ModelEntry spring_model(const ModelEntry& others, const std::vector<Setting>& more,
                                      Own... own) {
  ModelEntry result = others;
  result.model.name = "spring";
  result.model.sentence =
      "Elastic cables pull by their law as it is at the start of each step, stable without damping "
      "while their frequency times the step is below 2; inextensible cables next to them are those "
      "of `" +
      others.model.name + "`.";
  result.model.maker = Maker::by_hand;
  result.model.in_space = joined({others.model.in_space.value_or(std::vector<Setting>()), more});
  result.model.cables = Cables::elastic;
  result.start = nullptr;
  result.start_system = makes<SpringSimulation<Stepped>>(own...);
  return result;
}

}  // namespace tautline
