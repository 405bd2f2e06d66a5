#include "bench/measure/attribution/systems.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "bench/measure/attribution/carry.hpp"
#include "bench/measure/audit_lost.hpp"
#include "tautline/case_or_system.hpp"
#include "tautline/detail/projection.hpp"

namespace tautline::bench {
namespace {

using SystemImpact = BasicRecordedImpact<SpatialSystem>;
using SystemSegment = BasicSegment<SpatialSystem>;

/// An impact has these steps around its own: a scheme may have it so much sooner or later than the
/// exact motion.
constexpr std::size_t steps_around = 2;

/// Fewer steps than this without a cable's action are not a flight of their own.
constexpr std::size_t shortest_free_flight = 4;

/// A cable that acts for longer than this many steps holds the body; a bounce on a spring takes as
/// many.
constexpr std::size_t longest_impact = 20;

/// True where the cable goes on pulling: its impact is over after the first step.
bool stays(const SystemImpact& impact) {
  return impact.steps > longest_impact &&
         impact.rate_first > -still_closing * std::abs(impact.rate_before);
}

/// The step of `run` that `time` [s] is in.
std::size_t step_at(const SystemTrajectory& run, double time) {
  const auto after =
      std::upper_bound(run.points.begin(), run.points.end(), time,
                       [](double instant, const auto& point) { return instant < point.time; });
  const std::ptrdiff_t points_before = after - run.points.begin();
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(points_before - 1, 0));
}

/// True where no impact of the run rebounds, by the audit's measure.
bool loses_every_rebound(const SpatialSystem& system, const SystemTrajectory& run) {
  bool asked = false;
  for (const SystemImpact& impact : run.impacts) {
    const double wanted = restitution(system.cables[impact.cable], impact.rate_before);
    if (wanted < asking) {
      continue;
    }
    asked = true;
    if (impact.rate_after >= lost_part * wanted * -impact.rate_before) {
      return false;
    }
  }
  return asked;
}

/// Cuts a run into flights and the steps in which cables act.
class SystemCutter {
 public:
  SystemCutter(const SpatialSystem& system, const SystemTrajectory& run, std::size_t last)
      : system_(system), run_(run), last_(last), busy_(last, false) {
    for (std::size_t step = 0; step < last_; ++step) {
      busy_[step] = touches(step) || touches(step + 1) || pulls(step);
    }
    for (const SystemImpact& impact : run_.impacts) {
      const std::size_t first = step_at(run_, impact.time);
      const std::size_t end = step_at(run_, impact.ended) + steps_around + 1;
      for (std::size_t step = first - std::min(first, steps_around); step < std::min(end, last_);
           ++step) {
        busy_[step] = true;
      }
    }
  }

  [[nodiscard]] std::vector<SystemSegment> cut() {
    fill_short_flights();
    for (std::size_t step = 0; step < last_;) {
      const std::size_t end = end_of(step);
      busy_[step] ? add_busy(step, end) : add(SystemSegment::Kind::flight, end, state(end));
      step = end;
    }
    return std::move(segments_);
  }

 private:
  [[nodiscard]] const SpatialSystemState& state(std::size_t point) const {
    return run_.points[point].state;
  }

  /// The first step after `step` that is not of its kind.
  [[nodiscard]] std::size_t end_of(std::size_t step) const {
    const auto from = busy_.begin() + static_cast<std::ptrdiff_t>(step);
    return static_cast<std::size_t>(std::find(from, busy_.end(), !busy_[step]) - busy_.begin());
  }

  void fill_short_flights() {
    for (std::size_t step = 0; step < last_;) {
      const std::size_t end = end_of(step);
      if (!busy_[step] && step > 0 && end < last_ && end - step < shortest_free_flight) {
        std::fill(busy_.begin() + static_cast<std::ptrdiff_t>(step),
                  busy_.begin() + static_cast<std::ptrdiff_t>(end), true);
      }
      step = end;
    }
  }

  [[nodiscard]] bool touches(std::size_t point) const {
    return std::any_of(system_.cables.begin(), system_.cables.end(), [&](const auto& cable) {
      return gap(cable, state(point)) <= gap_rounding * length_of(cable, state(point));
    });
  }

  /// True where the engine tells of a tension in the step.
  [[nodiscard]] bool pulls(std::size_t step) const {
    const std::size_t cables = system_.cables.size();
    if (run_.tensions.empty()) {
      return false;
    }
    const auto first = run_.tensions.begin() + static_cast<std::ptrdiff_t>((step + 1) * cables);
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(cables),
                       [](double tension) { return tension > 0.0; });
  }

  void add(SystemSegment::Kind kind, std::size_t end, const SpatialSystemState& at_end) {
    const bool first = segments_.empty();
    segments_.push_back({kind,
                         first ? 0 : segments_.back().last,
                         end,
                         first ? state(0) : segments_.back().end,
                         at_end,
                         {}});
  }

  /// The state at `point` with the cables that are too long there, and the cable of `impact`, taut.
  [[nodiscard]] SpatialSystemState on_cables(std::size_t point, const SystemImpact& impact) const {
    CableSet held = CableSet::of(impact.cable);
    for (std::size_t index = 0; index < system_.cables.size(); ++index) {
      if (gap(system_.cables[index], state(point)) < 0.0) {
        held.insert(index);
      }
    }
    return projected(system_, state(point), held);
  }

  /// Steps [`step`, `end`), in which cables act.
  void add_busy(std::size_t step, std::size_t end) {
    std::size_t impacts = 0;
    const SystemImpact* first = nullptr;
    for (const SystemImpact& impact : run_.impacts) {
      const std::size_t at = step_at(run_, impact.time);
      if (at >= step && at < end) {
        first = first == nullptr ? &impact : first;
        ++impacts;
      }
    }
    if (end - step <= longest_impact + 2 * steps_around) {
      return add(impacts > 0 ? SystemSegment::Kind::impact : SystemSegment::Kind::taut, end,
                 state(end));
    }
    if (impacts > 0 && impacts <= 2 * system_.cables.size()) {
      const std::size_t caught =
          stays(*first) ? step_at(run_, first->time) + 1 : step_at(run_, first->ended) + 1;
      if (caught < end && caught - step <= longest_impact) {
        add(SystemSegment::Kind::impact, caught, on_cables(caught, *first));
      }
    }
    add(SystemSegment::Kind::taut, end, state(end));
  }

  const SpatialSystem& system_;
  const SystemTrajectory& run_;
  std::size_t last_;
  std::vector<bool> busy_;  // by step
  std::vector<SystemSegment> segments_;
};

/// An impact of a segment, and the exact one that it should be.
struct Matched {
  const SystemImpact* impact;
  std::optional<double> exact_rate;  // [m/s], after the exact impact; none without one
};

/// The hypothetical states of one segment.
class SystemBuilder {
 public:
  SystemBuilder(const SpatialSystem& system, const SystemTrajectory& run,
                const SystemSegment& segment, const BasicSolution<SpatialSystem>& exact)
      : system_(system), segment_(segment), end_(run.points[segment.last].time) {
    for (const SystemImpact& impact : run.impacts) {
      const std::size_t at = step_at(run, impact.time);
      if (at >= segment.first && at < segment.last) {
        hits_.push_back({&impact, std::nullopt});
      }
    }
    follow(exact);
  }

  [[nodiscard]] BasicChain<SpatialSystem> build(bool ignores) const {
    BasicChain<SpatialSystem> chain{exact_, {}};
    const auto add = [&chain](Cause cause, const SpatialSystemState& state) {
      chain.links.push_back({cause, state});
    };
    SpatialSystemState own = exact_;
    if (!hits_.empty()) {
      const auto law = [this](const Matched& hit, double rate) {
        return -restitution(system_.cables[hit.impact->cable], rate) * rate;
      };
      add(Cause::event_lag, through([&](const Matched& hit, double rate) {
            return hit.exact_rate.value_or(law(hit, rate));
          }));
      add(Cause::late_rate, through(law));
      own = through_own();
      add(ignores ? Cause::restitution_ignored : Cause::solver_residual, own);
    }
    for (std::size_t body = 0; body < own.bodies.size(); ++body) {
      own.bodies[body].orientation = segment_.end.bodies[body].orientation;
      own.bodies[body].spin = segment_.end.bodies[body].spin;
    }
    add(Cause::rotation_in_flight, own);
    add(Cause::flight_bias, segment_.end);
    return chain;
  }

 private:
  /// The exact flight to the segment's end, from the last exact impact that is one of its own.
  void follow(const BasicSolution<SpatialSystem>& exact) {
    const double start = segment_.start.time;
    exact_ = flown(system_, segment_.start, end_ - start);
    for (const auto& event : exact.events()) {
      if (start + event.time > end_) {
        break;
      }
      for (const std::size_t cable : event.cables) {
        const auto hit = std::find_if(hits_.begin(), hits_.end(), [cable](const Matched& one) {
          return one.impact->cable == cable && !one.exact_rate;
        });
        if (event.kind == EventKind::impact && hit != hits_.end()) {
          SpatialSystemState after = event.after;
          after.time = start + event.time;
          hit->exact_rate = gap_rate(system_.cables[cable], after);
          exact_ = flown(system_, after, end_ - after.time);
        }
      }
    }
  }

  /// The state at the end if each jump left its cable with the gap rate that `rate` makes of the
  /// one before; a cable that opens faster is let be.
  template <class Rate>
  [[nodiscard]] SpatialSystemState through(const Rate& rate) const {
    SpatialSystemState now = segment_.start;
    for (std::size_t index = 0; index < hits_.size();) {
      const double time = hits_[index].impact->time;
      now = flown(system_, now, time - now.time);
      CableSet cables;
      std::array<double, max_cables> wanted{};
      for (; index < hits_.size() && hits_[index].impact->time == time; ++index) {
        const std::size_t cable = hits_[index].impact->cable;
        const double before = gap_rate(system_.cables[cable], now);
        wanted.at(cable) = rate(hits_[index], before);
        if (wanted.at(cable) > before) {
          cables.insert(cable);
        }
      }
      now = with_rates(system_, now, cables, wanted);
    }
    return flown(system_, now, end_ - now.time);
  }

  /// The state at the end if each jump changed the velocities as the run's own did.
  [[nodiscard]] SpatialSystemState through_own() const {
    SpatialSystemState now = segment_.start;
    double last = -1.0;  // [s], of the jump before
    for (const Matched& hit : hits_) {
      const SystemImpact& impact = *hit.impact;
      now = flown(system_, now, impact.time - now.time);
      if (stays(impact)) {
        std::array<double, max_cables> wanted{};
        wanted.at(impact.cable) = impact.rate_first;
        now = with_rates(system_, now, CableSet::of(impact.cable), wanted);
      } else if (!impact.shared || impact.time != last) {  // one jump of several cables counts once
        // what its steps bring without cables comes with the flight
        const SpatialSystemState free =
            flown(system_, impact.before, impact.after.time - impact.before.time);
        now = with_gain(now, motion_of(impact.after) - motion_of(free));
      }
      last = impact.time;
    }
    return flown(system_, now, end_ - now.time);
  }

  const SpatialSystem& system_;
  const SystemSegment& segment_;
  double end_;  // [s]
  std::vector<Matched> hits_;
  SpatialSystemState exact_;
};

}  // namespace

SystemReading::SystemReading(const SpatialSystem& system, const SystemTrajectory& run)
    : system_(system), run_(run), ignores_(loses_every_rebound(system, run)) {}

std::vector<SystemSegment> SystemReading::segments(std::size_t last) const {
  return SystemCutter(system_, run_, last).cut();
}

BasicChain<SpatialSystem> SystemReading::chain(const SystemSegment& segment,
                                               const BasicSolution<SpatialSystem>& exact) const {
  if (segment.kind == SystemSegment::Kind::taut) {
    const double time = run_.points[segment.last].time - run_.points[segment.first].time;
    SpatialSystemState state = exact.at(std::min(time, exact.end_time()));
    state.time = segment.end.time;
    return {state, {{Cause::taut_drift, segment.end}}};
  }
  return SystemBuilder(system_, run_, segment, exact).build(ignores_);
}

}  // namespace tautline::bench
