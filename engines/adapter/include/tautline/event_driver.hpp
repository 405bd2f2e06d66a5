#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tautline/engine.hpp"
#include "tautline/event_adapter.hpp"
#include "tautline/impact.hpp"
#include "tautline/model_table.hpp"

namespace tautline {

/// A simulation in which `adapter`'s engine flies, solves impacts and holds taut cables
/// (`taut_step`), and every event is located by the exact search of `analytic/`. Impacts on several
/// cables follow `law`: simultaneous, one solve for all; or sequential, one solve after another.
/// Throws std::invalid_argument for the other laws. A simulation that cannot go on says so.
[[nodiscard]] std::unique_ptr<Simulation> drive_by_events(const Case& the_case,
                                                          std::unique_ptr<EventAdapter> adapter,
                                                          ImpactLaw law = ImpactLaw::simultaneous);

/// The model `event` of an engine, whose `Adapter` is an EventAdapter made of a case.
template <class Adapter>
// NOLINTNEXTLINE(performance-unnecessary-value-param): clang-tidy 14 sees no move in a template
[[nodiscard]] ModelEntry event_model(std::string sentence, std::vector<Setting> settings) {
  return {.model = {.name = "event",
                    .sentence = std::move(sentence),
                    .settings = std::move(settings),
                    .maker = Maker::tautline},
          .start =
              [](const Case& the_case, const RunSettings& run) {
                return drive_by_events(the_case, std::make_unique<Adapter>(the_case), run.law);
              },
          .follows_speed = true};
}

}  // namespace tautline
