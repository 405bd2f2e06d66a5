#include "tautline/solve.hpp"

#include <stdexcept>
#include <utility>

#include "equilibrium.hpp"
#include "half_swing.hpp"
#include "instantiate.hpp"
#include "local_origin.hpp"
#include "progress.hpp"
#include "tautline/first_contact.hpp"
#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/hold.hpp"
#include "tautline/limits.hpp"
#include "tautline/projection.hpp"
#include "tautline/rounding.hpp"

// Everything here is a template on the scalar `Real` because one text serves two arithmetics:
// double, for the answers, and numbers of any length, which say how far those answers are right
// (instantiate.hpp). Three members of `Motion` say how the cables stand. `touching_` are the cables
// at zero gap, which may close, rest or open, and the rate that counts as rest. `taut_` are those
// of them that a recorded event has made taut. `held_` is the motion that their tensions give from
// the present on; it holds up to the next stop, and without it the body flies freely.

namespace tautline {
namespace {

/// The instant that ends an arc, and what happens there.
template <class Real>
struct Stop {
  Real dt;                       // [s] from the start of the arc; NaN: numbers overflowed
  std::optional<Ending> ending;  // none: the motion goes on
  CableSet cables;               // that become taut
  bool is_step = false;          // where a series ends, and nothing happens
};

/// The motion so far: where it is now, and what has been recorded.
template <class Real>
class Motion {
 public:
  /// `touching` are the cables at zero gap.
  Motion(const BasicCase<Real>& the_case, const SolveOptions& options, CableSet touching)
      : case_(the_case), options_(options), state_(the_case.initial) {
    touching_.cables = touching;
    note_speed();
  }

  /// The whole algorithm.
  BasicSolution<Real> run() {
    while (true) {
      if (const auto ending = limit_reached()) {
        return finish(*ending);
      }
      auto [closing, resting] = contacts();
      Stop<Real> stop{Real(0), std::nullopt, closing};  // left by an impact: at once
      if (stop.cables.empty()) {
        if (complete_accumulation()) {
          resting = contacts().resting;
        }
        if (!held_ && !hold_resting(resting)) {
          return finish(Ending::singular);
        }
        if (const auto ending = rest()) {
          return come_to_rest(*ending);
        }
        stop = next_stop();
      }
      if (isnan(stop.dt) || !move(stop)) {
        return finish(Ending::overflow);
      }
      if (stop.ending) {
        return finish(*stop.ending);
      }
      if (stop.is_step && may_swing()) {
        if (const auto half = swing_.follow(case_, arcs_, state_, events_.size())) {
          return swing_on(*half);
        }
      }
      if (!stop.cables.empty()) {
        if (const auto ending = hit()) {
          return finish(*ending);
        }
      }
    }
  }

 private:
  /// Why to give up, if there is a reason.
  [[nodiscard]] std::optional<Ending> limit_reached() {
    if (events_.size() >= options_.max_events) {
      return Ending::event_limit;
    }
    if (steps_ + spring_steps_ / springs_per_step >= options_.max_steps) {
      return Ending::step_limit;
    }
    const auto chattering = progress_.stands_still(time_);
    return chattering && !stop_chatter(*chattering) ? std::optional(Ending::no_progress)
                                                    : std::nullopt;
  }

  /// Ends the impacts that follow each other within this instant. False where they do not end.
  [[nodiscard]] bool stop_chatter(CableSet cables) {
    const auto after = end_of_chatter(case_, state_, cables);
    if (!after || progress_.is_hopeless()) {
      return false;
    }
    record(EventKind::impact, cables,
           -multipliers<Real>(case_, state_, cables, gap_rates(case_, state_, cables)), *after);
    touching_.cables = touching_.cables | cables;
    held_.reset();
    return true;
  }

  /// The cables at zero gap that close now and those that rest, up to rounding.
  struct Contacts {
    CableSet closing;
    CableSet resting;
  };
  [[nodiscard]] Contacts contacts() const {
    Contacts result;
    for (const std::size_t index : touching_.cables) {
      const Real rate = gap_rate(case_.cables[index], state_);
      const Real rounding = touching_.rounding(case_.cables[index]);
      if (rate < -rounding) {
        result.closing.insert(index);
      } else if (rate <= rounding) {
        result.resting.insert(index);
      }
    }
    return result;
  }

  /// Where the bounces of the touching cables accumulate, their end. False where they do not.
  bool complete_accumulation() {
    if (touching_.cables == taut_) {
      return false;  // nothing bounces
    }
    const auto done = completion(case_, state_, touching_, options_.completion);
    if (!done) {
      return false;
    }
    record(EventKind::taut, done->cables,
           -multipliers<Real>(case_, state_, done->cables, gap_rates(case_, state_, done->cables)),
           done->after);
    if (done->ends) {
      accumulations_.push_back({time_, time_ + done->remaining, done->uncertainty, done->cables,
                                energy(case_, events_.back().before) - energy(case_, state_)});
    }
    touching_.cables = touching_.cables | done->cables;
    taut_ = taut_ | done->cables;
    return true;
  }

  /// Finds out which of the cables `resting` at zero gap and rate stay taut, and records what has
  /// changed. False where the motion has no continuation.
  [[nodiscard]] bool hold_resting(CableSet resting) {
    if (!resting.empty()) {
      held_ = hold(case_, state_, touching_, resting);
      if (!held_ && is_caught()) {
        state_.velocity.setZero();
        state_.spin = Real(0);
        held_ = hold(case_, state_, touching_, contacts().resting);
      }
      if (!held_ || is_singular(*held_)) {
        return false;
      }
    }
    const CableSet taut = held_ ? held_->taut() : CableSet{};
    if (const CableSet lost = taut_ - taut; !lost.empty()) {
      record(EventKind::slack, lost, zeros(lost), state_);
    }
    if (const CableSet won = taut - taut_; !won.empty()) {
      state_ = projected(case_, state_, taut);
      record(EventKind::taut, won, zeros(won), state_);
    }
    taut_ = taut;
    return true;
  }

  /// True where what is left of the motion is rounding of the motion before, between cables that
  /// leave it nowhere to go.
  [[nodiscard]] bool is_caught() const {
    constexpr double of_rounding = 100.0;  // [-], left by a long row of impacts within an instant
    return speed_scale(case_, state_) <= of_rounding * rate_rounding();
  }

  /// True where no time step is small enough: tensions grow without bound.
  [[nodiscard]] bool is_singular(const BasicHold<Real>& held) const {
    return !(time_ + held.reach > time_);
  }

  /// The ending where held cables keep the body from moving, now and so for ever. A spin about the
  /// centre that it hangs at is no motion.
  [[nodiscard]] std::optional<Ending> rest() const {
    if (taut_.empty() || state_.velocity.norm() > rate_rounding()) {
      return std::nullopt;
    }
    const bool still =
        speed_scale(case_, state_) <= rate_rounding() || turns_freely(case_, state_, taut_);
    return still ? equilibrium(case_, state_, *held_) : std::nullopt;
  }

  /// The earliest of: a contact, a release, the reach of a series, a limit of the case's validity,
  /// the end of the duration.
  [[nodiscard]] Stop<Real> next_stop() const {
    Stop<Real> stop{case_.duration - time_, Ending::reached_duration, {}};
    if (held_) {
      const auto change = first_change(case_, *held_, stop.dt);
      if (!(change.dt >= stop.dt) || !change.cables.empty()) {
        stop = {change.dt, std::nullopt, change.cables,
                change.cables.empty() && change.dt == held_->reach};
      }
    } else if (const auto search = first_contact(case_, state_, touching_, stop.dt);
               search.contact) {
      stop = {search.contact->dt, std::nullopt, search.contact->cables};
    }
    if (isnan(stop.dt)) {
      return stop;
    }
    if (const auto dt = held_ ? time_to_angle_limit(case_, held_->motion, stop.dt)
                              : time_to_angle_limit(case_, state_, stop.dt)) {
      stop = {*dt, Ending::angle_limit, {}};
    }
    if (const auto dt = held_ ? time_to_ceiling(case_, held_->motion, stop.dt)
                              : time_to_ceiling(case_, state_, stop.dt)) {
      stop = {*dt, Ending::ceiling, {}};
    }
    return stop;
  }

  /// Appends the arc up to `stop` and moves to its end. False, and nothing done, on overflow.
  [[nodiscard]] bool move(const Stop<Real>& stop) {
    BasicArc<Real> arc = arc_to(stop);
    const BasicState<Real> last = arc.after(stop.dt, case_.gravity);
    if (!fits(case_, last)) {
      return false;
    }
    arcs_.push_back(std::move(arc));
    arrive(stop, last);
    return true;
  }

  /// The motion from here up to `stop`.
  [[nodiscard]] BasicArc<Real> arc_to(const Stop<Real>& stop) const {
    const Real end =
        stop.ending == Ending::reached_duration ? case_.duration : Real(time_ + stop.dt);
    BasicArc<Real> arc{time_, end, state_, held_ ? taut_ : CableSet{}, {}};
    if (held_ && !held_->pulling.empty()) {  // else the closed form of flight
      arc.series = held_->motion.pose();
    }
    return arc;
  }

  /// Makes the end of the last arc, `last` up to rounding, the present.
  void arrive(const Stop<Real>& stop, const BasicState<Real>& last) {
    state_ = on_cables(last, held_ ? held_->pulling : CableSet{}, stop.cables);
    time_ = arcs_.back().end;
    touching_.cables = taut_ | (stop.dt > 0 ? stop.cables : touching_.cables | stop.cables);
    touching_.time_rounding = epsilon<Real>() * time_;
    note_speed();
    steps_ += stop.cables.empty() ? 1U : 0U;
    // what has let go of all cables flies
    const bool goes_on = stop.is_step && !held_->taut().empty();
    held_ = goes_on ? continued(case_, state_, touching_, *held_) : std::nullopt;
    if (held_ && is_singular(*held_)) {
      held_.reset();
    }
  }

  /// `state` with what rounding has left of the gaps and rates of taut cables taken away, and of
  /// the gaps of those just hit once it is more than a few arcs leave.
  [[nodiscard]] BasicState<Real> on_cables(BasicState<Real> state, CableSet held,
                                           CableSet hit) const {
    bool drifted = !held.empty();
    for (const std::size_t index : hit) {
      const BasicCable<Real>& cable = case_.cables[index];
      drifted = drifted || abs(gap(cable, state)) > few_roundings * rounding_of_gap(cable, state);
    }
    if (drifted) {
      constexpr double almost_dependent = 1e-2;  // [-], a sine: a hundredfold of the gaps is enough
      state = with_zero_gaps(case_, state, held | hit, hit.empty() ? 0.0 : almost_dependent);
    }
    return held.empty() ? state : with_zero_rates(case_, state, held);
  }

  /// Keeps the rounding of gap rates up to date: that of the fastest speeds so far. Not of the
  /// present ones: the body may be stopped within an instant by ever smaller impacts, and what is
  /// left then is rounding of the speeds before.
  void note_speed() {
    const Real rounding = few_roundings * epsilon<Real>();
    touching_.rate_rounding = max(touching_.rate_rounding, Real(rounding * state_.velocity.norm()));
    touching_.spin_rounding = max(touching_.spin_rounding, Real(rounding * abs(state_.spin)));
  }

  /// Of the fastest attachment [m/s].
  [[nodiscard]] Real rate_rounding() const {
    return touching_.rate_rounding + touching_.spin_rounding * attachment_radius(case_);
  }

  /// Resolves the impact of the touching cables that close or rest; one that grazes is left alone.
  /// Where the rebound is not to be computed nothing is done, and the ending that says why
  /// returned.
  [[nodiscard]] std::optional<Ending> hit() {
    const auto [closing, resting] = contacts();
    const CableSet cables = closing | resting;
    if (cables.empty()) {
      return std::nullopt;
    }
    BasicImpact<Real> impact = resolve_impact(options_.law, case_, state_, cables);
    if (!fits(case_, impact.after) || !impact.impulses.allFinite()) {
      const bool given = delassus(case_, state_, cables).allFinite() &&
                         gap_rates(case_, state_, cables).allFinite();
      return given && impact.impulses.hasNaN() ? Ending::singular : Ending::overflow;
    }
    spring_steps_ += static_cast<std::size_t>(impact.steps);
    record(EventKind::impact, cables, std::move(impact.impulses), impact.after);
    progress_.note_hit(closing);
    return std::nullopt;
  }

  /// Appends an event that takes the present state to `after`.
  void record(EventKind kind, CableSet cables, BasicCableVector<Real> impulses,
              BasicState<Real> after) {
    events_.push_back({time_, kind, cables, std::move(impulses), state_, after});
    state_ = std::move(after);
  }

  [[nodiscard]] static BasicCableVector<Real> zeros(CableSet cables) {
    return BasicCableVector<Real>::Zero(static_cast<Eigen::Index>(cables.size()));
  }

  /// True where the held cables leave one way to move, and no limit but those on this way.
  [[nodiscard]] bool may_swing() const {
    if (is_point_mass(case_)) {  // which may turn on and on to the angle's limit
      return held_ && held_->pulling.size() == 1 && (!case_.angle_limit || state_.spin == 0);
    }
    return held_ && held_->pulling.size() == 2;
  }

  /// Gives `arc` of a point mass a turn of its own.
  static void set_turn(BasicArc<Real>& arc, const Real& angle, const Real& spin) {
    arc.initial.angle = angle;
    arc.initial.spin = spin;
    arc.series(0, 2) = angle;
    arc.series(1, 2) = spin;
  }

  /// Swings to and fro on the arcs of half a swing, from its end on. The motion meets nothing new.
  BasicSolution<Real> swing_on(const HalfSwing<Real>& half) {
    const Real period = half.period(arcs_);
    constexpr double seen = 9.0 / 16.0;  // of a period, from here: its third turning point, and on
    const Real whole = half.end(arcs_) + seen * period;
    const std::vector<BasicArc<Real>> swing = swing_after(half, arcs_);
    const BasicState<Real> start = arcs_.back().initial;
    const Real started = arcs_.back().start;
    arcs_.back().end = half.end(arcs_);
    for (std::size_t turns = 0;; ++turns) {
      const Real later = period * static_cast<double>(turns);
      for (BasicArc<Real> arc : swing) {
        time_ = arcs_.back().end;
        arc.start = time_;
        arc.end = min(case_.duration, Real(arc.end + later));
        if (is_point_mass(case_)) {  // its own turn is never turned back
          set_turn(arc, Real(start.angle + start.spin * (time_ - started)), start.spin);
        }
        state_ = arc.initial;
        if (time_ >= case_.duration) {
          return finish(Ending::reached_duration);
        }
        if (options_.until_locked && time_ > whole) {
          return solution(Ending::locked);
        }
        if (const auto ending = limit_reached()) {
          return finish(*ending);
        }
        arcs_.push_back(std::move(arc));
        ++steps_;
      }
    }
  }

  BasicSolution<Real> come_to_rest(Ending ending) {
    state_.velocity.setZero();
    if (!turns_freely(case_, state_, taut_)) {
      state_.spin = Real(0);
    }
    BasicArc<Real> rest{time_, case_.duration, state_, taut_, {}};
    rest.series.resize(2, 3);
    rest.series << state_.position.x(), state_.position.y(), state_.angle, Real(0), Real(0),
        state_.spin;
    arcs_.push_back(std::move(rest));
    return solution(ending);
  }

  BasicSolution<Real> finish(Ending ending) {
    if (ending != Ending::reached_duration) {
      arcs_.push_back({time_, time_, state_, taut_ & contacts().resting, {}});  // the last state
    }
    return solution(ending);
  }

  BasicSolution<Real> solution(Ending ending) {
    return {case_.gravity, std::move(arcs_), std::move(events_), ending, std::move(accumulations_)};
  }

  const BasicCase<Real>& case_;
  const SolveOptions& options_;
  Real time_ = Real(0);
  BasicState<Real> state_;
  BasicTouching<Real> touching_;
  std::size_t steps_ = 0;         // without an event
  std::size_t spring_steps_ = 0;  // within impacts
  Progress<Real> progress_;
  HalfSwingWatch<Real> swing_;
  CableSet taut_;                        // as far as recorded
  std::optional<BasicHold<Real>> held_;  // the motion from here; none: free flight
  std::vector<BasicArc<Real>> arcs_;
  std::vector<BasicEvent<Real>> events_;
  std::vector<BasicAccumulation<Real>> accumulations_;
};

}  // namespace

template <class Real>
BasicSolution<Real> solve(const BasicCase<Real>& the_case, const SolveOptions& options) {
  if (const auto broken = problems(in_double(the_case)); !broken.empty()) {
    throw std::invalid_argument(broken.front());
  }
  CableSet touching;  // by the rounding of the numbers given
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (starts_at_zero(the_case.cables[index], the_case.initial)) {
      touching.insert(index);
    }
  }
  const BasicVec2<Real> origin = local_origin(the_case);
  if (origin.isZero(0)) {
    return Motion<Real>(the_case, options, touching).run();
  }
  const BasicCase<Real> near = seen_from(origin, the_case);
  return seen_from<Real>(-origin, Motion<Real>(near, options, touching).run());
}

template BasicSolution<Instance> solve(const BasicCase<Instance>&, const SolveOptions&);

}  // namespace tautline
