#include "bench/run/protocol/by_steps.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bench/run/protocol/unwrapped.hpp"
#include "bench/run/record.hpp"

namespace tautline::bench {
namespace {

/// Steps asked for at once: the engine's own time is then most of it, and a run that is given up
/// early has not cost many for nothing.
constexpr std::size_t most_at_once = 100;

class BySteps final : public Simulation {
 public:
  BySteps(Children& children, const Case& the_case, const ChildModel& model,
          const RunSettings& settings)
      : child_(children),
        usual_(settings.step),
        usual_left_(step_count(the_case.duration, settings.step) - 1),
        state_(child_->start(the_case, model, settings).state),
        impulses_(the_case.cables.size()) {}

  [[nodiscard]] State state() const override { return state_; }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::optional<Stop> stopped() const override { return stop_; }

  void step(double dt) override {
    if (stop_) {
      return;
    }
    if (next_ == ahead_.count()) {
      ask(dt);
    } else if (dt != usual_) {  // exactly: the very number that was given
      throw std::logic_error("a run in another process is stepped by its step until its last one");
    }
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
  void ask(double dt) {
    std::size_t count = 1;
    if (dt == usual_ && usual_left_ > 0) {
      count = std::min(at_once_, usual_left_);
      at_once_ = std::min(2 * at_once_, most_at_once);
      usual_left_ -= count;
    }
    ahead_ = child_->step(dt, count);
    next_ = 0;
  }

  void take(const double* row, double dt) {
    const State before = std::exchange(state_, state_from(row));
    refuse_wrapped(before, state_, dt);
    std::copy_n(row + state_width, impulses_.size(), impulses_.begin());
  }

  Children::Lease child_;
  double usual_;            // [s], length of every step but the last
  std::size_t usual_left_;  // of these, to be asked for
  std::size_t at_once_ = 1;
  ChildSteps ahead_;
  std::size_t next_ = 0;  // of `ahead_`
  State state_;
  std::vector<double> impulses_;
  std::optional<Stop> stop_;
};

}  // namespace

std::unique_ptr<Simulation> start_by_steps(Children& children, const Case& the_case,
                                           const ChildModel& model, const RunSettings& settings) {
  return std::make_unique<BySteps>(children, the_case, model, settings);
}

}  // namespace tautline::bench
