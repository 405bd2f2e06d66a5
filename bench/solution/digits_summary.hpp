#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bench/solution/cable_words.hpp"
#include "bench/solution/ending_words.hpp"
#include "bench/solution/right_digits.hpp"
#include "tautline/detail/ledger.hpp"
#include "tautline/geometry.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

// How a motion ends and settles in plain words, of which each number has right digits alone.

/// Bounds of the errors of the numbers of a summary; < 0 where nothing is right.
template <class Real>
struct SummaryErrors {
  Real end_time = Real(-1);        // [s]
  std::vector<Real> last_impacts;  // [s]
  Real lock = Real(-1);            // [s]
  Real energy = Real(-1);          // [J], at the end
  Real amplitude = Real(-1);       // [rad]
  Real period = Real(-1);          // [s]
};

/// At most so many digits.
struct Figures {
  int after_point = 6;  // of times
  int significant = 6;  // of other numbers
};

template <class Real>
class Summary {
 public:
  Summary(const BasicCase<Real>& the_case, const BasicSolution<BasicCase<Real>>& solution,
          const BasicSettling<Real>& settling, SummaryErrors<Real> errors, Figures figures)
      : case_(the_case),
        solution_(solution),
        settling_(settling),
        errors_(std::move(errors)),
        figures_(figures) {}

  /// A few lines, each with an end.
  [[nodiscard]] std::string text() const {
    std::string result = ending_sentence() + "\n";
    if (!solution_.events().empty()) {
      result += last_impacts_sentence() + "\n";
    }
    if (!settling_.lock) {
      const CableSet taut = solution_.arcs().back().taut;
      result +=
          fmt::format("At the end {} {} taut.\n", taut.empty() ? "no cable" : cable_names(taut),
                      taut.size() > 1 ? "are" : "is");
    } else {
      result += lock_sentence(*settling_.lock) + "\n";
    }
    const bool swings = settling_.lock && settling_.lock->swing;
    return result + (swings ? swing_sentence(*settling_.lock->swing) : energy_sentence()) + "\n";
  }

 private:
  [[nodiscard]] std::string time(const Real& value, const Real& error, int more = 0) const {
    return in_words(figures_.significant > Figures{}.significant
                        ? right_general(value, error, figures_.significant)
                        : right_fixed(value, error, figures_.after_point + more),
                    value, error);
  }
  /// "t = 1.5", or that it is beyond the horizon.
  [[nodiscard]] std::string instant(const Real& value, const Real& error, int more) const {
    return error < Real(0) ? "an instant beyond the horizon" : "t = " + time(value, error, more);
  }
  [[nodiscard]] std::string number(const Real& value, const Real& error) const {
    return number_in_words(value, error, figures_.significant);
  }

  /// Since when the body is at rest: since the end of its bounces, if any are completed.
  [[nodiscard]] Real rest_time() const {
    return settling_.lock ? settling_.lock->time : solution_.arcs().back().start;
  }
  [[nodiscard]] std::string since_when() const {
    return instant(rest_time(), settling_.lock ? errors_.lock : errors_.end_time, 3);
  }

  [[nodiscard]] std::string resting_sentence() const {
    const std::string duration = shortest(static_cast<double>(case_.duration));
    if (rest_time() > case_.duration) {
      return fmt::format("The run reached its duration, t = {}, during the last bounces.",
                         duration);
    }
    if (solution_.arcs().back().initial.spin != Real(0)) {  // exactly
      return fmt::format(
          "The body hangs still at its centre from {} until the end, t = {}, and turns at a "
          "constant "
          "spin.",
          since_when(), duration);
    }
    return bench::ending_sentence(Ending::rest, 1, since_when(), duration, 0);
  }

  /// What an ending means, in a sentence.
  [[nodiscard]] std::string ending_sentence() const {
    const std::string end = instant(solution_.end_time(), errors_.end_time, 3);
    const auto number_of = [](const Real& value) { return shortest(static_cast<double>(value)); };
    switch (solution_.ending()) {
      case Ending::rest:
        return resting_sentence();
      case Ending::angle_limit:
        return fmt::format("|angle| reached the limit {} at {}.", number_of(*case_.angle_limit),
                           end);
      case Ending::ceiling:
        return fmt::format("An attachment reached the ceiling {} at {}.", number_of(*case_.ceiling),
                           end);
      default:
        return bench::ending_sentence(
            solution_.ending(), 1, solution_.ending() == Ending::unstable_rest ? since_when() : end,
            number_of(case_.duration), solution_.events().size());
    }
  }

  [[nodiscard]] std::string last_impacts_sentence() const {
    std::string result;
    for (std::size_t index = 0; index < settling_.last_impacts.size(); ++index) {
      const BasicLastImpact<Real>& last = settling_.last_impacts[index];
      const std::string when = !last.time ? "none"
                               : errors_.last_impacts.at(index) < Real(0)
                                   ? "beyond the horizon"
                                   : "t = " + time(*last.time, errors_.last_impacts[index]);
      result += fmt::format("{} faster than {:g}: {}", result.empty() ? "Last impact" : ";",
                            static_cast<double>(last.speed), when);
    }
    return result + ".";
  }

  /// When the final set of cables became taut, and whether they stay so.
  [[nodiscard]] std::string lock_sentence(const BasicLock<Real>& lock) const {
    std::string cables = cable_names(lock.cables);
    cables.front() = 'C';
    const bool one = lock.cables.size() == 1;
    std::string since = "an instant beyond the horizon";
    if (errors_.lock >= Real(0)) {
      const double error = static_cast<double>(errors_.lock);
      const bool wide = error > 0.5e-6 && figures_.significant == Figures{}.significant;
      // with an error after it the digit that the error is about is worth showing
      const int digits = wide ? std::max(0, static_cast<int>(std::ceil(-std::log10(error)))) : 0;
      since = "t = " + (wide ? fmt::format("{} ± {:.0e}", fixed_digits(lock.time, digits), error)
                             : time(lock.time, errors_.lock));
    }
    const auto stay = [&](const char* reason) {
      return fmt::format("{} {} taut from {} on: {}", cables, one ? "stays" : "stay", since,
                         reason);
    };
    if (lock.rests) {
      const bool turns = solution_.arcs().back().initial.spin != Real(0);  // exactly
      return stay(turns ? "the body hangs still and turns." : "the body is at rest.");
    }
    if (lock.permanent && errors_.energy >= Real(0)) {
      return stay(one ? "its tension stays positive over a full period."
                      : "their tensions stay positive over a full period.");
    }
    const std::string taut =
        fmt::format("{} {} taut from {} on.", cables, one ? "is" : "are", since);
    if (errors_.energy < Real(0)) {
      return taut;
    }
    const std::size_t freedoms = is_point_mass(case_) ? 2 : 3;
    const bool may_wander = lock.cables.size() + 1 < freedoms;
    return fmt::format(
        "{} How long {} taut was not determined: {}", taut, one ? "it stays" : "they stay",
        may_wander ? "more than one degree of freedom remains, so the motion need not repeat."
                   : "no full period without a release or a dead point was found.");
  }

  /// What is left of the initial energy, and the swing.
  [[nodiscard]] std::string swing_sentence(const BasicSwing<Real>& swing) const {
    if (swing.goes_round) {
      const std::string period =
          errors_.energy < Real(0) ? "" : " with period " + number(swing.period, errors_.period);
      return fmt::format("The body makes full turns{}. {}", period, energy_sentence());
    }
    const Real lowest = energy(case_, solution_.at(solution_.end_time())) - swing.energy;
    const Real start = energy(case_, case_.initial) - lowest;
    const Real rounding = 16 * epsilon<Real>() * (abs(start) + abs(lowest));
    if (errors_.energy < Real(0)) {
      return fmt::format(
          "The swing is beyond the horizon. Energy above equilibrium: {} at the start, at most "
          "that at "
          "the end.",
          number(start, rounding));
    }
    const std::string part =  // where there was next to none it is a part of nothing
        start > rounding
            ? right_fixed(Real(100 * swing.energy / start), Real(100 * errors_.energy / start), 2)
            : dash;
    const std::string what = swing.angle == SwingAngle::body
                                 ? "The body"
                                 : fmt::format("Cable {}", *settling_.lock->cables.begin());
    return fmt::format(
        "{} swings with amplitude {} rad and period {}. Energy above equilibrium: {} at the start, "
        "{} at the end{}.",
        what, number(swing.amplitude, errors_.amplitude), number(swing.period, errors_.period),
        number(start, rounding), number(swing.energy, errors_.energy),
        part == dash ? "" : fmt::format(" ({} %)", part));
  }

  /// What is left of the initial energy where there is no swing to measure it against.
  [[nodiscard]] std::string energy_sentence() const {
    const BasicEnergyLedger<Real> ledger = energy_ledger(case_, solution_);
    const Real rounding = 4 * epsilon<Real>() * abs(ledger.start);
    const std::string start = number(ledger.start, rounding);
    if (errors_.energy < Real(0)) {
      return fmt::format(
          "The energy at the start is {}. What impacts take of it is beyond the horizon.", start);
    }
    const Real lost = ledger.impacts + ledger.completions;
    const Real end = abs(ledger.end) <= rounding ? Real(0) : ledger.end;
    return fmt::format("Energy: {} at the start, {} at the end; impacts take {}.", start,
                       number(end, errors_.energy), number(lost, Real(errors_.energy + rounding)));
  }

  const BasicCase<Real>& case_;
  const BasicSolution<BasicCase<Real>>& solution_;
  const BasicSettling<Real>& settling_;
  SummaryErrors<Real> errors_;
  Figures figures_;
};

}  // namespace tautline::bench
