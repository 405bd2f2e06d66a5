#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "tautline/engine.hpp"

namespace tautline {

/// A model and how to start a run with it: each adapter is a table of these.
struct ModelEntry {
  Model model;  // its name and what it is
  std::function<std::unique_ptr<Simulation>(const Case& the_case, const RunSettings& settings)>
      start;  // starts a run with it; none: it takes systems alone
  std::function<std::unique_ptr<SystemSimulation>(const SpatialSystem&, const RunSettings&)>
      start_system = nullptr;  // the same of a system in space; none: it takes the plane alone
  /// True where every impact gets `restitution(cable, rate)` at its own rate; a model that takes
  /// `cable.restitution` once and for all is not started on a case where it is not constant.
  bool follows_speed = false;
};

/// What the entries say of themselves, in their order.
[[nodiscard]] inline std::vector<Model> models(std::span<const ModelEntry> entries) {
  std::vector<Model> result;
  for (const ModelEntry& entry : entries) {
    result.push_back(entry.model);
    if (entry.start_system && !result.back().in_space) {
      result.back().in_space.emplace();
    }
  }
  return result;
}

/// Throws std::invalid_argument if `settings` set what is no parameter of `model`.
inline void check_parameters(const Model& model, const RunSettings& settings) {
  for (const auto& [name, value] : settings.parameters) {
    bool known = false;
    for (const Parameter& parameter : model.parameters) {
      known = known || parameter.name == name;
    }
    if (!known) {
      throw std::invalid_argument("unsupported: model " + model.name + " has no parameter " + name);
    }
  }
}

/// Throws std::invalid_argument if a cable of `the_case` is elastic: `whose` cables, such as "model
/// row", are all inextensible.
template <class TheCase>
void refuse_elastic(const std::string& whose, const TheCase& the_case) {
  if (const std::optional<std::size_t> elastic = first_elastic(the_case)) {
    throw std::invalid_argument("unsupported: " + whose + " has inextensible cables alone, cable " +
                                std::to_string(*elastic) + " of the case is elastic");
  }
}

/// True if `model` runs cases with cables as `the_case` has them.
template <class TheCase>
[[nodiscard]] bool has_cables_of(const Model& model, const TheCase& the_case) {
  return model.cables == Cables::any ||
         (model.cables == Cables::elastic) == first_elastic(the_case).has_value();
}

/// Throws std::invalid_argument if it does not.
template <class TheCase>
void check_cables_of(const Model& model, const TheCase& the_case) {
  if (!has_cables_of(model, the_case)) {
    refuse_elastic("model " + model.name, the_case);
    throw std::invalid_argument("unsupported: model " + model.name +
                                " needs an elastic cable, all cables of the case are inextensible");
  }
}

/// The parameter `name` of a run; `otherwise` where the run does not set it.
[[nodiscard]] inline double parameter_of(const RunSettings& settings, const std::string& name,
                                         double otherwise) {
  const auto found = settings.parameters.find(name);
  return found == settings.parameters.end() ? otherwise : found->second;
}

/// The entry called `name`, where it can do `the_case` with these settings. Throws
/// std::invalid_argument if there is none, or if it cannot.
template <class TheCase>
[[nodiscard]] const ModelEntry& entry_for(std::span<const ModelEntry> entries,
                                          std::string_view name, const TheCase& the_case,
                                          const RunSettings& settings) {
  std::string known;
  for (const ModelEntry& entry : entries) {
    if (entry.model.name == name) {
      for (std::size_t index = 0; index < the_case.cables.size() && !entry.follows_speed; ++index) {
        if (depends_on_speed(the_case.cables[index])) {
          throw std::invalid_argument("unsupported: model " + entry.model.name +
                                      " has one restitution for all speeds, cable " +
                                      std::to_string(index) + " of the case does not");
        }
      }
      check_cables_of(entry.model, the_case);
      check_parameters(entry.model, settings);
      return entry;
    }
    known += (known.empty() ? "" : ", ") + entry.model.name;
  }
  throw std::invalid_argument("model " + std::string(name) + " is unknown; there are " + known);
}

/// A run with the entry called `name`. Throws as `entry_for` does, and where the entry takes
/// systems alone.
[[nodiscard]] inline std::unique_ptr<Simulation> start_model(std::span<const ModelEntry> entries,
                                                             std::string_view name,
                                                             const Case& the_case,
                                                             const RunSettings& settings) {
  const ModelEntry& entry = entry_for(entries, name, the_case, settings);
  if (!entry.start) {
    throw std::invalid_argument("unsupported: model " + entry.model.name +
                                " runs systems, not a case of one body in the plane");
  }
  return entry.start(the_case, settings);
}

/// What `EngineInfo` calls the numbers of an engine that computes in `Real`.
template <class Real>
inline constexpr const char* precision_of = sizeof(Real) == sizeof(double) ? "float64" : "float32";

/// Settings one after another, as a model tells them.
[[nodiscard]] inline std::vector<Setting> joined(
    std::initializer_list<std::vector<Setting>> parts) {
  std::vector<Setting> result;
  for (const std::vector<Setting>& part : parts) {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

/// A `ModelEntry::start` or `start_system` that makes a `Made` of the case, of the settings of the
/// run where it wants them, and of `own`.
template <class Made, class... Own>
[[nodiscard]] auto makes(Own... own) {
  return [own...]<class TheCase>(
             const TheCase& the_case,
             [[maybe_unused]] const RunSettings& run) -> std::unique_ptr<BasicSimulation<TheCase>> {
    if constexpr (std::is_constructible_v<Made, const TheCase&, const RunSettings&,
                                          const Own&...>) {
      return std::make_unique<Made>(the_case, run, own...);
    } else {
      return std::make_unique<Made>(the_case, own...);
    }
  };
}

/// An engine as a table: what it says of itself, and its models, family after family.
struct EngineTable {
  std::string name;                               // of the engine, as it is asked for
  std::string version;                            // of the library that is loaded
  std::string precision;                          // float64 or float32
  std::vector<std::vector<ModelEntry>> families;  // models in the order in which they are listed
  int dimensions = 2;                             // of its world
};

/// The engine of a table: what a plug-in's class derives from.
class TableEngine : public Engine {
 public:
  /// An engine that is this table.
  explicit TableEngine(EngineTable table)
      : info_{std::move(table.name),
              std::move(table.version),
              std::move(table.precision),
              {},
              table.dimensions} {
    for (const std::vector<ModelEntry>& family : table.families) {
      entries_.insert(entries_.end(), family.begin(), family.end());
    }
    info_.models = models(entries_);
  }
  /// The same from its parts.
  TableEngine(std::string name, std::string version, std::string precision,
              std::initializer_list<std::vector<ModelEntry>> families)
      : TableEngine(EngineTable{std::move(name), std::move(version), std::move(precision),
                                std::vector(families)}) {}

  [[nodiscard]] EngineInfo info() const override { return info_; }  // what the table says
  [[nodiscard]] std::unique_ptr<Simulation> start(const Case& the_case, std::string_view model,
                                                  const RunSettings& settings) const override {
    return start_model(entries_, model, the_case, settings);
  }
  [[nodiscard]] std::unique_ptr<SystemSimulation> start_system(
      const SpatialSystem& system, std::string_view model,
      const RunSettings& settings) const override {
    const ModelEntry& entry = entry_for(entries_, model, system, settings);
    return entry.start_system ? entry.start_system(system, settings)
                              : Engine::start_system(system, model, settings);
  }

 private:
  EngineInfo info_;
  std::vector<ModelEntry> entries_;
};

/// The engine that `table()` describes: TAUTLINE_PLUGIN(tautline::EngineOf<my_table>).
template <auto table>
class EngineOf final : public TableEngine {
 public:
  EngineOf() : TableEngine(table()) {}
};

}  // namespace tautline
