#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/engine.hpp"

namespace tautline {

/// A model and how to start a run with it: each adapter is a table of these.
struct ModelEntry {
  Model model;
  std::function<std::unique_ptr<Simulation>(const Case& the_case, const RunSettings& settings)>
      start;
  /// True where every impact gets `restitution(cable, rate)` at its own rate; a model that takes
  /// `cable.restitution` once and for all is not started on a case where it is not constant.
  bool follows_speed = false;
};

/// What the entries say of themselves, in their order.
[[nodiscard]] inline std::vector<Model> models(std::span<const ModelEntry> entries) {
  std::vector<Model> result;
  for (const ModelEntry& entry : entries) {
    result.push_back(entry.model);
  }
  return result;
}

/// A run with the entry called `name`. Throws std::invalid_argument if there is none, or if it
/// cannot do the case.
[[nodiscard]] inline std::unique_ptr<Simulation> start_model(std::span<const ModelEntry> entries,
                                                             std::string_view name,
                                                             const Case& the_case,
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
      return entry.start(the_case, settings);
    }
    known += (known.empty() ? "" : ", ") + entry.model.name;
  }
  throw std::invalid_argument("model " + std::string(name) + " is unknown; there are " + known);
}

}  // namespace tautline
