#include "tautline/event_driver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "tautline/accumulation.hpp"
#include "tautline/clock.hpp"
#include "tautline/first_contact.hpp"
#include "tautline/geometry.hpp"
#include "tautline/hold.hpp"

namespace tautline {
namespace {

/// Rounding of a gap rate against the speeds it comes from [-]. An engine in double keeps its pose
/// as a matrix or a quaternion and iterates for its impulses: about a hundred times the rounding of
/// the closed form.
constexpr double rate_rounding = 1e-12;

/// When an accumulation is over for this driver: its remaining rebounds are slower [m/s].
const CompletionLimits completion = {.speed = 1e-6};

/// A step with more strikes than this is given up, and so is one with more contacts in a row that
/// are no impact [-]. From 1 m/s down to the capture speed with restitution 0.99 takes 1400.
constexpr std::size_t most_strikes = 10'000;

std::string more_than_most(const std::string& what) {
  return "more than " + std::to_string(most_strikes) + " " + what;
}

std::string at_time(const std::string& what, double time) {
  char buffer[32];  // longer than any %.9g
  (void)std::snprintf(buffer, sizeof(buffer), "%.9g", time);
  return what + " at t = " + buffer;
}

class EventDriven final : public Simulation {
 public:
  EventDriven(const Case& the_case, std::unique_ptr<EventAdapter> adapter)
      : case_(the_case), adapter_(std::move(adapter)), impulses_(the_case.cables.size()) {
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const Cable& cable = case_.cables[index];
      if (gap(cable, case_.initial) <= gap_rounding * cable.length) {
        touching_.insert(index);
      }
    }
  }

  [[nodiscard]] State state() const override { return adapter_->state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }
  [[nodiscard]] std::span<const Event> events() const override { return events_; }
  [[nodiscard]] std::optional<Stop> stopped() const override { return stop_; }

  /// Flight, strike, flight, until the step is over.
  void step(double dt) override {
    std::fill(impulses_.begin(), impulses_.end(), 0.0);
    events_.clear();
    double rest = dt;
    std::size_t idle = 0;  // contacts since the latest strike
    while (rest > 0.0 && !stops_at(clock_.now() + (dt - rest), idle)) {
      rest -= fly_to_contact(rest);
      const std::size_t strikes = events_.size();
      strike(clock_.now() + (dt - rest));
      idle = events_.size() > strikes ? 0 : idle + 1;
    }
    clock_.advance(dt);
  }

 private:
  void stop(const std::string& why, double time) { stop_ = Stop{time, at_time(why, time)}; }

  [[nodiscard]] Touching touching(const State& state) const {
    return {touching_, rate_rounding * speed_scale(case_, state)};
  }

  /// Stops where the touching cables have no more than the end of their bounces before them, and
  /// where the step has used up what it may. The latter says nothing about accumulation: an elastic
  /// ball needs no more than a long step.
  bool stops_at(double time, std::size_t idle) {
    if (stop_) {
      return true;
    }
    const State now = adapter_->state();
    if (const auto bounces = capture(case_, now, touching(now), completion)) {
      stop("impacts accumulate", time);
    } else if (stays_taut(now)) {
      stop("cables stay taut", time);
    } else if (events_.size() > most_strikes) {
      stop(more_than_most("impacts in one step"), time);
    } else if (idle > most_strikes) {
      stop(more_than_most("contacts in a row without an impact"), time);
    }
    return stop_.has_value();
  }

  /// True where a touching cable rests at `state` and tension keeps it taut from now on.
  [[nodiscard]] bool stays_taut(const State& state) const {
    const Touching contacts = touching(state);
    CableSet resting;
    for (const std::size_t index : touching_) {
      if (std::abs(gap_rate(case_.cables[index], state)) <= contacts.rate_rounding) {
        resting.insert(index);
      }
    }
    if (resting.empty()) {
      return false;
    }
    const auto held = hold(case_, state, contacts, resting);
    return !held || !held->taut().empty();
  }

  /// Flies to the first contact, at most `rest` [s], and returns how long that took. Leaves in
  /// `touching_` the cables in contact there: what is known to touch holds for one instant only.
  double fly_to_contact(double rest) {
    const State start = adapter_->state();
    const auto contact = first_contact(case_, start, touching(start), rest).contact;
    const double dt = contact ? contact->dt : rest;
    if (dt > 0.0) {
      adapter_->fly(dt);
      touching_ = {};
    }
    touching_ = contact ? touching_ | contact->cables : touching_;
    return dt;
  }

  /// Strikes the touching cables that close or rest, if one of them closes by more than rounding.
  void strike(double time) {
    const State before = adapter_->state();
    const double rounding = touching(before).rate_rounding;
    CableSet cables;
    double fastest = 0.0;  // closing
    for (const std::size_t index : touching_) {
      const double rate = gap_rate(case_.cables[index], before);
      if (rate <= rounding) {
        cables.insert(index);
        fastest = std::max(fastest, -rate);
      }
    }
    if (fastest <= rounding) {
      return;
    }
    CableVector impulses = adapter_->strike(cables);
    Eigen::Index row = 0;
    for (const std::size_t index : cables) {
      impulses_[index] += impulses[row++];
    }
    events_.push_back(
        {time, EventKind::impact, cables, std::move(impulses), before, adapter_->state()});
  }

  const Case case_;
  std::unique_ptr<EventAdapter> adapter_;
  Clock clock_;
  CableSet touching_;  // at zero gap now
  std::vector<double> impulses_;
  std::vector<Event> events_;
  std::optional<Stop> stop_;
};

}  // namespace

std::unique_ptr<Simulation> drive_by_events(const Case& the_case,
                                            std::unique_ptr<EventAdapter> adapter) {
  return std::make_unique<EventDriven>(the_case, std::move(adapter));
}

}  // namespace tautline
