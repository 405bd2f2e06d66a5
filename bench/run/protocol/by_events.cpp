#include "bench/run/protocol/simulations.hpp"

#include <utility>

#include "tautline/event_driver.hpp"

namespace tautline::bench {
namespace {

bool same_place(const State& one, const State& other) {
  // a NaN is nowhere, and -0 moves as 0 does
  return one.position == other.position && one.angle == other.angle &&
         one.velocity == other.velocity && one.spin == other.spin;
}

/// The body of a child. Each answer brings the state, so that to ask for it costs no message.
class ChildBody final : public EventAdapter {
 public:
  ChildBody(Children& children, const Case& the_case, const ChildModel& model,
            const std::string& precision, const RunSettings& settings)
      : child_(children), rounding_(precision == "float32" ? float_rounding : double_rounding()) {
    const ChildStart start = child_->start(the_case, model, settings);
    state_ = start.state;
    rounding_ = start.rounding.value_or(rounding_);
  }

  [[nodiscard]] State state() const override { return state_; }
  [[nodiscard]] Rounding rounding() const override { return rounding_; }

  void place(const State& state) override {
    if (!same_place(state, state_)) {  // else it is there
      state_ = child_->place(state);
    }
  }

  void fly(double dt) override {
    const State before = std::exchange(state_, child_->fly(dt));
    refuse_wrapped(before, state_, dt);
  }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    ChildSolve solved = child_->solve(cables, rates);
    state_ = solved.state;
    return std::move(solved.impulses);
  }

 private:
  [[nodiscard]] Rounding double_rounding() const { return EventAdapter::rounding(); }

  Children::Lease child_;
  Rounding rounding_;
  State state_;
};

}  // namespace

std::unique_ptr<Simulation> start_by_events(Children& children, const Case& the_case,
                                            const ChildModel& model, const std::string& precision,
                                            const RunSettings& settings) {
  return drive_by_events(
      the_case, std::make_unique<ChildBody>(children, the_case, model, precision, settings),
      settings.law);
}

}  // namespace tautline::bench
