#include "bench/measure/attribution/segments.hpp"

#include <algorithm>
#include <cmath>

#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// A cable acts in a step whose velocity is off the parabola by this part of gravity's change [-]:
/// the tension of a taut cable is more, the bias of an integrator less.
constexpr double clear_pull = 0.05;

/// Fewer steps than this without a cable's action are not a flight of their own.
constexpr std::size_t shortest_flight = 4;

/// A cable that stays at zero rate for this many steps holds the body; a soft impact turns sooner.
constexpr std::size_t held_steps = 10;

/// Zero rate of a held cable: gravity's change of velocity in this many steps [-].
constexpr double held_rate = 4.0;

/// An impact that ends a taut stretch is faster than gravity makes a body in this many steps [-].
constexpr double clear_impact = 5.0;

class Cutter {
 public:
  Cutter(const Case& the_case, const Trajectory& run, const std::vector<Jump>& jumps,
         std::size_t last)
      : case_(the_case), run_(run), jumps_(jumps), last_(last), busy_(last, false) {
    for (std::size_t step = 0; step < last_; ++step) {
      busy_[step] = touches(step) || touches(step + 1) || pulls(step);
    }
    for (const Jump& jump : jumps_) {
      for (std::size_t step = jump.first_step; step <= jump.last_step && step < last_; ++step) {
        busy_[step] = true;
      }
    }
    for (std::size_t step = 0; step < last_;) {  // flights too short are no flights
      std::size_t end = step;
      while (end < last_ && busy_[end] == busy_[step]) {
        ++end;
      }
      if (!busy_[step] && step > 0 && end < last_ && end - step < shortest_flight) {
        std::fill(busy_.begin() + static_cast<std::ptrdiff_t>(step),
                  busy_.begin() + static_cast<std::ptrdiff_t>(end), true);
      }
      step = end;
    }
  }

  [[nodiscard]] std::vector<PlanarSegment> cut() {
    for (std::size_t step = 0; step < last_;) {
      std::size_t end = step;
      while (end < last_ && busy_[end] == busy_[step]) {
        ++end;
      }
      if (busy_[step]) {
        add_busy(step, end);
      } else {
        add(PlanarSegment::Kind::flight, end, state(end));
      }
      step = end;
    }
    return std::move(segments_);
  }

 private:
  [[nodiscard]] const State& state(std::size_t point) const { return run_.points[point].state; }
  [[nodiscard]] double dt(std::size_t step) const {
    return run_.points[step + 1].time - run_.points[step].time;
  }

  [[nodiscard]] bool touches(std::size_t point) const {
    return std::any_of(case_.cables.begin(), case_.cables.end(), [&](const Cable& cable) {
      return gap(cable, state(point)) <= gap_rounding * cable.length;
    });
  }

  /// True where the step is no flight, and a cable is near enough to be the reason.
  [[nodiscard]] bool pulls(std::size_t step) const {
    const State& from = state(step);
    const State& to = state(step + 1);
    const double gravity = case_.gravity.norm() * dt(step);
    const double off = (to.velocity - from.velocity - dt(step) * case_.gravity).norm() +
                       attachment_radius(case_) * std::abs(to.spin - from.spin);
    if (jumps_.empty() || jumps_.front().located || off <= clear_pull * gravity) {
      return false;
    }
    const double way = 2.0 * dt(step) * (speed_scale(case_, from) + gravity);
    return std::any_of(case_.cables.begin(), case_.cables.end(),
                       [&](const Cable& cable) { return gap(cable, from) < way; });
  }

  /// The cables at zero rate and at most a little slack from `point` on for `held_steps`.
  [[nodiscard]] CableSet held_from(std::size_t point) const {
    CableSet held;
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const Cable& cable = case_.cables[index];
      bool stays = true;
      for (std::size_t later = point; stays && later <= point + held_steps; ++later) {
        const double gravity = case_.gravity.norm() * dt(later);
        stays = std::abs(gap_rate(cable, state(later))) <= held_rate * gravity &&
                gap(cable, state(later)) <= held_rate * gravity * dt(later);
      }
      if (stays) {
        held.insert(index);
      }
    }
    return held;
  }

  /// The state with `held` taut and no other cable overstretched.
  [[nodiscard]] State on_cables(const State& state, CableSet held) const {
    State result = projected(case_, state, held);
    CableSet all = held;
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      if (gap(case_.cables[index], result) < 0.0) {
        all.insert(index);
      }
    }
    return all == held ? result : with_zero_gaps(case_, result, all);
  }

  void add(PlanarSegment::Kind kind, std::size_t end, const State& at_end, CableSet held = {}) {
    const bool first = segments_.empty();
    segments_.push_back({kind, first ? 0 : segments_.back().last, end,
                         first ? state(0) : segments_.back().end, at_end, held});
  }

  /// Steps [`point`, `end`) on the cables `held`, up to the next impact on another one, and on.
  void add_taut(std::size_t point, std::size_t end, CableSet held) {
    for (const Jump& jump : jumps_) {
      const double rate = gap_rate(case_.cables[jump.cable], jump.before);
      const bool fast = -rate > clear_impact * case_.gravity.norm() * jump.dt;
      if (held.contains(jump.cable) || !fast || jump.first_step >= end) {
        continue;
      }
      // before the cable is taut; a step more, as the exact motion may be a little earlier
      std::size_t before = jump.first_step;
      while (before > point && gap(case_.cables[jump.cable], state(before)) <= 0.0) {
        --before;
      }
      if (before <= point + 1) {
        continue;
      }
      --before;
      add(PlanarSegment::Kind::taut, before, on_cables(state(before), held));
      return add_busy(before, end, held);
    }
    add(PlanarSegment::Kind::taut, end, state(end));
  }

  /// Steps [`step`, `end`), in which cables act; `taut_before` ones do from the start.
  void add_busy(std::size_t step, std::size_t end, CableSet taut_before = {}) {
    std::size_t jumps = 0;
    std::size_t first_jump = end;
    for (const Jump& jump : jumps_) {
      if (jump.first_step >= step && jump.first_step < end) {
        first_jump = std::min(first_jump, jump.first_step);
        ++jumps;
      }
    }
    for (std::size_t point = first_jump + 1; point + held_steps < end; ++point) {
      if (const CableSet held = held_from(point); !held.empty()) {
        add(PlanarSegment::Kind::impact, point, on_cables(state(point), held), taut_before);
        return add_taut(point, end, held);
      }
    }
    const bool chatters = end - step > held_steps && jumps > 2 * case_.cables.size();
    const bool taut = chatters || (jumps == 0 && end - step > held_steps);
    add(taut ? PlanarSegment::Kind::taut : PlanarSegment::Kind::impact, end, state(end),
        taut_before);
  }

  const Case& case_;
  const Trajectory& run_;
  const std::vector<Jump>& jumps_;
  std::size_t last_;
  std::vector<bool> busy_;  // by step
  std::vector<PlanarSegment> segments_;
};

}  // namespace

std::vector<PlanarSegment> segments(const Case& the_case, const Trajectory& run,
                                    const std::vector<Jump>& jumps, std::size_t last) {
  return Cutter(the_case, run, jumps, last).cut();
}

}  // namespace tautline::bench
