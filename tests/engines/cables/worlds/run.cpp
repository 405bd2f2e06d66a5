#include "engines/cables/worlds/run.hpp"

namespace tautline::test {

Run::Run(const World& world, const Playing& playing)
    : world_(world),
      playing_(playing),
      scene_(play(world, playing.rate)),
      audit_(std::make_unique<Audit>(world, playing.stepping, scene_->dt(), *scene_)) {
  if (playing.quick) {
    scene_->use_quick_step();
  }
}

void Run::step() {
  ++steps_;
  move_hooks(*scene_, world_, time());
  int parts = 1;
  if (playing_.stepping == Stepping::by_events) {
    parts = scene_->step_by_events();
  } else {
    scene_->step();
  }
  audit_->look(*scene_, parts);
}

void Run::go_on_until(double time) {
  while (this->time() < time - 0.5 * dt() && !is_over()) {
    step();
  }
}

Findings findings_of(const World& world, const Playing& playing, double seconds) {
  Run run(world, playing);
  run.go_on_until(seconds);
  return run.findings();
}

}  // namespace tautline::test
