#include "tautline/solve.hpp"

#include <stdexcept>
#include <type_traits>
#include <utility>

#include "instantiate.hpp"
#include "local_origin.hpp"
#include "loop/next_stop.hpp"
#include "loop/progress.hpp"
#include "loop/record.hpp"
#include "loop/standing.hpp"
#include "shortcuts/paused_motion.hpp"
#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/detail/hold.hpp"
#include "tautline/detail/limits.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"

// Everything is a template on the kind of case: one text serves doubles, for the answers, and
// numbers of any length, which say how far those answers are right (instantiate.hpp).
//
// Three members of `Motion` say how the cables stand. `touching_` are the cables at zero gap, which
// may close, rest or open, and the rate that counts as rest. `taut_` are those of them that a
// recorded event has made taut; after an impact it may be out of date until `hold_resting`.
// `held_` is the motion that their tensions give from the present on, a Taylor series in time: the
// cables `pulling` have tensions > 0, all of `held_->taut()` stay at zero gap. It is found after an
// event and continued from step to step, where a series ends and nothing happens. Without it the
// body flies freely.
//
// What exists for speed alone is behind `shortcuts_`, which the loop asks whether a single bounce
// is all that happens next, and whether the motion goes on as it does for ever. `solve_batch` finds
// the bounces of several motions side by side, and so asks each for its rounds.

namespace tautline {
namespace {

/// The motion so far: where it is now, and what has been recorded.
template <class TheCase>
class Motion final : public PausedMotion<TheCase> {
 public:
  using Real = RealOf<TheCase>;
  using Bounce = typename Shortcuts<TheCase>::Bounce;
  using Search = typename Shortcuts<TheCase>::Search;

  /// `touching` are the cables at zero gap; `record` is empty, and its memory is used.
  Motion(const TheCase& the_case, const SolveOptions& options, CableSet touching,
         Record<TheCase> record = {})
      : PausedMotion<TheCase>(the_case, options),
        case_(the_case),
        options_(options),
        state_(the_case.initial),
        attempts_(the_case.cables.size(), options.completion),
        record_(std::move(record)) {
    touching_.cables = touching;
    touching_.note_speed(case_, state_);
    if constexpr (TheCase::has_several_bodies) {
      state_ = with_zones(case_, std::move(state_));
    }
    check_limits();
  }

  /// The whole algorithm: round after round, until an ending.
  BasicSolution<TheCase> run() {
    while (!has_ended()) {
      round(may_bounce() ? shortcuts_.bounce(search()) : Bounce{});
    }
    return solution();
  }

  /// One round: what the cables do now, then on to the next stop and what happens there. A single
  /// `bounce` may be all of that.
  void round(const Bounce& bounce) override {
    if (bounce.is_all) {
      take(bounce);
      return check_limits();
    }
    const auto [closing, resting] = contacts(case_, state_, touching_);
    Stop<Real> stop{Real(0), std::nullopt, closing};  // closing from the start, or again: hit now
    if (closing.empty()) {
      if (complete_accumulation() == Attempt::in_vain && resting.empty() && may_bounce()) {
        return;  // it is not due again at once: look for a bounce now
      }
      if (!hold_resting()) {
        return finish(Ending::singular);
      }
      if (const auto ending = nothing_follows()) {
        return finish(*ending);
      }
      stop = next_stop(case_, state_, touching_, held_, now().remaining);
      if constexpr (TheCase::has_several_bodies) {
        if (const auto dt = find_switch(stop.dt)) {
          stop = {*dt, std::nullopt, {}};
        }
      }
    }
    const CableSet pulled = pulling();  // before `move` goes on
    if (const auto ending = move(stop)) {
      return finish(*ending);
    }
    if ((ending_ = shortcuts_.forever(now(), stop, pulled, record_))) {
      return;  // the record has its end
    }
    if (const auto ending = stop.ending || stop.cables.empty() ? stop.ending : hit()) {
      return finish(*ending);
    }
    check_limits();
  }

  [[nodiscard]] bool has_ended() const override { return ending_.has_value(); }

  [[nodiscard]] bool may_bounce() override { return shortcuts_.may_bounce(now(), attempts_); }

  [[nodiscard]] Search search() const override { return shortcuts_.search(now(), attempts_); }

  [[nodiscard]] BasicSolution<TheCase> solution() override {
    return record_.solution(case_, *ending_);
  }

 private:
  using PausedMotion<TheCase>::shortcuts_;

  /// The present.
  [[nodiscard]] Present<TheCase> now() const {
    return {case_, state_, touching_, taut_, held_, case_.duration - time_};
  }

  /// The flight to `bounce`, and its impact.
  void take(const Bounce& bounce) {
    const Landing<TheCase> landing = shortcuts_.land(bounce, touching_.cables);
    attempts_.set_tried(landing.cable, landing.tried);
    record_.arcs.push_back({time_, time_ + landing.dt, state_, {}, {}});
    time_ += landing.dt;
    state_ = landing.before;
    touching_ = landing.touching;
    touching_.time_rounding = epsilon<Real>() * time_;
    record(EventKind::impact, touching_.cables,
           BasicCableVector<Real>::Constant(1, landing.impulse), landing.after);
    progress_.note_hit(touching_.cables);
  }

  /// Ends the motion where it has taken too long.
  void check_limits() {
    if (const auto ending = limit_reached()) {
      finish(*ending);
    } else if (const auto chattering = progress_.stands_still(time_);
               chattering && !stop_chatter(*chattering)) {
      finish(Ending::no_progress);
    }
  }

  /// The ending where the body rests, or is certain to swing on for ever (`hold_resting` has
  /// asked).
  [[nodiscard]] std::optional<Ending> nothing_follows() const {
    const auto ending = rest(case_, state_, touching_, taut_, held_);
    return !ending && record_.swing ? std::optional(Ending::locked) : ending;
  }

  /// The cables that have tensions now.
  [[nodiscard]] CableSet pulling() const { return held_ ? held_->pulling : CableSet{}; }

  /// The limit that the motion has reached, if any.
  [[nodiscard]] std::optional<Ending> limit_reached() const {
    if (record_.events.size() >= options_.max_events) {
      return Ending::event_limit;
    }
    if (steps_ + spring_steps_ / springs_per_step >= options_.max_steps) {
      return Ending::step_limit;
    }
    return std::nullopt;
  }

  /// Ends the impacts on `cables` that follow each other within this instant, in one. False where
  /// they do not end, or time has stood still too often.
  [[nodiscard]] bool stop_chatter(CableSet cables) {
    const auto after = end_of_chatter(case_, state_, cables);
    if (!after || progress_.is_hopeless()) {
      return false;
    }
    record(EventKind::impact, cables, stopping_impulses(cables), *after);
    touching_.cables = touching_.cables | cables;
    shortcuts_.forget();
    held_.reset();
    return true;
  }

  /// The impulses that would stop the gaps of `cables`.
  [[nodiscard]] BasicCableVector<Real> stopping_impulses(CableSet cables) const {
    return -multipliers(case_, state_, cables, gap_rates(case_, state_, cables));
  }

  enum class Attempt { not_due, in_vain, done };

  /// The end of the bounces of the touching cables, where they accumulate.
  Attempt complete_accumulation() {
    const CableSet bouncing = touching_.cables - taut_;
    if (bouncing.empty() || !attempts_.are_due(case_, state_, touching_, bouncing)) {
      return Attempt::not_due;
    }
    const auto done = completion(case_, state_, touching_, options_.completion);
    if (!done) {
      attempts_.note(case_, state_, bouncing);
      return Attempt::in_vain;
    }
    Real energy_before = energy(case_, state_);
    const BasicCableVector<Real> impulses = stopping_impulses(done->cables);
    if constexpr (TheCase::has_several_bodies) {  // whose cables may be moved
      energy_before += work_of_impulses(case_, state_, done->cables, impulses);
    }
    record(EventKind::taut, done->cables, impulses, done->after);
    if (done->ends) {  // else an elastic cable goes on bouncing, too low to matter
      record_.accumulations.push_back({time_, time_ + done->remaining, done->uncertainty,
                                       done->cables, energy_before - energy(case_, state_)});
    }
    touching_.cables = touching_.cables | done->cables;
    taut_ = taut_ | done->cables;
    return Attempt::done;
  }

  /// Finds out which of the cables at zero gap and rate stay taut, and records what has changed.
  /// False where the motion has no continuation.
  [[nodiscard]] bool hold_resting() {
    if (held_) {
      return true;
    }
    const CableSet resting = contacts(case_, state_, touching_).resting;
    if (!TheCase::flies_in_closed_form || !resting.empty()) {
      held_ = hold(case_, state_, touching_, resting);
      if (!held_ && is_caught(case_, state_, touching_)) {
        state_ = standing_still(state_);
        held_ = hold(case_, state_, touching_, contacts(case_, state_, touching_).resting);
      }
      if (!held_ || is_singular(*held_, time_)) {
        return false;
      }
    }
    const CableSet taut = held_ ? held_->taut() : CableSet{};
    if (const CableSet lost = taut_ - taut; !lost.empty()) {
      record(EventKind::slack, lost, no_impulses<Real>(lost), state_);
    }
    if (const CableSet won = taut - taut_; !won.empty()) {
      const StateOf<TheCase> on_them = projected(case_, state_, taut);
      if (!fits(case_, on_them)) {  // the ends of a cable have met
        return false;
      }
      state_ = on_them;
      record(EventKind::taut, won, no_impulses<Real>(won), state_);
      if constexpr (!std::is_same_v<Real, double>) {
        // many digits see how far a start in doubles is off its cables: the motion is of the pose
        // on them, else each later arc would close a part of it
        held_ = hold(case_, state_, touching_, taut);
      }
    }
    taut_ = taut;
    record_.swing = shortcuts_.swing_ahead(now());
    return true;
  }

  /// Appends the arc up to `stop` and moves to its end. Without a state there: does nothing and
  /// returns the ending that says why.
  [[nodiscard]] std::optional<Ending> move(const Stop<Real>& stop) {
    if (isnan(stop.dt)) {
      return Ending::overflow;
    }
    BasicArc<TheCase> arc = arc_to(stop);
    const StateOf<TheCase> last = at_time(arc.after(stop.dt, case_.gravity), arc.end);
    if (!fits(case_, last)) {
      return Ending::overflow;
    }
    const CableSet held =  // a cable that is cut holds no longer
        stop.is_knot ? touching_at_knot(case_, last, pulling()) & pulling() : pulling();
    StateOf<TheCase> state = on_cables(case_, last, held, stop.cables, !stop.is_knot);
    if (!(pulling() | stop.cables).empty() && !fits(case_, state)) {
      return Ending::singular;  // the ends of a cable have met: it has no direction
    }
    record_.arcs.push_back(std::move(arc));
    arrive(stop, std::move(state));
    if constexpr (!TheCase::flies_in_closed_form) {
      return stop.is_knot ? ending_at_knot(case_, state_) : std::nullopt;
    }
    return std::nullopt;
  }

  /// The motion from here up to `stop`.
  [[nodiscard]] BasicArc<TheCase> arc_to(const Stop<Real>& stop) const {
    const Real end = stop.ending == Ending::reached_duration ? case_.duration
                     : stop.is_knot                          ? next_knot(case_, state_)
                                                             : Real(time_ + stop.dt);
    BasicArc<TheCase> arc{time_, end, state_, held_ ? taut_ : CableSet{}, {}};
    if (TheCase::flies_in_closed_form ? !pulling().empty() : held_.has_value()) {  // else none
      arc.series = held_->motion.pose();
    }
    return arc;
  }

  /// Makes the end of the last arc, where the body is in `state`, the present.
  void arrive(const Stop<Real>& stop, StateOf<TheCase> state) {
    time_ = record_.arcs.back().end;
    state_ = std::move(state);
    // once time has passed, only what is taut and what was hit is at zero gap
    touching_.cables = taut_ | (stop.dt > 0 ? stop.cables : touching_.cables | stop.cables);
    if (stop.is_knot) {
      touching_.cables = touching_at_knot(case_, state_, touching_.cables);
    }
    touching_.time_rounding = epsilon<Real>() * time_;
    touching_.note_speed(case_, state_);
    if constexpr (TheCase::has_several_bodies) {
      switch_elastic(stop);
    }
    steps_ += stop.cables.empty() ? 1U : 0U;
    // a step is only made in a hold; one without cables is free flight from now on
    const bool goes_on = stop.is_step && (!TheCase::flies_in_closed_form || !held_->taut().empty());
    held_ = goes_on ? continued(case_, state_, touching_, *held_) : std::nullopt;
    if (held_ && is_singular(*held_, time_)) {
      held_.reset();  // `hold_resting` looks again, and ends the motion if it is so
    }
  }

  /// Looks for the first switch of an elastic cable before `until` [s], and returns when it is [s].
  [[nodiscard]] std::optional<Real> find_switch(const Real& until) {
    const auto first = first_switch(case_, state_, held_->motion, touching_.at_zero, until);
    if (!first) {
      return std::nullopt;
    }
    touching_.switches = first->switches;
    return first->dt;
  }

  /// Lets elastic cables change their zones where the motion has arrived at `stop`: without a jump.
  void switch_elastic(const Stop<Real>& stop) {
    const auto switches = std::exchange(touching_.switches, {});
    if (stop.dt > 0) {
      touching_.at_zero = {};
    }
    if (stop.is_knot || !switches.empty()) {
      StateOf<TheCase> after = switched(case_, state_, switches);
      touching_.at_zero = zeros_after(case_, touching_.at_zero, switches, state_, after);
      enter(stop.is_knot ? with_zones(case_, std::move(after)) : std::move(after));
    }
  }

  /// Goes on in `after`, the present with other zones, and records what engages and lets go.
  void enter(StateOf<TheCase> after) {
    const CableSet before = state_.elastic.engaged;
    const CableSet engaged = after.elastic.engaged;
    if (const CableSet left = before - engaged; !left.empty()) {
      record(EventKind::exit, left, no_impulses<Real>(left), after);
    }
    if (const CableSet entered = engaged - before; !entered.empty()) {
      record(EventKind::entry, entered, no_impulses<Real>(entered), after);
    }
    state_ = std::move(after);
  }

  /// Resolves the impact of the touching cables that close or rest; one that grazes is left alone.
  /// Where the rebound cannot be computed, nothing is done: the ending says why.
  [[nodiscard]] std::optional<Ending> hit() {
    const auto [closing, resting] = contacts(case_, state_, touching_);
    const CableSet cables = closing | resting;
    if (cables.empty()) {
      ++steps_;  // or a body that grazes again and again would never come to a limit
      return std::nullopt;
    }
    BasicImpact<TheCase> impact = resolve_impact(options_.law, case_, state_, cables);
    if (!fits(case_, impact.after) || !impact.impulses.allFinite()) {
      const bool fitted = delassus(case_, state_, cables).allFinite() &&
                          gap_rates(case_, state_, cables).allFinite();
      return fitted && impact.impulses.hasNaN() ? Ending::singular : Ending::overflow;
    }
    spring_steps_ += static_cast<std::size_t>(impact.steps);
    record(EventKind::impact, cables, std::move(impact.impulses), impact.after);
    progress_.note_hit(closing);
    return std::nullopt;
  }

  /// Appends an event that takes the present state to `after`.
  void record(EventKind kind, CableSet cables, BasicCableVector<Real> impulses,
              StateOf<TheCase> after) {
    const bool jumps = TheCase::has_several_bodies && !impulses.isZero(0);
    record_.events.push_back({time_, kind, cables, std::move(impulses), state_, after});
    state_ = std::move(after);
    if constexpr (TheCase::has_several_bodies) {
      if (jumps) {
        touching_.at_zero = {};
        if (!state_.elastic.stretched().empty()) {  // their tensions have jumped, too
          enter(with_zones(case_, state_));
        }
      }
    }
  }

  /// Ends the motion here, with an arc that says so unless its duration is over.
  void finish(Ending ending) {
    ending_ = ending;
    if (ending == Ending::rest || ending == Ending::unstable_rest) {
      state_ = resting(case_, state_, taut_);
      record_.arcs.push_back(resting_arc<TheCase>(time_, case_.duration, state_, taut_));
    } else if (ending != Ending::reached_duration) {
      const CableSet taut = taut_ & contacts(case_, state_, touching_).resting;
      record_.arcs.push_back({time_, time_, state_, taut, {}});
    }
  }

  const TheCase& case_;
  const SolveOptions& options_;
  Real time_ = Real(0);
  StateOf<TheCase> state_;
  TouchingOf<TheCase> touching_;
  std::size_t steps_ = 0;         // stops without an impact, and grazes
  std::size_t spring_steps_ = 0;  // within impacts
  Progress<Real> progress_;
  Attempts<TheCase> attempts_;
  CableSet taut_;                           // as far as recorded
  std::optional<BasicHold<TheCase>> held_;  // the motion from here; none: free flight
  Record<TheCase> record_;
  std::optional<Ending> ending_;
};

}  // namespace

template <class TheCase>
BasicSolution<TheCase> solve(const TheCase& the_case, const SolveOptions& options) {
  if (const auto broken = problems(in_double(the_case)); !broken.empty()) {
    throw std::invalid_argument(broken.front());
  }
  if constexpr (TheCase::has_several_bodies) {
    if (const auto why = refusal(the_case, options.law)) {
      throw std::invalid_argument(*why);
    }
  }
  const CableSet touching = touching_at_start(the_case);
  const auto origin = local_origin(the_case);
  if (origin.isZero(0)) {  // else it is seen from near by, where numbers lose nothing
    return Motion<TheCase>(the_case, options, touching).run();
  }
  const TheCase near = seen_from(origin, the_case);
  return seen_from(VectorOf<TheCase>(-origin), Motion<TheCase>(near, options, touching).run(),
                   the_case);
}

template BasicSolution<InstanceCase> solve(const InstanceCase&, const SolveOptions&);

#ifdef TAUTLINE_FIRST
std::unique_ptr<PausedMotion<Case>> paused_motion(const Case& the_case, const SolveOptions& options,
                                                  CableSet touching, Record<Case> record) {
  return std::make_unique<Motion<Case>>(the_case, options, touching, std::move(record));
}
#endif

}  // namespace tautline
