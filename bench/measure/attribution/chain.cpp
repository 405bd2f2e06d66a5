#include "bench/measure/attribution/chain.hpp"

#include <algorithm>
#include <optional>

#include "tautline/detail/flight.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// A shift of the pose counts as pushed out from this part of the overstretch on [-]: less is the
/// integrator's.
constexpr double clear_shift = 0.05;

/// A jump of the segment beside the exact impact that it matches.
struct Partnered {
  const Jump* jump;
  double time;                       // [s], in the run
  Eigen::Vector3d change;            // of velocity and spin, over the jump's steps in the segment
  std::optional<double> exact_rate;  // [m/s], after the exact impact; none without one
};

Eigen::Vector3d change_in_step(const Case& the_case, const Trajectory& run, std::size_t step) {
  const Point& from = run.points[step];
  const Point& to = run.points[step + 1];
  Eigen::Vector3d change;
  change << to.state.velocity - from.state.velocity - (to.time - from.time) * the_case.gravity,
      to.state.spin - from.state.spin;
  return change;
}

class Builder {
 public:
  Builder(const Case& the_case, const Trajectory& run, const PlanarSegment& segment,
          const std::vector<Jump>& jumps, const Scheme& scheme, const Solution& exact)
      : case_(the_case),
        run_(run),
        segment_(segment),
        scheme_(scheme),
        start_(run.points[segment.first].time),
        end_(run.points[segment.last].time) {
    collect(jumps);
    find_partners(exact);
  }

  [[nodiscard]] PlanarChain build() {
    PlanarChain chain{exact_, {}};
    const auto add = [&chain](Cause cause, const State& state) {
      chain.links.push_back({cause, state});
    };
    if (!jumps_.empty()) {
      add(Cause::event_lag,
          through([](const Partnered& hit, const State&) { return hit.exact_rate.value_or(0.0); }));
      scheme_.ignores ? add_without_rebounds(chain) : add_rebounds(chain);
      const State own = through_own_jumps();
      add(Cause::solver_residual, own);
      if (const auto pushed = pushed_out(own)) {
        add(Cause::position_correction, *pushed);
      }
    }
    const State& last = run_.points[segment_.last].state;
    add(Cause::flight_bias, last);
    if (last.position != segment_.end.position || last.velocity != segment_.end.velocity) {
      add(Cause::event_lag, segment_.end);
    }
    return chain;
  }

 private:
  /// What the run's rules make of the rebounds, one after the other.
  void add_rebounds(PlanarChain& chain) const {
    const auto late = [this](const Partnered& hit, const State& at) {
      return bounced_rate(case_, scheme_.bounce, *hit.jump, at);
    };
    const auto corrected = [&](const Partnered& hit, const State& at) {
      return corrected_rate(case_, scheme_, *hit.jump, at, late(hit, at));
    };
    const auto lost = [this](const Partnered& hit, const State& at) {
      const double rate = bounced_rate(case_, scheme_.bounce, *hit.jump, at, !hit.jump->lost);
      return corrected_rate(case_, scheme_, *hit.jump, at, rate);
    };
    chain.links.push_back({Cause::late_rate, through(late)});
    chain.links.push_back({Cause::position_correction, through(corrected)});
    chain.links.push_back({Cause::threshold, through(lost)});
  }

  /// The same where nothing rebounds: the rate of which it would is nobody's.
  void add_without_rebounds(PlanarChain& chain) const {
    const auto lost = [this](const Partnered& hit, const State& at) {
      return bounced_rate(case_, scheme_.bounce, *hit.jump, at, false);
    };
    const auto corrected = [&](const Partnered& hit, const State& at) {
      return corrected_rate(case_, scheme_, *hit.jump, at, lost(hit, at));
    };
    chain.links.push_back({Cause::restitution_ignored, through(lost)});
    chain.links.push_back({Cause::position_correction, through(corrected)});
  }

  /// The jumps of the segment with what they did in it.
  void collect(const std::vector<Jump>& jumps) {
    std::size_t next = segment_.first;  // the first step whose change is nobody's yet
    for (const Jump& jump : jumps) {
      if (jump.first_step < segment_.first || jump.first_step >= segment_.last ||
          jump.time > end_) {
        continue;
      }
      Partnered hit{&jump, jump.time, Eigen::Vector3d::Zero(), std::nullopt};
      if (jump.located) {
        const bool same = !jumps_.empty() && jumps_.back().jump->time == jump.time &&
                          jumps_.back().jump->change == jump.change;
        hit.change = same ? Eigen::Vector3d::Zero().eval() : jump.change;
      } else {
        const std::size_t last = std::min(jump.last_step + 1, segment_.last);
        hit.time = centre(jump, last);
        for (std::size_t step = std::max(next, jump.first_step); step < last; ++step) {
          hit.change += change_in_step(case_, run_, step);
        }
        next = std::max(next, last);
      }
      jumps_.push_back(hit);
    }
    std::stable_sort(jumps_.begin(), jumps_.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
  }

  /// The mean instant of a push over several steps, each weighed with what it does [s].
  [[nodiscard]] double centre(const Jump& jump, std::size_t last) const {
    if (last <= jump.first_step + 1) {
      return jump.time;
    }
    double sum = 0.0;
    double moment = 0.0;
    for (std::size_t step = jump.first_step; step < last; ++step) {
      const double size = change_in_step(case_, run_, step).head<2>().norm();
      sum += size;
      moment += size * (run_.points[step].time + scheme_.instant * run_.step);
    }
    return sum > 0.0 ? moment / sum : jump.time;
  }

  /// Gives each jump the exact impact of its cable and rank, and flies from the last of them to the
  /// segment's end.
  void find_partners(const Solution& exact) {
    exact_ = fly(segment_.start, case_.gravity, end_ - start_);
    const double reach = 2.0 * (end_ - start_);  // an exact impact may come a little after the end
    for (const Event& event : exact.events()) {
      if (event.time > reach) {
        break;
      }
      if (event.kind != EventKind::impact) {
        continue;
      }
      for (const std::size_t cable : event.cables) {
        const auto hit =
            std::find_if(jumps_.begin(), jumps_.end(), [cable](const Partnered& candidate) {
              return candidate.jump->cable == cable && !candidate.exact_rate;
            });
        if (hit != jumps_.end()) {
          hit->exact_rate = gap_rate(case_.cables[cable], event.after);
          exact_ = fly(event.after, case_.gravity, end_ - start_ - event.time);
        }
      }
    }
  }

  /// The state at the end if each jump left its cable with the gap rate that `rate` says; a cable
  /// that opens faster is let be.
  template <class Rate>
  [[nodiscard]] State through(const Rate& rate) const {
    State now = segment_.start;
    double time = start_;
    for (std::size_t index = 0; index < jumps_.size();) {
      now = fly(now, case_.gravity, jumps_[index].time - time);
      time = jumps_[index].time;
      CableSet cables;
      std::array<double, max_cables> wanted{};
      for (; index < jumps_.size() && jumps_[index].time == time; ++index) {
        const Partnered& hit = jumps_[index];
        const std::size_t cable = hit.jump->cable;
        wanted[cable] = rate(hit, now);
        if (wanted[cable] > gap_rate(case_.cables[cable], now)) {
          cables.insert(cable);
        }
      }
      const State free = now;
      now = with_rates(case_, free, cables, wanted);
      const std::size_t before = cables.size();
      for (const std::size_t cable : segment_.held) {  // a cable that is taut already stays so
        if (!cables.contains(cable) && gap_rate(case_.cables[cable], now) < 0.0) {
          cables.insert(cable);
        }
      }
      if (cables.size() > before) {
        now = with_rates(case_, free, cables, wanted);
      }
    }
    return fly(now, case_.gravity, end_ - time);
  }

  [[nodiscard]] State through_own_jumps() const {
    State now = segment_.start;
    double time = start_;
    for (const Partnered& hit : jumps_) {
      now = fly(now, case_.gravity, hit.time - time);
      time = hit.time;
      now.velocity += hit.change.head<2>();
      now.spin += hit.change[2];
    }
    return fly(now, case_.gravity, end_ - time);
  }

  /// `own` shifted out along the cable of a single jump by what the run's pose is further out; none
  /// if that is nothing to speak of.
  [[nodiscard]] std::optional<State> pushed_out(const State& own) const {
    if (jumps_.size() != 1 || !(jumps_.front().jump->overstretch > 0.0)) {
      return std::nullopt;
    }
    const Jump& jump = *jumps_.front().jump;
    const Cable& cable = case_.cables[jump.cable];
    const double shift = gap(cable, run_.points[segment_.last].state) - gap(cable, own);
    const double bias = case_.gravity.norm() * jump.dt * (end_ - start_);
    if (shift < clear_shift * jump.overstretch + bias) {
      return std::nullopt;
    }
    const CableSet only = CableSet::of(jump.cable);
    State direction = own;
    direction.velocity.setZero();
    direction.spin = 0.0;
    CableVector gain(1);
    gain[0] = shift;
    direction = with_impulses<double>(case_, direction, only, multipliers(case_, own, only, gain));
    State pushed = own;
    pushed.position += direction.velocity;
    pushed.angle += direction.spin;
    return pushed;
  }

  const Case& case_;
  const Trajectory& run_;
  const PlanarSegment& segment_;
  const Scheme& scheme_;
  double start_;  // [s]
  double end_;    // [s]
  State exact_;
  std::vector<Partnered> jumps_;
};

}  // namespace

PlanarChain chain_of(const Case& the_case, const Trajectory& run, const PlanarSegment& segment,
                     const std::vector<Jump>& jumps, const Scheme& scheme, const Solution& exact) {
  if (segment.kind == PlanarSegment::Kind::taut) {
    const double time = run.points[segment.last].time - run.points[segment.first].time;
    return {exact.at(std::min(time, exact.end_time())), {{Cause::taut_drift, segment.end}}};
  }
  return Builder(the_case, run, segment, jumps, scheme, exact).build();
}

}  // namespace tautline::bench
