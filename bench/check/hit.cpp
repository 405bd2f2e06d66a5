#include "bench/check/hit.hpp"

#include "bench/check/stepping.hpp"

namespace tautline::bench {
namespace {

/// A contact that goes on for longer is a cable that is held taut [steps].
constexpr int longest_hit = 200;

}  // namespace

std::optional<Hit> first_hit(const Subject& subject, const Case& the_case, double step,
                             double end) {
  const auto simulation = subject.start(the_case, step);
  std::optional<Hit> hit;
  bool over = false;
  run_whole(*simulation, step, end, [&](const Moment& moment) {
    const double impulse = simulation->impulses()[0];
    over = over || (hit && (impulse <= 0.0 || hit->steps >= longest_hit));
    if (over || impulse <= 0.0) {
      return;
    }
    if (!simulation->events().empty()) {
      const Event& event = simulation->events().front();
      hit = {event.before, event.after, event.impulses[0], 0};
      over = true;
      return;
    }
    const State pose = at_the_solve(moment.before, step, subject.flight());
    if (!hit) {
      hit = {pose, pose, 0.0, 0};
    }
    hit->after = pose;
    hit->after.velocity = moment.after.velocity;
    hit->after.spin = moment.after.spin;
    hit->impulse += impulse;
    ++hit->steps;
  });
  return hit;
}

}  // namespace tautline::bench
