#include "bench/check/hit.hpp"

#include <limits>

#include "bench/check/stepping.hpp"
#include "tautline/case_or_system.hpp"

namespace tautline::bench {
namespace {

/// A contact that goes on for longer is a cable that is held taut [steps].
constexpr int longest_hit = 200;

}  // namespace

template <class TheCase>
std::optional<BasicHit<TheCase>> first_hit(const Subject& subject, const TheCase& the_case,
                                           double step, double end) {
  const auto simulation = subject.start(the_case, step);
  std::optional<BasicHit<TheCase>> hit;
  bool over = false;
  run_whole(*simulation, step, end, [&](const BasicMoment<TheCase>& moment) {
    const double impulse = simulation->impulses()[0];
    over = over || (hit && (impulse <= 0.0 || hit->steps >= longest_hit));
    if (over || impulse <= 0.0) {
      return;
    }
    if (!simulation->events().empty()) {
      const BasicEvent<TheCase>& event = simulation->events().front();
      hit = BasicHit<TheCase>{event.before, event.after, event.impulses[0], 0};
      over = true;
      return;
    }
    const StateOf<TheCase> pose = at_the_solve(moment.before, step, subject.flight());
    if (!hit) {
      hit = BasicHit<TheCase>{pose, pose, 0.0, 0};
    }
    hit->after = with_velocities(pose, moment.after);
    hit->impulse += impulse;
    ++hit->steps;
  });
  return hit;
}

template std::optional<Hit> first_hit(const Subject&, const Case&, double, double);
template std::optional<SystemHit> first_hit(const Subject&, const SpatialSystem&, double, double);

Measure never_hit(double limit) {
  return {std::numeric_limits<double>::infinity(), limit,
          "the cable is never hit: no impulse is reported"};
}

}  // namespace tautline::bench
