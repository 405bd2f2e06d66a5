#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// Whose choice the value of a setting is: whom to blame for what follows from it.
enum class Origin {
  engine_default,  // what the engine does if its user says nothing
  engine_demo,     // the engine ships no default; its demos, samples or manual have this value
  ours,            // the plug-in's
};
/// Its name, as it stands in report.json.
[[nodiscard]] constexpr const char* to_string(Origin origin) {
  switch (origin) {
    case Origin::engine_default:
      return "engine_default";
    case Origin::engine_demo:
      return "engine_demo";
    case Origin::ours:
      return "ours";
  }
  return "";
}

/// A setting of an engine that its default does not settle, and why.
struct Setting {
  std::string name;              // the engine's own name for it
  std::string value;             // as it is set
  std::string reason;            // one sentence
  Origin origin = Origin::ours;  // whose choice the value is
};

/// Whose the cable of a model is: whom its errors belong to.
enum class Maker {
  engine,    // as shipped: a joint, a limit, a contact or a solver that users of the engine have
  by_hand,   // built by the plug-in with the engine's parts
  tautline,  // tautline's: its event driver, or its exact solver
};
/// Its name, as it stands in report.json.
[[nodiscard]] constexpr const char* to_string(Maker maker) {
  switch (maker) {
    case Maker::engine:
      return "engine";
    case Maker::by_hand:
      return "by_hand";
    case Maker::tautline:
      return "tautline";
  }
  return "";
}

/// The cables of the cases that a model runs.
enum class Cables {
  inextensible,  // all of them
  elastic,       // of a system, one or more of them (`SpatialCable::elasticity`), next to
                 // inextensible ones; a system without an elastic cable is refused
  any,           // all inextensible, all elastic, or of both kinds
};
/// Its word in JSON.
[[nodiscard]] constexpr const char* to_string(Cables cables) {
  switch (cables) {
    case Cables::inextensible:
      return "inextensible";
    case Cables::elastic:
      return "elastic";
    case Cables::any:
      return "any";
  }
  return "";
}

/// A number of a model that a run may set, such as a stiffness.
struct Parameter {
  std::string name;  // [a-z0-9-]+
  // its value lies between two numbers times a power of the step [s]
  double low;                // the smaller of these numbers
  double high;               // the larger one
  bool logarithmic = false;  // factors of it count, not differences; then low > 0
  int step_power = 0;        // the power: -2 for a stiffness
};

/// One way to build the cables of a case in an engine.
struct Model {
  std::string name;                        // [a-z0-9-]+, such as "row" or "event"
  std::string sentence;                    // what it does, in one sentence
  std::vector<Setting> settings;           // every one that is not left alone
  Maker maker = Maker::by_hand;            // whose its cable is
  std::vector<Parameter> parameters = {};  // that a run may set; none in most models
  std::string code = {};  // sets them in a user's program, "{name}" where a value stands
  /// Set where it runs systems in space, too (`Engine::start_system`): what is set for them, in
  /// place of `settings` of the same name.
  std::optional<std::vector<Setting>> in_space = {};
  Cables cables = Cables::inextensible;  // of the cases that it runs
};

/// What an engine says of itself.
struct EngineInfo {
  std::string name;       // [a-z0-9-]+, such as "bullet64"
  std::string version;    // asked from the library, not from a header, where the library can tell
  std::string precision;  // "float64" or "float32"
  std::vector<Model> models;  // each runs any case with its kind of cables, or says why not
  int dimensions = 2;         // of its world: 2, or 3
};

/// Why a simulation cannot go on.
struct StopOfRun {
  double time;         // [s], from the start of the run
  std::string reason;  // in a few words
};

/// One run of one case, a `Case` or a `SpatialSystem`. Times count from the start of the run [s].
template <class TheCase>
class BasicSimulation {
 public:
  using Stop = StopOfRun;  // why it cannot go on

  BasicSimulation() = default;
  BasicSimulation(const BasicSimulation&) = delete;
  BasicSimulation& operator=(const BasicSimulation&) = delete;
  virtual ~BasicSimulation() = default;

  /// The body now, or all bodies of a system. Right after `start` it is the case's initial state.
  /// In the plane the angle is not wrapped.
  [[nodiscard]] virtual StateOf<TheCase> state() const = 0;

  /// Advances by `dt` [s], > 0.
  virtual void step(double dt) = 0;

  /// The impulse of each cable over the latest step [N s], >= 0, one per cable of the case. A
  /// simulation that locates its impacts gives the impulses of these, and not those of tensions.
  [[nodiscard]] virtual std::span<const double> impulses() const = 0;

  /// The impacts inside the latest step, for a simulation that locates them itself. One that does
  /// not leaves this empty, and the impacts are read from `impulses`.
  [[nodiscard]] virtual std::span<const BasicEvent<TheCase>> events() const { return {}; }

  /// Set when the simulation cannot go on ("impacts accumulate"); the latest step may then have
  /// advanced by less than its dt, and `time` tells how far. None while it runs.
  [[nodiscard]] virtual std::optional<StopOfRun> stopped() const { return std::nullopt; }
};
using Simulation = BasicSimulation<Case>;                 // of a body in the plane
using SystemSimulation = BasicSimulation<SpatialSystem>;  // of a system in space

/// What a simulation derives from, too, if it knows what its cables pull with while they are taut.
/// The program asks for it by dynamic_cast: a plug-in that does not have it, or is older, loads as
/// before.
class TensionImpulses {
 public:
  TensionImpulses() = default;
  TensionImpulses(const TensionImpulses&) = delete;
  TensionImpulses& operator=(const TensionImpulses&) = delete;
  virtual ~TensionImpulses() = default;

  /// The impulse of each cable over the latest step [N s], >= 0, one per cable of the case, without
  /// those of the impacts in `Simulation::events`: over the length of the step, the mean tension
  /// [N]. Not a number if the engine does not know it: it has put the body to sleep.
  [[nodiscard]] virtual std::span<const double> tension_impulses() const = 0;
};

/// A cable that is a spring and a damper of its engine, weighed with what it pulls at. While it is
/// longer than it should be, by s > 0 [m], it pulls with
///
///     T = max(0, (load a + damping s' + stiffness s) / G)
///
/// with its response G to an impulse of its own, 1/m of a point mass (B6), and the s'' that the
/// forces and all other cables give without it, a.
struct SoftRow {
  double stiffness;   // [1/s^2]: k of a spring over m
  double damping;     // [1/s]: c of a damper over m
  double load = 0.0;  // [-], the part of a that it takes over: 0 of a spring, 1 of a rigid row
};

/// A simulation derives from this, too, if its cables are such; as `TensionImpulses` it is asked
/// for by dynamic_cast. Reports then tell the errors of the model and of the steps apart.
class SoftCables {
 public:
  SoftCables() = default;
  SoftCables(const SoftCables&) = delete;
  SoftCables& operator=(const SoftCables&) = delete;
  virtual ~SoftCables() = default;

  /// One for each cable of the case; empty: they are not soft in this run.
  [[nodiscard]] virtual std::span<const SoftRow> soft_rows() const = 0;
};

/// A simulation with fixed steps, whose `impulses` are of all that its cables pull in a step.
template <class TheCase>
class BasicSteppedSimulation : public BasicSimulation<TheCase>, public TensionImpulses {
 public:
  [[nodiscard]] std::span<const double> tension_impulses() const final { return this->impulses(); }
};
using SteppedSimulation = BasicSteppedSimulation<Case>;                 // in the plane
using SteppedSystemSimulation = BasicSteppedSimulation<SpatialSystem>;  // in space

/// How a run is done.
struct RunSettings {
  /// Implicit: most runs have no wish but a step.
  RunSettings(double step_of_run, ImpactLaw law_of_run = ImpactLaw::simultaneous)
      : step(step_of_run), law(law_of_run) {}

  double step;  // [s], the length of every step but the last, which may be shorter
  /// For impacts on several cables, where a model leaves the choice. The others ignore it.
  ImpactLaw law;
  /// Some of the model's `parameters`, by name; the model chooses the others.
  std::map<std::string, double> parameters = {};
};

/// An engine, made by a plug-in.
class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  [[nodiscard]] virtual EngineInfo info() const = 0;  // who it is and what it has

  /// A run of `the_case`, which has no `problems`, with one of the models of `info`. Throws
  /// std::exception if it cannot.
  [[nodiscard]] virtual std::unique_ptr<Simulation> start(const Case& the_case,
                                                          std::string_view model,
                                                          const RunSettings& settings) const = 0;

  /// Starts a system in space: several bodies, cables between them and through rings, and what
  /// is given over time. Only a model with `in_space` has it.
  [[nodiscard]] virtual std::unique_ptr<SystemSimulation> start_system(
      const SpatialSystem& /*system*/, std::string_view model,
      const RunSettings& /*settings*/) const {
    const EngineInfo own = info();
    throw std::invalid_argument(own.dimensions == 2
                                    ? "unsupported: " + own.name + " is an engine of the plane"
                                    : "unsupported: model " + std::string(model) +
                                          " has one body in the plane alone");
  }
};

}  // namespace tautline
