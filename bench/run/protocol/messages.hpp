#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/event_adapter.hpp"
#include "tautline/impact.hpp"

namespace tautline::bench {

// The messages of engines/protocol/README.md, as text on one side and as types on the other.

/// What a child did against the protocol, in one sentence that says what would be right.
class ProtocolError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The engine's own process ended, or closed its output: what it printed may say why.
class EngineEnded : public ProtocolError {
 public:
  using ProtocolError::ProtocolError;
};

/// What an engine says of itself when it cannot do what it is asked.
class EngineRefusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A model of an engine in another process.
struct ChildModel {
  Model model;
  bool by_events = false;      // the program's event driver finds its events
  bool follows_speed = false;  // its restitution may depend on the speed
  bool tells_tension = false;  // the impulses of its steps are the engine's own, tensions included
};

/// The answer to `info`.
struct ChildInfo {
  std::string name;
  std::string version;
  std::string precision;
  std::vector<ChildModel> models;
  int dimensions = 2;  // of its world
};

/// The form of a state: how many numbers it has.
struct StateForm {
  std::size_t bodies = 0;  // of a system in space; 0: the body of a case in the plane

  [[nodiscard]] std::size_t width() const;  // how many numbers
};

/// The answer to `start`.
struct ChildStart {
  std::vector<double> state;
  std::optional<EventAdapter::Rounding> rounding;  // none where it is that of its precision
  std::vector<SoftRow> soft;  // of each cable; empty where they are no springs and dampers
};

/// The answer to `step`.
struct ChildSteps {
  std::size_t width = 0;       // of a row: a state, and one impulse for each cable
  std::vector<double> values;  // row after row
  std::optional<Simulation::Stop> stopped;

  [[nodiscard]] std::size_t count() const { return width == 0 ? 0 : values.size() / width; }
};

/// The answer to `solve`.
struct ChildSolve {
  CableVector impulses;
  std::vector<double> state;
};

/// Numbers in a state of the plane.
inline constexpr std::size_t state_width = 6;

/// Numbers in the state of each body of a system.
inline constexpr std::size_t body_width = 13;

/// The state at the beginning of a row.
[[nodiscard]] State state_from(const double* row);
/// Likewise in space, at a time [s].
[[nodiscard]] SpatialSystemState state_from(const double* row, std::size_t bodies, double time);

/// The numbers of a state.
[[nodiscard]] std::vector<double> numbers_of(const State& state);
/// In space.
[[nodiscard]] std::vector<double> numbers_of(const SpatialSystemState& state);

// Requests, without the end of their line.
[[nodiscard]] std::string info_request(int id);
[[nodiscard]] std::string start_request(int id, const Case& the_case, const ChildModel& model,
                                        const RunSettings& settings);
[[nodiscard]] std::string start_request(int id, const SpatialSystem& system,
                                        const ChildModel& model, const RunSettings& settings);
[[nodiscard]] std::string step_request(int id, double dt, std::size_t count);
[[nodiscard]] std::string fly_request(int id, double dt);
[[nodiscard]] std::string place_request(int id, const State& state);
[[nodiscard]] std::string place_request(int id, const SpatialSystemState& state);
[[nodiscard]] std::string solve_request(int id, CableSet cables, const CableVector& rates);

// Answers to them. Each throws ProtocolError for a line that is no such answer, and EngineRefusal
// with the engine's own sentence. States have the form that the run has.
[[nodiscard]] ChildInfo info_answer(std::string_view line, int id);
[[nodiscard]] ChildStart start_answer(std::string_view line, int id, StateForm form = {});
[[nodiscard]] ChildSteps step_answer(std::string_view line, int id, std::size_t cables,
                                     std::size_t count, StateForm form = {});
[[nodiscard]] std::vector<double> state_answer(std::string_view line, int id,
                                               std::string_view method, StateForm form = {});
[[nodiscard]] ChildSolve solve_answer(std::string_view line, int id, std::size_t cables,
                                      StateForm form = {});

}  // namespace tautline::bench
