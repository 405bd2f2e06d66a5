#pragma once

#include <memory>
#include <vector>

#include "tautline/engine.hpp"

namespace tautline {

/// What the event driver needs of an engine: one body, no cables of the engine's own.
class EventAdapter {
 public:
  EventAdapter() = default;
  EventAdapter(const EventAdapter&) = delete;
  EventAdapter& operator=(const EventAdapter&) = delete;
  virtual ~EventAdapter() = default;

  [[nodiscard]] virtual State state() const = 0;

  /// The engine's own step of `dt` [s] with no cable, kicked by half of gravity's impulse before
  /// and after where the engine's scheme needs it, so that it flies the exact parabola.
  virtual void fly(double dt) = 0;

  /// One solve by the engine's own solver, at the pose it has and without moving: each of `cables`
  /// leaves at least at restitution times its closing rate, and is never pushed.
  /// Returns the impulses [N s], one per cable of `cables`, in rising index order.
  [[nodiscard]] virtual CableVector strike(CableSet cables) = 0;
};

/// A simulation in which `adapter`'s engine flies and strikes, and every event is located by
/// `first_contact`. Stops, and says so, where impacts accumulate.
[[nodiscard]] std::unique_ptr<Simulation> drive_by_events(const Case& the_case,
                                                          std::unique_ptr<EventAdapter> adapter);

}  // namespace tautline
