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
  std::function<std::unique_ptr<Simulation>(const Case& the_case, double step)> start;
};

/// What the entries say of themselves, in their order.
[[nodiscard]] inline std::vector<Model> models(std::span<const ModelEntry> entries) {
  std::vector<Model> result;
  for (const ModelEntry& entry : entries) {
    result.push_back(entry.model);
  }
  return result;
}

/// A run with the entry called `name`. Throws std::invalid_argument if there is none.
[[nodiscard]] inline std::unique_ptr<Simulation> start_model(std::span<const ModelEntry> entries,
                                                             std::string_view name,
                                                             const Case& the_case, double step) {
  std::string known;
  for (const ModelEntry& entry : entries) {
    if (entry.model.name == name) {
      return entry.start(the_case, step);
    }
    known += (known.empty() ? "" : ", ") + entry.model.name;
  }
  throw std::invalid_argument("model " + std::string(name) + " is unknown; there are " + known);
}

}  // namespace tautline
