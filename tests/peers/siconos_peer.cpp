// Siconos' event-driven scheme: LSODAR integrates from event to event and locates the zeros of the
// gaps by itself. The impacts are Siconos' own, by Newton's law as a linear complementarity
// problem.

#include "engines/siconos/system.hpp"  // before Siconos' own: see storage_in_cpp20.hpp

#include <exception>

#include <SiconosConfig.h>
#include <EventDriven.hpp>
#include <EventsManager.hpp>
#include <LCP.hpp>
#include <LsodarOSI.hpp>
#include <TimeDiscretisation.hpp>

#include "engines/simbody/quiet.hpp"
#include "peer.hpp"

namespace tautline::peers {
namespace {

/// Below this a gap, its rate and its acceleration are zero [m, s]. The default of 2.2e-12 is less
/// than what rounding overstretches.
constexpr double event_tolerance = 1e-9;

/// A longest step is an event of its own; a run with more of them than this does not end.
constexpr std::size_t most_events = 100'000;

class SiconosPeer final : public Peer {
 public:
  std::string name() const override { return "Siconos"; }
  std::string version() const override { return TAUTLINE_SICONOS_LIBRARY; }
  std::string method() const override {
    return "EventDriven with LsodarOSI and its own impacts; a run that it gives up counts up to "
           "there";
  }

  std::size_t most_arcs() const override { return arcs_of_slow_peers; }

  std::vector<Located> impacts(const Case& the_case, const Stop& stop,
                               const Effort& effort) override {
    siconos_engine::System system(the_case, the_case.initial);
    const double step = effort.longest_step > 0.0 ? effort.longest_step : stop.horizon;
    const simbody::Quiet quiet;  // of what it prints of a run that it gives up
    std::vector<Located> result;
    try {
      const auto run = simulation(system, step, effort.tolerance);
      for (std::size_t event = 0; event < most_events; ++event) {
        if (run->startingTime() >= stop.horizon || result.size() >= stop.most) {
          break;
        }
        run->advanceToEvent();
        system.set_restitutions();
        run->processEvents();
        if (const CableSet struck = struck_in(system, the_case.cables.size()); !struck.empty()) {
          result.push_back({run->startingTime(), struck});
        }
      }
    } catch (const std::exception&) {  // by Siconos: the run has the impacts up to there
    }
    return result;
  }

 private:
  static std::shared_ptr<EventDriven> simulation(const siconos_engine::System& system, double step,
                                                 double tolerance) {
    auto result = std::make_shared<EventDriven>(system.dynamics(),
                                                std::make_shared<TimeDiscretisation>(0.0, step));
    constexpr int one_for_all = 1;  // tolerances are numbers, not vectors
    const auto integrator = std::make_shared<LsodarOSI>();
    integrator->setTol(one_for_all, tolerance, tolerance);
    result->insertIntegrator(integrator);
    result->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_IMPACT);
    result->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_SMOOTH_ACC);
    result->setToleranceED(event_tolerance);
    result->initialize();
    return result;
  }

  static CableSet struck_in(const siconos_engine::System& system, std::size_t cables) {
    constexpr unsigned impulses = 1;
    CableSet result;
    for (std::size_t index = 0; index < cables; ++index) {
      if (system.multiplier(index, impulses) > 0.0) {
        result.insert(index);
      }
    }
    return result;
  }
};

}  // namespace

std::unique_ptr<Peer> siconos_peer() { return std::make_unique<SiconosPeer>(); }

}  // namespace tautline::peers
