// An engine in a process of its own, and its runs.

#include "bench/run/protocol/child_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/run/protocol/children.hpp"
#include "bench/run/protocol/messages.hpp"
#include "bench/run/record.hpp"
#include "tautline/clock.hpp"
#include "tautline/event_driver.hpp"

namespace tautline::bench {
namespace {

/// Throws ProtocolError if the angle jumps by about a turn or more in a move of `dt` [s] for which
/// the spins before and after give no reason: engines keep angles that know no turns.
void refuse_wrapped(const State& before, const State& after, double dt) {
  const double turned = std::abs(after.angle - before.angle);
  // a step may turn faster inside than at both ends, but not by this much more
  constexpr double generous = 4.0;  // [-]
  const double likely = generous * dt * std::max(std::abs(before.spin), std::abs(after.spin));
  if (turned > std::numbers::pi && turned > likely) {
    throw ProtocolError(fmt::format(
        "the engine's angle went from {:.6g} to {:.6g} in {:g} s at a spin of {:.3g}: it must not "
        "be wrapped",
        before.angle, after.angle, dt, after.spin));
  }
}

/// Steps asked for at once: the engine's own time is then most of it, and a run that is given up
/// early has not cost many for nothing.
constexpr std::size_t most_at_once = 100;

/// An orientation has no turns to be lost.
void refuse_wrapped(const SpatialSystemState&, const SpatialSystemState&, double) {}

/// The state of these numbers at a time [s], which states of the plane do not keep.
State state_of(const Case&, const double* row, double /*time*/) { return state_from(row); }
SpatialSystemState state_of(const SpatialSystem& system, const double* row, double time) {
  return state_from(row, system.bodies.size(), time);
}

template <class TheCase>
class BySteps : public BasicSimulation<TheCase>, public SoftCables {
 public:
  BySteps(Children& children, const TheCase& the_case, const ChildModel& model,
          const RunSettings& settings)
      : child_(children),
        case_(the_case),
        model_(model),
        settings_(settings),
        usual_left_(step_count(the_case.duration, settings.step) - 1),
        start_(child_->start(the_case, model, settings)),
        row_(start_.state),
        state_(state_of(the_case, row_.data(), 0.0)),
        impulses_(the_case.cables.size()) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return state_; }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override { return stop_; }
  [[nodiscard]] std::span<const SoftRow> soft_rows() const override { return start_.soft; }

  void step(double dt) override {
    if (stop_) {
      return;
    }
    const bool is_usual = dt == settings_.step;  // exactly: the very number that was given
    if (!is_usual) {
      go_no_further_ahead();
    }
    if (next_ == ahead_.count()) {
      ask(dt, is_usual);
    }
    ++taken_;
    clock_.advance(dt);
    if (next_ < ahead_.count()) {
      take(ahead_.values.data() + next_ * ahead_.width, dt);
      ++next_;
    } else {  // it stopped before the step moved anything
      std::fill(impulses_.begin(), impulses_.end(), 0.0);
    }
    if (next_ == ahead_.count()) {
      stop_ = ahead_.stopped;
    }
  }

 private:
  /// More at once each time, so that a run that soon ends has not asked for many in vain.
  void ask(double dt, bool is_usual) {
    std::size_t count = 1;
    if (is_usual && usual_left_ > 0) {
      count = std::min(at_once_, usual_left_);
      at_once_ = std::min(2 * at_once_, most_at_once);
      usual_left_ -= count;
    }
    ahead_ = child_->step(dt, count);
    next_ = 0;
  }

  /// A step of another length comes before the last one. What the child has done beyond here cannot
  /// be undone: it begins again and comes here again, and from here on it does what is asked alone.
  void go_no_further_ahead() {
    usual_left_ = 0;
    if (next_ == ahead_.count()) {
      return;
    }
    static_cast<void>(child_->start(case_, model_, settings_));
    for (std::size_t left = taken_; left > 0; left -= std::min(left, most_at_once)) {
      ahead_ = child_->step(settings_.step, std::min(left, most_at_once));
    }
    const double* const last = ahead_.values.data() + (ahead_.count() - 1) * ahead_.width;
    if (taken_ > 0 && std::memcmp(last, row_.data(), row_.size() * sizeof(double)) != 0) {
      throw ProtocolError("the engine does not reach the same state again by the same steps");
    }
    ahead_ = {};
    next_ = 0;
  }

  void take(const double* row, double dt) {
    std::copy_n(row, row_.size(), row_.begin());
    const auto before = std::exchange(state_, state_of(case_, row, clock_.now()));
    refuse_wrapped(before, state_, dt);
    std::copy_n(row + row_.size(), impulses_.size(), impulses_.begin());
  }

  Children::Lease child_;
  const TheCase case_;
  const ChildModel model_;
  const RunSettings settings_;
  std::size_t usual_left_;  // steps of the usual length that may be asked for ahead
  std::size_t taken_ = 0;
  std::size_t at_once_ = 1;
  ChildSteps ahead_;
  std::size_t next_ = 0;  // of `ahead_`
  Clock clock_;
  ChildStart start_;
  std::vector<double> row_;  // the numbers of the state
  StateOf<TheCase> state_;
  std::vector<double> impulses_;
  std::optional<StopOfRun> stop_;
};

/// The same where these impulses are all that the cables pull with.
template <class TheCase>
class ByStepsWithTension final : public BySteps<TheCase>, public TensionImpulses {
 public:
  using BySteps<TheCase>::BySteps;
  [[nodiscard]] std::span<const double> tension_impulses() const override {
    return this->impulses();
  }
};

/// A run that the child steps. Steps of the usual length are asked for ahead, and none past the
/// last of them: a message costs more than many steps.
template <class TheCase>
std::unique_ptr<BasicSimulation<TheCase>> start_by_steps(Children& children,
                                                         const TheCase& the_case,
                                                         const ChildModel& model,
                                                         const RunSettings& settings) {
  if (model.tells_tension) {
    return std::make_unique<ByStepsWithTension<TheCase>>(children, the_case, model, settings);
  }
  return std::make_unique<BySteps<TheCase>>(children, the_case, model, settings);
}

double time_of(const State& /*state*/) { return 0.0; }
double time_of(const SpatialSystemState& state) { return state.time; }

/// The bodies of a child. Each answer brings the state, so that to ask for it costs no message.
template <class TheCase>
class ChildBodies final : public BasicEventAdapter<TheCase> {
 public:
  using State = StateOf<TheCase>;
  using Rounding = typename BasicEventAdapter<TheCase>::Rounding;

  ChildBodies(Children& children, const TheCase& the_case, const ChildModel& model,
              const std::string& precision, const RunSettings& settings)
      : child_(children),
        case_(the_case),
        rounding_(precision == "float32" ? this->float_rounding : double_rounding()) {
    const ChildStart start = child_->start(the_case, model, settings);
    take(start.state, 0.0);
    if (start.rounding) {
      rounding_ = {start.rounding->gap, start.rounding->rate};
    }
  }

  [[nodiscard]] State state() const override { return state_; }
  [[nodiscard]] Rounding rounding() const override { return rounding_; }

  void place(const State& state) override {
    // a NaN is nowhere, and -0 moves as 0 does
    if (numbers_of(state) != numbers_of(state_) || time_of(state) != time_of(state_)) {
      take(child_->place(state), time_of(state));
    }
  }

  void fly(double dt) override {
    const State before = state_;
    take(child_->fly(dt), time_of(before) + dt);
    refuse_wrapped(before, state_, dt);
  }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    ChildSolve solved = child_->solve(cables, rates);
    take(solved.state, time_of(state_));
    return std::move(solved.impulses);
  }

 private:
  void take(const std::vector<double>& numbers, double time) {
    state_ = state_of(case_, numbers.data(), time);
  }
  [[nodiscard]] Rounding double_rounding() const { return BasicEventAdapter<TheCase>::rounding(); }

  Children::Lease child_;
  const TheCase case_;
  Rounding rounding_;
  State state_;
};

/// A run in which the event driver finds every event, and the child flies and solves.
template <class TheCase>
std::unique_ptr<BasicSimulation<TheCase>> start_by_events(Children& children,
                                                          const TheCase& the_case,
                                                          const ChildModel& model,
                                                          const std::string& precision,
                                                          const RunSettings& settings) {
  return drive_by_events(
      the_case,
      std::make_unique<ChildBodies<TheCase>>(children, the_case, model, precision, settings),
      settings.law);
}

ModelEntry entry_of(const ChildModel& model, const std::string& precision,
                    const std::shared_ptr<Children>& children) {
  const auto start = [=]<class TheCase>(
                         const TheCase& the_case,
                         const RunSettings& settings) -> std::unique_ptr<BasicSimulation<TheCase>> {
    return model.by_events ? start_by_events(*children, the_case, model, precision, settings)
                           : start_by_steps(*children, the_case, model, settings);
  };
  ModelEntry result = {.model = model.model,
                       .start = start,
                       .follows_speed = model.by_events || model.follows_speed};
  if (model.model.in_space) {
    result.start_system = start;
  }
  return result;
}

}  // namespace

std::unique_ptr<ChildEngine> ChildEngine::open(const EngineFile& file, std::size_t memory) {
  const auto children = std::make_shared<Children>(
      KeptCommand{file.command, file.path.parent_path().string(), memory});
  const ChildInfo info = Children::Lease(*children)->info();
  if (info.name != file.name) {
    throw ProtocolError(fmt::format("the engine says that its name is {}, {} says {}", info.name,
                                    printable(file.path.native(), 1024), file.name));
  }
  EngineTable table{info.name, info.version, info.precision, {{}}, info.dimensions};
  for (const ChildModel& model : info.models) {
    table.families.front().push_back(entry_of(model, info.precision, children));
  }
  return std::unique_ptr<ChildEngine>(new ChildEngine(std::move(table), children));
}

ChildEngine::ChildEngine(EngineTable table, std::shared_ptr<Children> children)
    : TableEngine(std::move(table)), children_(std::move(children)) {}

double ChildEngine::processor_time() const { return children_->processor_time(); }

double ChildEngine::peak_memory() const { return children_->peak_memory(); }

void ChildEngine::forget_peak_memory() const { children_->forget_peak_memory(); }

}  // namespace tautline::bench
