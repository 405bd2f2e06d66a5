// Siconos' location of events: LSODAR integrates from event to event, its root finder stops it
// where a gap or a tension falls to zero, and linear complementarity problems give the impulses of
// an impact and the tensions of taut cables.

#include "system.hpp"  // before Siconos' own: see storage_in_cpp20.hpp

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include <Event.hpp>
#include <EventDriven.hpp>
#include <EventsManager.hpp>
#include <Interaction.hpp>
#include <LsodarOSI.hpp>
#include <OneStepNSProblem.hpp>
#include <Relation.hpp>
#include <SimulationGraphs.hpp>
#include <TimeDiscretisation.hpp>

#include "checked_lcp.hpp"
#include "models.hpp"
#include "tautline/clock.hpp"

namespace tautline::siconos_engine {
namespace {

/// Below this a gap [m], its rate [m/s], its acceleration [m/s^2] and a tension [N] are zero.
constexpr double event_tolerance = 1e-9;

/// Slower impacts do not rebound [m/s]. Where impacts on coupled cables accumulate, rebounds of
/// about the tolerance would keep each other above it for ever; ten times as fast ones still decay.
constexpr double capture_speed = 10.0 * event_tolerance;

/// A step with more events than this does not end. Shipped cases have less than 1000 in a whole
/// run.
constexpr int most_events = 10'000;

/// ODEPACK's routine for several integrations in turns: it saves (job 1) and restores (job 2) what
/// LSODAR keeps between calls.
extern "C" void dsrcar_(double* numbers, int* integers, const int* job);

/// LSODAR whose problems of tensions have the geometry of now. `LagrangianScleronomousR` calls its
/// own `computeDotJachq` there and not the relation's, so that H' would be that of before an
/// impact. And LSODAR whose memory is its own: another simulation of the process may step in
/// between.
class Lsodar final : public LsodarOSI {
 public:
  void integrate(double& start, double& wanted, double& reached, int& status) override {
    constexpr int save = 1;
    constexpr int restore = 2;
    if (used_) {
      dsrcar_(numbers_.data(), integers_.data(), &restore);
    }
    LsodarOSI::integrate(start, wanted, reached, status);
    dsrcar_(numbers_.data(), integers_.data(), &save);
    used_ = true;
  }

  void computeFreeOutput(InteractionsGraph::VDescriptor& vertex,
                         OneStepNSProblem* problem) override {
    Interaction& cable = *problem->simulation()->indexSet(problem->indexSetLevel())->bundle(vertex);
    cable.relation()->computeJach(problem->simulation()->nextTime(), cable);
    LsodarOSI::computeFreeOutput(vertex, problem);
  }

 private:
  std::array<double, 245> numbers_{};  // both as long as ODEPACK says
  std::array<int, 55> integers_{};
  bool used_ = false;
};

std::shared_ptr<EventDriven> event_driven(const System& system, double dt) {
  auto result = std::make_shared<EventDriven>(system.dynamics(),
                                              std::make_shared<TimeDiscretisation>(0.0, dt));
  result->insertIntegrator(std::make_shared<Lsodar>());
  result->insertNonSmoothProblem(std::make_shared<CheckedLcp>(), SICONOS_OSNSP_ED_IMPACT);
  result->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_SMOOTH_ACC);
  result->setToleranceED(event_tolerance);
  result->initialize();
  return result;
}

class EventDrivenSimulation final : public Simulation {
 public:
  EventDrivenSimulation(const Case& the_case, const RunSettings& run)
      : case_(the_case), now_(the_case.initial), impulses_(the_case.cables.size()) {
    begin(run.step);
  }

  [[nodiscard]] State state() const override { return now_; }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::span<const Event> events() const override { return events_; }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override { return stop_; }

  void step(double dt) override {
    std::fill(impulses_.begin(), impulses_.end(), 0.0);
    events_.clear();
    if (stop_) {
      return;
    }
    try {
      if (dt != dt_) {
        begin(dt);
      }
      const double end = static_cast<double>(++steps_) * dt_;  // as the TimeDiscretisation has it
      int count = 0;
      while (end - events_ahead_->startingTime() > simultaneous()) {
        if (++count > most_events) {
          stop_ = StopOfRun{time(), "the events of a step do not end"};
          return;
        }
        to_next_event();
      }
    } catch (const std::exception& error) {
      stop_ = StopOfRun{time(), reason(error)};
    }
  }

 private:
  void begin(double dt) {
    start_ = time();
    dt_ = dt;
    steps_ = 0;
    events_ahead_.reset();
    system_.emplace(case_, now_);
    events_ahead_ = event_driven(*system_, dt);
  }

  /// [s], events no further apart are one to Siconos.
  [[nodiscard]] double simultaneous() const {
    const EventsManager& manager = *events_ahead_->eventsManager();
    return static_cast<double>(manager.getGapLimitEvents()) * manager.currentEvent()->getTick();
  }

  /// [s], of the run.
  [[nodiscard]] double time() const {
    return events_ahead_ ? start_ + events_ahead_->startingTime() : 0.0;
  }

  void to_next_event() {
    events_ahead_->advanceToEvent();
    const State before = system_->state();
    system_->set_restitutions(capture_speed);
    events_ahead_->processEvents();
    now_ = system_->state();
    report_impact(before);
  }

  void report_impact(const State& before) {
    CableSet cables;
    for (std::size_t index = 0; index < impulses_.size(); ++index) {
      if (system_->multiplier(index, 1) > 0.0) {
        cables.insert(index);
      }
    }
    if (cables.empty()) {
      return;
    }
    CableVector impulses(static_cast<Eigen::Index>(cables.size()));
    Eigen::Index row = 0;
    for (const std::size_t index : cables) {
      impulses[row] = system_->multiplier(index, 1);
      impulses_[index] += impulses[row++];
    }
    events_.push_back({time(), EventKind::impact, cables, impulses, before, now_});
  }

  const Case case_;
  State now_;           // after the latest event
  double start_ = 0.0;  // [s], when steps of dt_ began
  double dt_ = 0.0;     // [s]
  long steps_ = 0;      // of dt_
  std::optional<System> system_;
  std::shared_ptr<EventDriven> events_ahead_;
  std::vector<double> impulses_;
  std::vector<tautline::Event> events_;
  std::optional<StopOfRun> stop_;
};

}  // namespace

std::vector<ModelEntry> event_driven_models() {
  return {
      {.model =
           {.name = "event-driven",
            .sentence = "EventDriven with LsodarOSI: Siconos itself locates impacts and follows "
                        "taut cables.",
            .settings =
                {{"setToleranceED", "1e-9",
                  "The default of 2.2e-12 is less than an overstretch of rounding in a long run."},
                 {"NewtonImpactNSL e", "0 below 1e-8 m/s",
                  "Rebounds of about the tolerance on coupled cables would keep each other alive."},
                 {"LCP::compute", "overridden for impacts, ends the run where the solver fails",
                  "Siconos goes on with what the solver has left."},
                 {"LsodarOSI::computeFreeOutput",
                  "overridden, with the relation's Jacobians of now",
                  "Siconos calls past the relation's own rate of the Jacobian and takes an old "
                  "one."}},
            .maker = Maker::engine},
       .start = makes<EventDrivenSimulation>(),
       .follows_speed = true}};
}

}  // namespace tautline::siconos_engine
