#include "bench/run/protocol/simulations.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "bench/run/record.hpp"

namespace tautline::bench {
namespace {

/// Steps asked for at once: the engine's own time is then most of it, and a run that is given up
/// early has not cost many for nothing.
constexpr std::size_t most_at_once = 100;

bool same_bits(const State& one, const State& other) {
  const auto numbers = [](const State& state) {
    return std::array{state.position.x(), state.position.y(), state.angle,
                      state.velocity.x(), state.velocity.y(), state.spin};
  };
  const auto ones = numbers(one);
  const auto others = numbers(other);
  return std::memcmp(ones.data(), others.data(), sizeof(ones)) == 0;
}

class BySteps : public Simulation {
 public:
  BySteps(Children& children, const Case& the_case, const ChildModel& model,
          const RunSettings& settings)
      : child_(children),
        case_(the_case),
        model_(model),
        settings_(settings),
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
    const bool is_usual = dt == settings_.step;  // exactly: the very number that was given
    if (!is_usual) {
      go_no_further_ahead();
    }
    if (next_ == ahead_.count()) {
      ask(dt, is_usual);
    }
    ++taken_;
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
  /// be undone: it begins anew and comes here again, and from here on it does what is asked alone.
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
    if (taken_ > 0 && !same_bits(state_from(last), state_)) {
      throw ProtocolError("the engine does not come to the same state again by the same steps");
    }
    ahead_ = {};
    next_ = 0;
  }

  void take(const double* row, double dt) {
    const State before = std::exchange(state_, state_from(row));
    refuse_wrapped(before, state_, dt);
    std::copy_n(row + state_width, impulses_.size(), impulses_.begin());
  }

  Children::Lease child_;
  const Case case_;
  const ChildModel model_;
  const RunSettings settings_;
  std::size_t usual_left_;  // steps of the usual length that may be asked for ahead
  std::size_t taken_ = 0;
  std::size_t at_once_ = 1;
  ChildSteps ahead_;
  std::size_t next_ = 0;  // of `ahead_`
  State state_;
  std::vector<double> impulses_;
  std::optional<Stop> stop_;
};

/// The same where these impulses are all that the cables pull with.
class ByStepsWithTension final : public BySteps, public TensionImpulses {
 public:
  using BySteps::BySteps;
  [[nodiscard]] std::span<const double> tension_impulses() const override { return impulses(); }
};

}  // namespace

std::unique_ptr<Simulation> start_by_steps(Children& children, const Case& the_case,
                                           const ChildModel& model, const RunSettings& settings) {
  if (model.tells_tension) {
    return std::make_unique<ByStepsWithTension>(children, the_case, model, settings);
  }
  return std::make_unique<BySteps>(children, the_case, model, settings);
}

}  // namespace tautline::bench
