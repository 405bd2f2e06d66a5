// A cable is the one that this project ships for a user's own ODE world: its contacts are added
// before each dWorldStep (`cable`), or the step is split at its impacts (`cable-events`). Through
// the public headers alone.

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "adapter/drop_in_model.hpp"
#include "models.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impacts_between_parts.hpp"
#include "tautline/ode/dCable.h"
#include "tautline/ode/dStepWithCables.h"
#include "tautline/system_loads.hpp"
#include "world.hpp"

namespace tautline::ode {
namespace {

struct DestroyCable {
  void operator()(dCableID cable) const { dCableDestroy(cable); }
};

/// The cables of a case at the body of a world.
class Cables {
 public:
  Cables(const Case& the_case, const World& world) {
    for (const Cable& cable : the_case.cables) {
      const Vec2 attachment = attachment_point(the_case.initial, cable);
      add(world.body(), {attachment.x(), attachment.y(), 0.0}, nullptr,
          {cable.anchor.x(), cable.anchor.y(), 0.0}, cable.length, cable.restitution);
    }
  }

  /// Those that act.
  [[nodiscard]] const dCableID* data() const { return acting_.data(); }
  [[nodiscard]] int count() const { return static_cast<int>(acting_.size()); }

  /// In the latest step: its impulse [N s], and whether it pulled.
  [[nodiscard]] double impulse(std::size_t index) const {
    return acts(index) ? dCableGetImpulse(owned_[index].get()) : 0.0;
  }
  [[nodiscard]] bool is_taut(std::size_t index) const {
    return acts(index) && dCableIsTaut(owned_[index].get()) != 0;
  }

 protected:
  Cables() = default;

  void add(dBodyID body, const Eigen::Vector3d& at, dBodyID other, const Eigen::Vector3d& there,
           double length, double restitution) {
    const dCableID id = dCableCreate();
    owned_.emplace_back(id);
    acting_.push_back(id);
    dCableAttach(id, body, other);
    dCableSetAnchor1(id, at.x(), at.y(), at.z());
    dCableSetAnchor2(id, there.x(), there.y(), there.z());
    dCableSetLength(id, length);
    dCableSetBounce(id, restitution);
  }

  [[nodiscard]] bool acts(std::size_t index) const {
    return std::ranges::find(acting_, owned_[index].get()) != acting_.end();
  }

  std::vector<dCableID> acting_;
  std::vector<std::unique_ptr<std::remove_pointer_t<dCableID>, DestroyCable>> owned_;
};

/// Cables of a system: ends that move are kinematic bodies, and what changes the length a winch.
class SystemCables : public Cables {
 public:
  SystemCables(const SpatialSystem& system, SystemWorld& world) : system_(system) {
    check_straight(system, "tautline's drop-in cable");
    for (const SpatialCable& cable : system.cables) {
      const Eigen::Vector3d there = moving_point(second(cable), system.initial).position;
      hooks_.push_back(second(cable).motion.empty() ? nullptr : world.add_hook(there));
      const std::optional<std::size_t>& body = second(cable).body;
      add(world.body(*first(cable).body), moving_point(first(cable), system.initial).position,
          body ? world.body(*body) : hooks_.back(), there, cable.length.at(0.0)[0],
          cable.restitution);
      dCableSetElasticity(owned_.back().get(), drop_in_elasticity(system, cable));
    }
  }

  /// For a step from `time` to `end` [s].
  void set(double time, double end) {
    const double soon = time + same_instant * (end - time);
    acting_.clear();
    for (std::size_t index = 0; index < owned_.size(); ++index) {
      const SpatialCable& cable = system_.cables[index];
      if (cable.acts_at(soon)) {
        acting_.push_back(owned_[index].get());
      }
      if (!cable.length.is_constant()) {
        const double length = cable.length.at(time)[0];
        dCableSetLength(owned_[index].get(), length);
        dCableSetLengthRate(owned_[index].get(), (cable.length.at(end)[0] - length) / (end - time));
      }
      if (hooks_[index] != nullptr) {
        SystemWorld::move_hook(hooks_[index], second(cable).at + second(cable).motion.at(end),
                               end - time);
      }
    }
  }

  [[nodiscard]] const SpatialSystem& system() const { return system_; }

 private:
  static const SpatialEnd& first(const SpatialCable& cable) {
    return cable.from.body ? cable.from : cable.to;
  }
  static const SpatialEnd& second(const SpatialCable& cable) {
    return cable.from.body ? cable.to : cable.from;
  }

  const SpatialSystem system_;
  std::vector<dBodyID> hooks_;  // of each cable; most have none
};

/// TheCase is Case or SpatialSystem.
template <class TheCase, class TheWorld, class TheCables>
class CableSimulation final : public BasicSteppedSimulation<TheCase> {
 public:
  explicit CableSimulation(const TheCase& the_case)
      : world_(the_case, Rotation::infinitesimal),
        cables_(the_case, world_),
        impulses_(the_case.cables.size()) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    if constexpr (TheCase::has_several_bodies) {
      cables_.set(world_.time(), world_.time() + dt);
      world_.load(dt);
    }
    dCableAddContacts(world_.id(), world_.contacts(), cables_.data(), cables_.count(), dt);
    world_.step_loaded(dt);
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      impulses_[index] = cables_.impulse(index);
    }
  }

 private:
  TheWorld world_;
  TheCables cables_;  // destroyed before their bodies
  std::vector<double> impulses_;
};

/// The user's own step, which each part calls, frames the parts; what jumps between two of them is
/// an impact.
template <class TheCase, class TheWorld, class TheCables>
class CableEventsSimulation final : public BasicSimulation<TheCase> {
 public:
  explicit CableEventsSimulation(const TheCase& the_case)
      : world_(the_case, Rotation::finite),
        cables_(the_case, world_),
        impacts_(the_case, std::numeric_limits<dReal>::epsilon()) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impacts_.impulses(); }
  [[nodiscard]] std::span<const BasicEvent<TheCase>> events() const override {
    return impacts_.events();
  }

  void step(double dt) override {
    impacts_.begin_step(world_.state());
    if constexpr (TheCase::has_several_bodies) {
      each_smooth_part(cables_.system(), world_.time(), dt,
                       [this](double start, double end) { step_smoothly(start, end); });
    } else {
      step_with_cables(dt);
    }
    impacts_.end_step(dt, world_.state());
  }

 private:
  void step_smoothly(double start, double end) {
    cables_.set(start, end);
    impacts_.sees(evenly_in_step(cables_.system(), start, end - start));
    world_.load(end - start);
    step_with_cables(end - start);
    world_.set_time(end);
  }

  void step_with_cables(double dt) {
    dStepWithCables(world_.id(), world_.contacts(), cables_.data(), cables_.count(), dt, step_part,
                    this);
  }

  static void step_part(void* data, dReal dt) {
    auto& self = *static_cast<CableEventsSimulation*>(data);
    self.impacts_.begin_part(self.world_.state());
    self.world_.step_loaded(dt);
    CableSet pulled;
    for (std::size_t index = 0; index < self.impulses().size(); ++index) {
      if (self.cables_.is_taut(index)) {
        pulled.insert(index);
      }
    }
    self.impacts_.end_part(dt, self.world_.state(), pulled);
  }

  TheWorld world_;
  TheCables cables_;  // destroyed before their bodies
  ImpactsBetweenParts<TheCase> impacts_;
};

std::vector<Setting> settings(const std::vector<Setting>& own) {
  return joined({world_settings(),
                 {{"dCableSetBounce", "the cable's restitution",
                   "A cable does not rebound unless it is set."}},
                 own});
}

std::vector<Setting> in_space() {
  return joined({system_settings(),
                 {{"dBodySetKinematic, dCableSetLengthRate",
                   "from where an end or a length is as a step starts to where it is at its end",
                   "dCable knows no function of time; it moves both evenly."},
                  {"the cables of a step", "those that are hooked up and not cut",
                   "The others pull at nothing."}}});
}

}  // namespace

std::vector<ModelEntry> cable_models() {
  return {
      {.model = {.name = "cable",
                 .sentence = "tautline's dCable, the drop-in cable for a world of one's own, "
                             "in dWorldStep with ODE's own settings.",
                 .settings = settings({}),
                 .in_space = joined({in_space(), elastic_drop_in_settings("dCableSetElasticity")}),
                 .cables = tautline::Cables::any},
       .start = makes<CableSimulation<Case, World, Cables>>(),
       .start_system = makes<CableSimulation<SpatialSystem, SystemWorld, SystemCables>>()},
      {.model = {.name = "cable-events",
                 .sentence = "The same dCable with dStepWithCables, which splits a step at its "
                             "impacts.",
                 .settings = settings(
                     {{"dStepWithCables",
                       "instead of dCableAddContacts, with its own 8 parts a step",
                       "Impacts are solved at zero gap and in no time."},
                      {"dBodySetFiniteRotationMode", "1",
                       "The default turns the body to first order only, and no event mends "
                       "that."}}),
                 .in_space = in_space()},
       .start = makes<CableEventsSimulation<Case, World, Cables>>(),
       .start_system = makes<CableEventsSimulation<SpatialSystem, SystemWorld, SystemCables>>()}};
}

}  // namespace tautline::ode
