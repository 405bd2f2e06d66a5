#pragma once

#include <memory>
#include <string>
#include <type_traits>
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
/// Throws std::invalid_argument for the other laws, and if a cable is elastic. A simulation that
/// cannot go on says so.
///
/// In the plane the engine flies the exact parabola. A system's flight is the engine's own, which
/// is exact for bodies of three equal moments without forces over time: the driver moves each
/// contact to the instant at which the engine's own gap is zero.
template <class TheCase>  // Case or SpatialSystem
[[nodiscard]] std::unique_ptr<BasicSimulation<TheCase>> drive_by_events(
    const TheCase& the_case,
    std::type_identity_t<std::unique_ptr<BasicEventAdapter<TheCase>>> adapter,
    ImpactLaw law = ImpactLaw::simultaneous);

/// The model `event` of an engine, whose `Adapter` is an EventAdapter made of a case, and whose
/// `InSpace` is a SystemEventAdapter made of a system, if it has one, with its settings.
template <class Adapter, class InSpace = void>
// NOLINTNEXTLINE(performance-unnecessary-value-param): clang-tidy 14 sees no move in a template
[[nodiscard]] ModelEntry event_model(std::string sentence, std::vector<Setting> settings,
                                     std::vector<Setting> in_space = {}) {
  ModelEntry result = {.model = {.name = "event",
                                 .sentence = std::move(sentence),
                                 .settings = std::move(settings),
                                 .maker = Maker::tautline},
                       .start =
                           [](const Case& the_case, const RunSettings& run) {
                             return drive_by_events(the_case, std::make_unique<Adapter>(the_case),
                                                    run.law);
                           },
                       .follows_speed = true};
  if constexpr (!std::is_void_v<InSpace>) {
    result.model.in_space = std::move(in_space);
    result.start_system = [](const SpatialSystem& system, const RunSettings& run) {
      return drive_by_events(system, std::make_unique<InSpace>(system), run.law);
    };
  }
  return result;
}

}  // namespace tautline
