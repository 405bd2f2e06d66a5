// A cable is the one that this project ships for a user's own ODE world: its contacts are added
// before each dWorldStep (`cable`), or the step is split at its impacts (`cable-events`). Through
// the public headers alone.

#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "models.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impacts_between_parts.hpp"
#include "tautline/ode/dCable.h"
#include "tautline/ode/dStepWithCables.h"
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
      const dCableID id = dCableCreate();
      dCableAttach(id, world.body(), nullptr);
      dCableSetAnchor1(id, attachment.x(), attachment.y(), 0);
      dCableSetAnchor2(id, cable.anchor.x(), cable.anchor.y(), 0);
      dCableSetLength(id, cable.length);
      dCableSetBounce(id, cable.restitution);
      ids_.push_back(id);
      owned_.emplace_back(id);
    }
  }

  [[nodiscard]] const dCableID* data() const { return ids_.data(); }
  [[nodiscard]] int count() const { return static_cast<int>(ids_.size()); }
  [[nodiscard]] dCableID operator[](std::size_t index) const { return ids_[index]; }

 private:
  std::vector<dCableID> ids_;
  std::vector<std::unique_ptr<std::remove_pointer_t<dCableID>, DestroyCable>> owned_;
};

class CableSimulation final : public SteppedSimulation {
 public:
  explicit CableSimulation(const Case& the_case)
      : world_(the_case, Rotation::infinitesimal),
        cables_(the_case, world_),
        impulses_(the_case.cables.size()) {}

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    dCableAddContacts(world_.id(), world_.contacts(), cables_.data(), cables_.count(), dt);
    world_.advance(dt);
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      impulses_[index] = dCableGetImpulse(cables_[index]);
    }
  }

 private:
  World world_;
  Cables cables_;  // destroyed before their body
  std::vector<double> impulses_;
};

/// The user's own step, which each part calls, frames the parts; what jumps between two of them is
/// an impact.
class CableEventsSimulation final : public Simulation {
 public:
  explicit CableEventsSimulation(const Case& the_case)
      : world_(the_case, Rotation::finite),
        cables_(the_case, world_),
        impacts_(the_case, std::numeric_limits<dReal>::epsilon()) {}

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impacts_.impulses(); }
  [[nodiscard]] std::span<const Event> events() const override { return impacts_.events(); }

  void step(double dt) override {
    impacts_.begin_step(world_.state());
    dStepWithCables(world_.id(), world_.contacts(), cables_.data(), cables_.count(), dt, step_part,
                    this);
    impacts_.end_step(dt, world_.state());
  }

 private:
  static void step_part(void* data, dReal dt) {
    auto& self = *static_cast<CableEventsSimulation*>(data);
    self.impacts_.begin_part(self.world_.state());
    self.world_.advance(dt);
    CableSet pulled;
    for (std::size_t index = 0; index < self.impulses().size(); ++index) {
      if (dCableIsTaut(self.cables_[index]) != 0) {
        pulled.insert(index);
      }
    }
    self.impacts_.end_part(dt, self.world_.state(), pulled);
  }

  World world_;
  Cables cables_;  // destroyed before their body
  ImpactsBetweenParts impacts_;
};

std::vector<Setting> settings(const std::vector<Setting>& own) {
  return joined({world_settings(),
                 {{"dCableSetBounce", "the cable's restitution",
                   "A cable does not rebound unless it is set."}},
                 own});
}

}  // namespace

std::vector<ModelEntry> cable_models() {
  return {{.model = {.name = "cable",
                     .sentence = "tautline's dCable, the drop-in cable for a world of one's own, "
                                 "in dWorldStep with ODE's own settings.",
                     .settings = settings({})},
           .start = makes<CableSimulation>()},
          {.model = {.name = "cable-events",
                     .sentence = "The same dCable with dStepWithCables, which splits a step at its "
                                 "impacts.",
                     .settings = settings(
                         {{"dStepWithCables",
                           "instead of dCableAddContacts, with its own 8 parts a step",
                           "Impacts are solved at zero gap and in no time."},
                          {"dBodySetFiniteRotationMode", "1",
                           "The default turns the body to first order only, and no event mends "
                           "that."}})},
           .start = makes<CableEventsSimulation>()}};
}

}  // namespace tautline::ode
