#include "bench/vectors/steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// A scheme that may be off by this part of the shortest cable says nothing any more [-].
constexpr double too_much = 0.05;

/// Schemes may part where two outcomes are closer than this part of what they may be off by [-]:
/// as in the judgement of runs, whose constant was measured.
constexpr double guard_of_forks = 0.25;

/// Two impacts this many steps apart, or more, are never in the same step.
constexpr double steps_apart = 2.0;

/// Instants of an arc at which a near miss is looked for.
constexpr int looks = 64;

/// A gap below this part of the cable is an impact's or a taut cable's [-].
constexpr double no_gap = 1e-7;

/// An instant from which on steps longer than `step` are not judged.
struct Limit {
  double time;  // [s]
  double step;  // [s]
};

/// What a scheme may be off by for each second of its step [m/s], at each time.
class Allowed {
 public:
  explicit Allowed(const Vector& vector) : vector_(vector) {}

  /// Infinity where no growth is known.
  [[nodiscard]] double at(double time) const {
    const auto row = std::lower_bound(vector_.rows.begin(), vector_.rows.end(), time,
                                      [](const VectorRow& one, double t) { return one.time < t; });
    if (row == vector_.rows.end() || !row->growth) {
      return std::numeric_limits<double>::infinity();
    }
    return allowed_steps * vector_.fastest * *row->growth;
  }

 private:
  const Vector& vector_;
};

/// Impacts of two cables, one after the other, that may swap.
void add_swaps(const Case& the_case, const Solution& solution, const Allowed& allowed,
               std::vector<Limit>& limits) {
  const Event* before = nullptr;
  double before_speed = 0.0;
  for (const Event& event : solution.events()) {
    if (event.kind != EventKind::impact) {
      continue;
    }
    const double speed = closing_speed(the_case, event.cables, event.before);
    if (before != nullptr && before->cables != event.cables) {
      const double unsure =
          allowed.at(before->time) / before_speed + allowed.at(event.time) / speed;
      limits.push_back(
          {before->time, (event.time - before->time) / (steps_apart + guard_of_forks * unsure)});
    }
    before = &event;
    before_speed = speed;
  }
}

/// Instants at which the gap of a slack cable is least, and a scheme may find it closed.
void add_near_misses(const Case& the_case, const Solution& solution, const Allowed& allowed,
                     std::vector<Limit>& limits) {
  for (const Arc& arc : solution.arcs()) {
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
      const Cable& cable = the_case.cables[index];
      double earlier = -1.0;
      double now = -1.0;
      for (int look = 0; look <= looks && !arc.taut.contains(index); ++look) {
        const double dt = (arc.end - arc.start) * look / looks;
        const double later = gap(cable, arc.after(dt, the_case.gravity));
        if (earlier > now && now < later && now > no_gap * cable.length) {
          const double time = arc.start + dt;
          limits.push_back({time, now / (guard_of_forks * allowed.at(time))});
        }
        earlier = now;
        now = later;
      }
    }
  }
}

}  // namespace

void set_steps(Vector& vector, const Solution& solution) {
  const Case& the_case = vector.the_case;
  const Allowed allowed(vector);
  std::vector<Limit> limits;
  add_swaps(the_case, solution, allowed, limits);
  add_near_misses(the_case, solution, allowed, limits);
  std::sort(limits.begin(), limits.end(),
            [](const Limit& one, const Limit& two) { return one.time < two.time; });
  auto limit = limits.begin();
  double step = the_case.duration;
  for (VectorRow& row : vector.rows) {
    for (; limit != limits.end() && limit->time <= row.time; ++limit) {
      step = std::min(step, limit->step);
    }
    step = std::min(step, too_much * shortest_length(the_case) / allowed.at(row.time));
    row.step = step;
  }
}

}  // namespace tautline::bench
