// The exact solver as an engine: the control every other engine is compared with on the same path.
// It has no settings. It reports impacts only, as every engine does, and ends where the solution
// ends. `event` tells its impacts as an engine with the event driver does, `sampled` hides them in
// its steps as an engine with fixed steps does: the one is the control of what is compared, the
// other of how impacts are detected.

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>

#include "tautline/clock.hpp"
#include "tautline/model_table.hpp"
#include "tautline/plain_scheme.hpp"
#include "tautline/plugin.hpp"
#include "tautline/solve.hpp"

namespace tautline {
namespace {

/// A time past the end of the solution by no more than this is rounding in the sum of steps [-].
constexpr double time_rounding = 1e-12;

/// Points from -1 to 1, of either sign, and weights of the rule of Gauss with eight of them
/// (Abramowitz and Stegun 1964, table 25.4) [-].
struct GaussPoint {
  double at;
  double weight;
};
constexpr std::array<GaussPoint, 4> gauss = {{{0.183434642495650, 0.362683783378362},
                                              {0.525532409916329, 0.313706645877887},
                                              {0.796666477413627, 0.222381034453374},
                                              {0.960289856497536, 0.101228536290376}}};

/// What a run tells of the impacts in a step.
enum class Report { events, impulses_only };

/// TheCase is Case or SpatialSystem.
template <class TheCase>
class ExactSimulation final : public BasicSimulation<TheCase>, public TensionImpulses {
 public:
  using Event = BasicEvent<TheCase>;

  ExactSimulation(const TheCase& the_case, const RunSettings& run, Report report)
      : report_(report),
        solution_(solve(the_case, SolveOptions{.law = run.law})),
        impulses_(the_case.cables.size()),
        tension_impulses_(the_case.cables.size()) {}

  [[nodiscard]] StateOf<TheCase> state() const override {
    // before the first step no event has happened, not even one at time 0
    return clock_.now() > 0.0 ? solution_.at(std::min(clock_.now(), solution_.end_time()))
                              : solution_.arcs().front().initial;
  }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  /// Of `sampled` with those of the impacts, as an engine with fixed steps has them.
  [[nodiscard]] std::span<const double> tension_impulses() const override {
    return tension_impulses_;
  }
  [[nodiscard]] std::span<const Event> events() const override { return events_; }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override { return stop_; }

  void step(double dt) override {
    std::fill(impulses_.begin(), impulses_.end(), 0.0);
    std::fill(tension_impulses_.begin(), tension_impulses_.end(), 0.0);
    events_.clear();
    if (stop_) {
      return;
    }
    const double start = clock_.now();
    clock_.advance(dt);
    report_impacts();
    const double until = std::min(clock_.now(), solution_.end_time());
    if (first_elastic(solution_.system())) {
      add_tensions_by_arcs(start, until);
    } else {
      add_tensions(start, until);
    }
    if (report_ == Report::impulses_only) {
      std::transform(impulses_.begin(), impulses_.end(), tension_impulses_.begin(),
                     tension_impulses_.begin(), std::plus<>());
    }
    const double end = solution_.end_time();
    if (clock_.now() > end * (1.0 + time_rounding)) {
      stop_ =
          StopOfRun{end, "the exact solution ends: " + std::string(to_string(solution_.ending()))};
    }
  }

 private:
  void report_impacts() {
    const auto& all = solution_.events();
    for (; next_ < all.size() && all[next_].time <= clock_.now(); ++next_) {
      if (all[next_].kind != EventKind::impact) {
        continue;
      }
      if (report_ == Report::events) {
        events_.push_back(all[next_]);
      }
      Eigen::Index row = 0;
      for (const std::size_t index : all[next_].cables) {
        impulses_[index] += all[next_].impulses[row++];
      }
    }
  }

  /// The integral of the tensions from `start` to `end` [s]: Simpson's rule between two events.
  void add_tensions(double start, double end) {
    const auto& all = solution_.events();
    auto next = std::upper_bound(all.begin(), all.end(), start,
                                 [](double time, const Event& event) { return time < event.time; });
    while (start < end) {
      const double until = next != all.end() ? std::min(next->time, end) : end;
      // just inside: at an event the tensions are those after it
      const double inset = 1e-6 * (until - start);  // [s], what the rule misses by is far less
      const CableVector sum = solution_.tensions(start + inset) +
                              4.0 * solution_.tensions(0.5 * (start + until)) +
                              solution_.tensions(until - inset);
      for (std::size_t index = 0; index < tension_impulses_.size(); ++index) {
        tension_impulses_[index] += (until - start) / 6.0 * sum[static_cast<Eigen::Index>(index)];
      }
      start = until;
      if (next != all.end()) {
        ++next;
      }
    }
  }

  /// Adds them where springs may ring between two events: by the rule of Gauss on each arc. A
  /// ringing spring has two or more in a period.
  void add_tensions_by_arcs(double start, double end) {
    const auto& arcs = solution_.arcs();
    while (arc_ + 1 < arcs.size() && arcs[arc_].end <= start) {
      ++arc_;
    }
    for (std::size_t index = arc_; index < arcs.size() && arcs[index].start < end; ++index) {
      const auto& arc = arcs[index];
      const double half = 0.5 * (std::min(end, arc.end) - std::max(start, arc.start));
      const double middle = std::max(start, arc.start) - arc.start + half;  // [s], of the arc
      CableVector sum = CableVector::Zero(static_cast<Eigen::Index>(tension_impulses_.size()));
      for (const auto& [at, weight] : gauss) {
        sum += weight * (solution_.tensions(arc, middle - half * at) +
                         solution_.tensions(arc, middle + half * at));
      }
      for (std::size_t cable = 0; cable < tension_impulses_.size(); ++cable) {
        tension_impulses_[cable] += half * sum[static_cast<Eigen::Index>(cable)];
      }
    }
  }

  Report report_;
  BasicSolution<TheCase> solution_;
  Clock clock_;
  std::size_t next_ = 0;  // the first event not yet reported
  std::size_t arc_ = 0;   // of the latest step's start
  std::vector<double> impulses_;
  std::vector<double> tension_impulses_;
  std::vector<Event> events_;
  std::optional<StopOfRun> stop_;
};

/// The yardstick as a model: what a correct scheme that knows nothing of cables but their rows
/// makes of a case.
template <class TheCase>
class PlainSimulation final : public BasicSteppedSimulation<TheCase> {
 public:
  PlainSimulation(const TheCase& the_case, const RunSettings& /*run*/)
      : scheme_(the_case, BasicPlainScheme<TheCase>::Acts::late) {}

  [[nodiscard]] StateOf<TheCase> state() const override { return scheme_.state(); }
  void step(double dt) override { scheme_.step(dt); }
  [[nodiscard]] std::span<const double> impulses() const override { return scheme_.impulses(); }

 private:
  BasicPlainScheme<TheCase> scheme_;
};

ModelEntry plain() {
  return {.model = {.name = "plain",
                    .sentence = "A plain correct scheme of fixed steps, velocity first: the "
                                "yardstick that every model with fixed steps is judged by.",
                    .settings = {},
                    .maker = Maker::tautline,
                    .cables = Cables::any},
          .start = makes<PlainSimulation<Case>>(),
          .start_system = makes<PlainSimulation<SpatialSystem>>(),
          .follows_speed = true};
}

ModelEntry entry(std::string name, std::string sentence, Report report) {
  return {.model = {.name = std::move(name),
                    .sentence = std::move(sentence),
                    .settings = {},
                    .maker = Maker::tautline,
                    .cables = Cables::any},
          .start = makes<ExactSimulation<Case>>(report),
          .start_system = makes<ExactSimulation<SpatialSystem>>(report),
          .follows_speed = true};
}

EngineTable table() {
  return {.name = "exact",
          .version = TAUTLINE_VERSION,
          .precision = precision_of<double>,
          .families = {{entry("event", "The exact event-driven solution, evaluated at every step.",
                              Report::events),
                        entry("sampled",
                              "The same states with the impulses of each step but not its events: "
                              "what is wrong with its impacts is what detecting them from such "
                              "steps costs any engine.",
                              Report::impulses_only),
                        plain()}},
          .dimensions = 3};
}

}  // namespace
}  // namespace tautline

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::table>)
