#include "tautline/event_driver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "loop/standing.hpp"
#include "system/kernel.hpp"
#include "taut_step.hpp"
#include "tautline/clock.hpp"
#include "tautline/detail/accumulation.hpp"
#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/hold.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline {
namespace {

/// A step with more strikes than this is given up, and so is one with more contacts in a row that
/// are no impact [-]. From 1 m/s down to the capture speed with restitution 0.99 takes 1400.
constexpr std::size_t most_strikes = 10'000;

/// After this many moves in a row without an impact that rounding does not hide [-], moves double
/// in length with every few more: rounding may foretell one event after the other at the same
/// instant.
constexpr std::size_t patient_moves = 100;
constexpr double moves_to_double = 10.0;

/// After this many impacts in one step [-] a cable does not rebound if its gap would open by no
/// more than rounding: several cables may pass such bounces to each other without end.
constexpr std::size_t patient_impacts = 100;

/// A swing to a foretold release is no shorter than this part of what is left of the step, so that
/// the tension is past zero then [-].
constexpr double shortest_swing = 1e-9;

/// Corrections of the length of a swing that ends with a contact: Newton's method from a good
/// guess.
constexpr int most_corrections = 10;

/// The end of such a swing is known to this part of the step [-].
constexpr double contact_rounding = 1e-14;

std::string more_than_most(const std::string& what) {
  return "more than " + std::to_string(most_strikes) + " " + what;
}

std::string said_at(const std::string& what, double time) {
  char buffer[32];  // longer than any %.9g
  (void)std::snprintf(buffer, sizeof(buffer), "%.9g", time);
  return what + " at t = " + buffer;
}

template <class TheCase>
class EventDriven final : public BasicSimulation<TheCase>, public TensionImpulses {
 public:
  using State = StateOf<TheCase>;
  using Event = BasicEvent<TheCase>;
  using Adapter = BasicEventAdapter<TheCase>;

  EventDriven(const TheCase& the_case, std::unique_ptr<Adapter> adapter, ImpactLaw law)
      : case_(the_case),
        adapter_(std::move(adapter)),
        law_(law),
        rounding_(adapter_->rounding()),
        impulses_(the_case.cables.size()),
        tension_impulses_(the_case.cables.size()) {
    // what is completed at once is shorter than the square of that; a rebound near the engine's
    // rounding would be told from none by chance
    completion_.speed = std::sqrt(rounding_.rate);
    touching_ = touching_at_start(case_);
  }

  [[nodiscard]] State state() const override { return adapter_->state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::span<const double> tension_impulses() const override {
    return tension_impulses_;
  }
  [[nodiscard]] std::span<const Event> events() const override { return events_; }
  [[nodiscard]] std::optional<StopOfRun> stopped() const override { return stop_; }

  /// Flight or swing, strike, and again, until the step is over.
  void step(double dt) override {
    std::fill(impulses_.begin(), impulses_.end(), 0.0);
    std::fill(tension_impulses_.begin(), tension_impulses_.end(), 0.0);
    events_.clear();
    double rest = dt;
    idle_ = 0;
    while (rest > 0.0 && !stop_) {
      const double time = clock_.now() + (dt - rest);
      complete_accumulation();
      hold_resting(time);
      give_up(time);
      if (stop_) {
        break;
      }
      const auto [knot, to_knot] = next_knot_from_here();
      const double before_knot = to_knot - rounding_of_time(time);
      const double until = std::min(rest, before_knot);
      const double gone = !(until > 0.0) ? 0.0
                          : swings()     ? swing_to_event(until, time)
                                         : fly_to_contact(until, time);
      rest -= gone;
      if (gone >= before_knot) {
        pass_knot(knot);
      }
      idle_ = strike(clock_.now() + (dt - rest)) ? 0 : idle_ + 1;
    }
    clock_.advance(dt);
  }

 private:
  void stop(const std::string& why, double time) { stop_ = StopOfRun{time, said_at(why, time)}; }

  [[nodiscard]] TouchingOf<TheCase> touching(const State& state) const {
    TouchingOf<TheCase> result;
    result.cables = touching_;
    result.rate_rounding = std::max(rate_rounding_, rounding_.rate * speed_scale(case_, state));
    return result;
  }

  /// Bodies of a system may be stopped within an instant: rounding of their rates is then of the
  /// speeds before.
  void note_speed(const State& state) {
    if constexpr (TheCase::has_several_bodies) {
      rate_rounding_ = touching(state).rate_rounding;
    }
  }

  /// Stops where the step has used up what it may. That says nothing about accumulation: an elastic
  /// ball needs no more than a long step.
  void give_up(double time) {
    if (events_.size() > most_strikes) {
      stop(more_than_most("impacts in one step"), time);
    } else if (idle_ > most_strikes) {
      stop(more_than_most("moves in a row without an impact"), time);
    }
  }

  /// Where the bounces of the touching cables accumulate, their end.
  void complete_accumulation() {
    if (touching_ == taut_) {
      return;  // nothing bounces
    }
    const State now = adapter_->state();
    if (const auto done = completion(case_, now, touching(now), completion_)) {
      adapter_->place(done->after);
      touching_ = touching_ | done->cables;
      taut_ = taut_ | done->cables;
    }
  }

  /// Finds out which of the cables at zero gap and rate stay taut.
  void hold_resting(double time) {
    const State now = adapter_->state();
    const TouchingOf<TheCase> contacts = touching(now);
    CableSet resting = taut_;
    for (const std::size_t index : touching_ - taut_) {
      if (std::abs(gap_rate(case_.cables[index], now)) <= contacts.rate_rounding) {
        resting.insert(index);
      }
    }
    held_.reset();
    if (!resting.empty() || !TheCase::flies_in_closed_form) {
      held_ = hold(case_, now, contacts, resting);
      if (!held_) {
        return stop("no motion holds the taut cables", time);
      }
      let_go(now, resting - held_->taut());
    }
    taut_ = held_ ? held_->taut() : CableSet{};
  }

  /// Cables that are let go at zero gap and rate, though by rounding they neither pull nor open, go
  /// by their acceleration, or if that is rounding by the derivative after it. What rounding leaves
  /// of the others would bring them back at once, and so for ever.
  void let_go(const State& state, CableSet cables) {
    const double rounding = rounding_.rate * acceleration_scale(case_, state);
    for (const std::size_t index : cables) {
      std::size_t& zeros = held_->zeros[index];
      const bool is_rounding = 2.0 * std::abs(held_->motion.gap(index)[2]) <= rounding;
      if (zeros < 2) {
        zeros = is_rounding ? 3 : 2;
      }
    }
  }

  /// When something given over time is not smooth next, and how long until then [s]; never in the
  /// plane, where the engine is not asked for its state.
  [[nodiscard]] std::pair<double, double> next_knot_from_here() const {
    if constexpr (TheCase::has_several_bodies) {
      const State now = adapter_->state();
      return {next_knot(case_, now), time_to_knot(case_, now)};
    } else {
      return {infinity<double>(), infinity<double>()};
    }
  }

  /// A move ends so much before a knot [s]: at it, a cable that is cut would hold no longer.
  [[nodiscard]] static double rounding_of_time(double time) {
    return few_roundings * epsilon<double>() * std::max(1.0, time);
  }

  /// Something given over time is not smooth here: cables are cut, hooked up, or pulled otherwise.
  void pass_knot(double knot) {
    const State before = adapter_->state();
    const State now = at_time(before, knot);
    adapter_->place(now);  // not a rounding before it
    touching_ = touching_at_knot(case_, now, touching_);
    taut_ = taut_ & touching_;
    const double rounding = touching(now).rate_rounding;
    for (const std::size_t index : taut_.indices()) {
      const auto& cable = case_.cables[index];
      // a winch that stops or starts lets a taut cable go, or strikes it
      if (std::abs(gap_rate(cable, now) - gap_rate(cable, before)) > rounding) {
        taut_ = taut_ - CableSet::of(index);
      }
    }
  }

  [[nodiscard]] bool swings() const { return held_ && !held_->pulling.empty(); }

  /// Flies to the first contact, at most `rest` [s], and returns how long that took. Leaves in
  /// `touching_` the cables in contact there: what is known to touch holds for one instant only.
  double fly_to_contact(double rest, double time) {
    auto [dt, contact] = first_on_flight(rest);
    if (std::isnan(dt)) {
      stop("numbers overflow", time);
      return rest;
    }
    if (idle_ > patient_moves) {
      dt = std::clamp(dt, shortest_move(adapter_->state(), rest), rest);
    }
    const auto fly = [this](double length) {
      adapter_->fly(length);
      return true;
    };
    if (!(dt > 0.0)) {
      touching_ = touching_ | contact;
      return dt;
    }
    double flown = dt;
    CableSet reached = contact;
    if constexpr (TheCase::flies_in_closed_form) {
      (void)fly(dt);
    } else {
      std::tie(flown, reached) = go_to_contact(dt, contact, rest, fly);
    }
    touching_ = taut_ | reached;  // and those that follow without a tension
    return flown;
  }

  /// The first contact of a flight, at most `rest` [s]. A cable that is let go opens with its third
  /// derivative: what rounding leaves of the others would bring it back at once, and so for ever.
  [[nodiscard]] BasicFirstContact<double> first_on_flight(double rest) const {
    if constexpr (TheCase::flies_in_closed_form) {
      if (!held_) {
        const State start = adapter_->state();
        const auto contact = first_contact(case_, start, touching(start), rest).contact;
        return contact ? BasicFirstContact<double>{contact->dt, contact->cables}
                       : BasicFirstContact<double>{rest, {}};
      }
    }
    return first_change(case_, *held_, rest);
  }

  /// Goes `dt` [s] by `go`, and from the start again until the engine's own motion ends with the
  /// `contact` that the exact one foretells but for the error of its step, at most `rest` [s].
  /// Returns how long that took, and with which cables. `go` says whether it could.
  template <class Go>
  [[nodiscard]] std::pair<double, CableSet> go_to_contact(double dt, CableSet contact, double rest,
                                                          const Go& go) {
    const State start = adapter_->state();
    const double shortest = idle_ > patient_moves ? shortest_move(start, rest) : 0.0;
    bool gone = go(dt);
    for (int pass = 0; gone && pass < most_corrections; ++pass) {
      const auto [correction, cables] = late_by(contact);
      const bool near = std::abs(correction) <= contact_rounding * rest;
      contact = cables;
      const bool from_the_start = !(dt - correction > shortest);
      if (cables.empty() || near || from_the_start || dt - correction > rest) {
        contact = near || from_the_start ? cables : CableSet{};
        break;
      }
      dt -= correction;
      adapter_->place(start);
      gone = go(dt);
    }
    return {dt, contact};
  }

  /// Moves on taut cables to the first contact or release, at most `rest` [s], and returns how long
  /// that took.
  double swing_to_event(double rest, double time) {
    const State start = adapter_->state();
    auto [dt, contact] = first_change(case_, *held_, rest);
    if (std::isnan(dt)) {
      stop("numbers overflow", time);
      return rest;
    }
    dt = std::clamp(dt, shortest_move(start, rest), rest);
    std::optional<CableVector> pulled;
    std::tie(dt, contact) = go_to_contact(dt, contact, rest, [&](double length) {
      pulled = taut_step(case_, *adapter_, held_->pulling, length);
      return pulled.has_value();
    });
    if (!pulled) {
      stop("no impulses hold the taut cables", time);
      return dt;
    }
    Eigen::Index row = 0;
    for (const std::size_t index : held_->pulling) {
      tension_impulses_[index] += (*pulled)[row++];
    }
    touching_ = taut_ | contact;
    return dt;
  }

  /// The shortest swing to a foretold release, at most `rest` [s]: in less the velocity would not
  /// change by more than the engine rounds, and the tension might stay what it is for ever. Moves
  /// that lead to no impact grow.
  [[nodiscard]] double shortest_move(const State& start, double rest) const {
    const double rounding = rounding_.rate * speed_scale(case_, start);
    const double shortest =
        std::max(shortest_swing * rest, rounding / acceleration_scale(case_, start));
    const double doublings =
        idle_ > patient_moves ? static_cast<double>(idle_ - patient_moves) / moves_to_double : 0.0;
    return std::min(rest, shortest * std::exp2(doublings));
  }

  /// By how long the end of a swing is too late [s] for the contact of `expected`, or of the slack
  /// cables that are overstretched there, and with which cable.
  [[nodiscard]] std::pair<double, CableSet> late_by(CableSet expected) const {
    const State now = adapter_->state();
    std::pair<double, CableSet> latest{0.0, expected};
    bool found = false;
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const auto& cable = case_.cables[index];
      const double opening = gap(cable, now);
      const bool over = !taut_.contains(index) && opening < -rounding_.gap * gap_scale(cable, now);
      const double rate = gap_rate(cable, now);
      if ((over || expected.contains(index)) && rate < 0.0) {
        const double late = opening / rate;
        if (!found || late > latest.first) {
          latest = {late, CableSet::of(index)};
          found = true;
        }
      }
    }
    return found ? latest : std::pair<double, CableSet>{0.0, CableSet{}};
  }

  /// Strikes the touching cables that close or rest, if one of them closes by more than rounding.
  /// True if such a bounce is seen.
  bool strike(double time) {
    const State before = adapter_->state();
    note_speed(before);
    const double rounding = touching(before).rate_rounding;
    CableSet cables;
    double fastest = 0.0;  // closing
    bool seen = false;
    for (const std::size_t index : touching_) {
      const double rate = gap_rate(case_.cables[index], before);
      if (rate <= rounding) {
        cables.insert(index);
        fastest = std::max(fastest, taut_.contains(index) ? 0.0 : -rate);
        seen = seen || !is_unseen(case_.cables[index], before, std::max(0.0, -rate));
      }
    }
    if (fastest <= rounding) {
      return false;
    }
    CableVector impulses =
        law_ == ImpactLaw::sequential ? strike_in_turn(cables, rounding) : strike_at_once(cables);
    Eigen::Index row = 0;
    for (const std::size_t index : cables) {
      impulses_[index] += impulses[row++];
    }
    taut_ = {};  // what the impact leaves at rest is looked for again
    events_.push_back(
        {time, EventKind::impact, cables, std::move(impulses), before, adapter_->state()});
    return seen;
  }

  CableVector strike_at_once(CableSet cables) {
    const State now = adapter_->state();
    CableVector rates(static_cast<Eigen::Index>(cables.size()));
    Eigen::Index row = 0;
    for (const std::size_t index : cables) {
      const double rate = gap_rate(case_.cables[index], now);
      const double rebound = restitution(case_.cables[index], rate) * std::max(0.0, -rate);
      const bool goes_on = events_.size() > patient_impacts;
      rates[row++] = goes_on && is_unseen(case_.cables[index], now, rebound) ? 0.0 : rebound;
    }
    return adapter_->solve(cables, rates);
  }

  /// True if a rebound at `speed` [m/s] opens the gap by no more than rounding.
  template <class Cable>
  [[nodiscard]] bool is_unseen(const Cable& cable, const State& now, double speed) const {
    return speed * speed <=
           2.0 * acceleration_scale(case_, now) * rounding_.gap * gap_scale(cable, now);
  }

  /// The cable that closes fastest by itself, until none closes by more than `rounding` [m/s].
  CableVector strike_in_turn(CableSet cables, double rounding) {
    CableVector impulses = CableVector::Zero(static_cast<Eigen::Index>(cables.size()));
    const std::vector<std::size_t> indices = cables.indices();
    for (std::size_t strikes = 0; strikes < most_strikes; ++strikes) {
      Eigen::Index fastest = 0;
      if (!(gap_rates(case_, adapter_->state(), cables).minCoeff(&fastest) < -rounding)) {
        break;
      }
      const CableSet one = CableSet::of(indices[static_cast<std::size_t>(fastest)]);
      impulses[fastest] += strike_at_once(one)[0];
    }
    return impulses;
  }

  const TheCase case_;
  std::unique_ptr<Adapter> adapter_;
  ImpactLaw law_;
  typename Adapter::Rounding rounding_;
  CompletionLimits completion_;
  Clock clock_;
  double rate_rounding_ = 0.0;  // [m/s], at least
  CableSet touching_;           // at zero gap now
  CableSet taut_;               // of those, the ones that stay so
  std::optional<BasicHold<TheCase>>
      held_;              // the exact motion from here while cables pull, or as they let go
  std::size_t idle_ = 0;  // moves of the step since a bounce was seen
  std::vector<double> impulses_;
  std::vector<double> tension_impulses_;
  std::vector<Event> events_;
  std::optional<StopOfRun> stop_;
};

}  // namespace

template <class TheCase>
std::unique_ptr<BasicSimulation<TheCase>> drive_by_events(
    const TheCase& the_case,
    std::type_identity_t<std::unique_ptr<BasicEventAdapter<TheCase>>> adapter, ImpactLaw law) {
  if (law != ImpactLaw::simultaneous && law != ImpactLaw::sequential) {
    throw std::invalid_argument(
        "unsupported: the event driver has the impact laws simultaneous "
        "and sequential, not " +
        std::string(to_string(law)));
  }
  refuse_elastic("the event driver", the_case);
  return std::make_unique<EventDriven<TheCase>>(the_case, std::move(adapter), law);
}

template std::unique_ptr<Simulation> drive_by_events(const Case&, std::unique_ptr<EventAdapter>,
                                                     ImpactLaw);
template std::unique_ptr<SystemSimulation> drive_by_events(const SpatialSystem&,
                                                           std::unique_ptr<SystemEventAdapter>,
                                                           ImpactLaw);

}  // namespace tautline
