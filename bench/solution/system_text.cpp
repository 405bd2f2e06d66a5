#include "bench/solution/system_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/solution/cable_words.hpp"
#include "bench/solution/ending_words.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// Digits of a summary, after the point of a time and significant of another number.
constexpr int summary_time_digits = 6;
constexpr int summary_digits = 6;

/// Digits of a motion that is one of many: enough to see it.
constexpr int digits_of_one_motion = 3;

/// A summary of one motion.
template <int D>
class Sentences {
 public:
  explicit Sentences(const BasicCheckedMotion<D>& motion)
      : motion_(motion), settling_(motion.settling()), errors_(motion.settling_errors()) {}

  [[nodiscard]] std::string text() const {
    std::string result = stretched_starts() + ending() + "\n";
    if (has_impacts() && !motion_.solution().events().empty()) {
      result += last_impacts() + "\n";
    }
    for (std::size_t i = 0; i < settling_.cables.size(); ++i) {
      result += cable(i) + "\n";
    }
    if (settling_.lock) {
      result += lock(*settling_.lock) + "\n";
    }
    if (settling_.forced) {
      result += forced(*settling_.forced) + "\n";
    }
    return result + energy() + "\n" + sureness() + "\n";
  }

 private:
  /// True where a cable may have impacts; the contacts of an elastic one have a table of their own.
  [[nodiscard]] bool has_impacts() const {
    const auto& cables = motion_.system().cables;
    return !std::all_of(cables.begin(), cables.end(),
                        [](const auto& cable) { return is_elastic(cable); });
  }

  /// A number with its right digits; with a few and "about" where the motion is one of many.
  [[nodiscard]] static std::string number(double value, double error) {
    return error < 0.0 ? fmt::format("about {:.{}g}", value, digits_of_one_motion)
                       : number_in_words(value, error, summary_digits);
  }
  [[nodiscard]] static std::string time(double value, double error) {
    return "t = " + (error < 0.0
                         ? fmt::format("about {:.{}g}", value, digits_of_one_motion)
                         : in_words(right_fixed(value, error, summary_time_digits), value, error));
  }

  /// A part of the ledger; 0 where it is rounding of the others.
  [[nodiscard]] std::string part(double value, double error) const {
    constexpr double rounding = 1e-12;
    const bool none = std::abs(value) <= rounding * motion_.ledger().range;
    return none ? "0" : number(value, error);
  }
  /// When a largest value is first there; nothing where equal ones come again and again.
  [[nodiscard]] std::string when(double value, double error) const {
    constexpr double too_wide = 1e-3;  // [-], of the run
    return error > too_wide * motion_.solution().end_time() ? "" : " at " + time(value, error);
  }

  /// Which elastic cables are stretched at the start.
  [[nodiscard]] std::string stretched_starts() const {
    const auto& system = motion_.system();
    std::string result;
    for (std::size_t i = 0; i < system.cables.size(); ++i) {
      const auto& cable = system.cables[i];
      if (cable.elasticity && cable.acts_at(0.0) && gap(cable, system.initial) < 0.0) {
        result += fmt::format("Cable {} starts stretched by {:.{}g}.\n", i,
                              -gap(cable, system.initial), summary_digits);
      }
    }
    return result;
  }

  [[nodiscard]] std::string ending() const {
    const auto& solution = motion_.solution();
    const bool rests = solution.ending() == Ending::rest;
    const double since = rests ? solution.arcs().back().start : solution.end_time();
    const double error = motion_.horizon() ? -1.0 : std::max(errors_.lock, 0.0);
    if (const auto met = without_direction()) {
      const bool straight = motion_.system().cables[*met].through.empty();
      return fmt::format("Stopped at {}: {} of cable {} {}, and the cable has no direction there.",
                         time(since, error), straight ? "the ends" : "an end", *met,
                         straight ? "have met" : "is at a ring of it");
    }
    if (const auto culprits = asking_too_much(); !culprits.empty()) {
      const bool one = culprits.size() == 1;
      const bool hooked = is_hooked_up(*culprits.begin());
      return fmt::format("Stopped at {}: {} {} {}.", time(since, error), cable_names(culprits),
                         hooked ? (one ? "is" : "are") : (one ? "asks" : "ask"),
                         hooked ? "hooked up there, and too short for where the ends are"
                                : "for more than the bodies on taut cables can follow");
    }
    return ending_sentence(solution.ending(), motion_.system().bodies.size(), time(since, error),
                           shortest(motion_.system().duration), solution.events().size());
  }

  /// The cable on which two ends have met, where that ends the motion: it runs through rings, or
  /// resists while it is slack.
  [[nodiscard]] std::optional<std::size_t> without_direction() const {
    constexpr double met = 1e-9;  // [-], of the cable's length
    const auto& solution = motion_.solution();
    const auto state = solution.at(solution.end_time());
    std::optional<std::size_t> result;
    for (std::size_t i = 0;
         solution.ending() == Ending::singular && !result && i < motion_.system().cables.size();
         ++i) {
      const auto& cable = motion_.system().cables[i];
      const bool resists = cable.elasticity && cable.elasticity->cut == ElasticCut::never;
      each_segment(cable, state, [&](std::size_t, const auto& segment) {
        if (cable.acts_at(state.time) && (resists || !cable.through.empty()) &&
            segment.distance <= met * cable.length.at(state.time)[0]) {
          result = i;
        }
      });
    }
    return result;
  }

  [[nodiscard]] bool is_hooked_up(std::size_t index) const {
    return motion_.system().cables[index].from_time == motion_.solution().end_time();
  }

  /// Of a motion that cannot go on: the cables that are hooked up there, or else those at the end
  /// of their length that are given over time; empty where it is nothing of that kind.
  [[nodiscard]] CableSet asking_too_much() const {
    const auto& solution = motion_.solution();
    const double end = solution.end_time();
    const auto state = solution.at(end);
    CableSet hooked;
    CableSet given;
    for (std::size_t i = 0; i < motion_.system().cables.size(); ++i) {
      const auto& cable = motion_.system().cables[i];
      const bool is_given =
          !(cable.length.is_constant_from(end) && cable.from.motion.is_constant_from(end) &&
            cable.to.motion.is_constant_from(end));
      const double length = cable.length.at(end)[0];
      if (solution.ending() == Ending::singular && gap(cable, state) <= gap_rounding * length) {
        is_hooked_up(i) ? hooked.insert(i) : void();
        is_given ? given.insert(i) : void();
      }
    }
    return hooked.empty() ? given : hooked;
  }

  [[nodiscard]] std::string last_impacts() const {
    std::string result;
    for (std::size_t i = 0; i < settling_.last_impacts.size(); ++i) {
      const LastImpact& last = settling_.last_impacts[i];
      result +=
          fmt::format("{} faster than {:g}: {}", result.empty() ? "Last impact" : ";", last.speed,
                      last.time ? time(*last.time, errors_.last_impacts[i]) : "none");
    }
    return result + ".";
  }

  [[nodiscard]] std::string cable(std::size_t index) const {
    const CableUse& use = settling_.cables[index];
    std::string result = fmt::format("Cable {} is ", index);
    if (use.taut_share > 0.0) {
      const double error = errors_.shares[index];
      const bool pulls = use.tension && use.tension->value > std::abs(errors_.tensions[index]);
      result += fmt::format(
          "taut for {} % of the run, with {}", number(100.0 * use.taut_share, 100.0 * error),
          pulls ? fmt::format("a tension of at most {}{}",
                              number(use.tension->value, errors_.tensions[index]),
                              when(use.tension->time, errors_.tension_times[index]))
                : "no tension to speak of");
    } else {
      result += "slack";
    }
    if (use.impulse) {
      result += fmt::format("; its largest impulse is {}{}",
                            number(use.impulse->value, errors_.impulses[index]),
                            when(use.impulse->time, errors_.impulse_times[index]));
    }
    return result + ".";
  }

  [[nodiscard]] std::string lock(const SystemLock& lock) const {
    std::string cables = cable_names(lock.cables);
    cables.front() = 'C';
    const bool one = lock.cables.size() == 1;
    std::string result = fmt::format("{} {} taut from {} on{}.", cables,
                                     lock.certain ? (one ? "stays" : "stay") : (one ? "is" : "are"),
                                     time(lock.time, errors_.lock),
                                     lock.at_rest   ? ": all is at rest"
                                     : lock.certain ? ": the energy is too low to let go"
                                                    : ", as far as the run shows");
    if (lock.residual_energy && !lock.at_rest) {
      result += fmt::format(" Energy above the equilibrium at the end: {}.",
                            number(*lock.residual_energy, errors_.residual_energy));
    }
    if (lock.one_percent) {
      result += fmt::format(" By {} {} taken 99 % of the energy above the equilibrium at {}.",
                            time(*lock.one_percent, errors_.one_percent),
                            lock.ring_down ? "drag or dampers have" : "drag has",
                            time(lock.time, errors_.lock));
    }
    if (lock.ring_down) {
      result += fmt::format(
          " The swing of a stretch falls to 1/e within {}, on the slowest of these cables.",
          number(*lock.ring_down, errors_.ring_down));
    }
    return result;
  }

  [[nodiscard]] std::string forced(const ForcedMotion& forced) const {
    const std::string count = fmt::format("{:.3g}", forced.impacts);
    std::string result = fmt::format("The waves come again every {:.6g}", forced.period);
    if (has_impacts()) {
      result += fmt::format("; in a period {} {} impact{}", count == "1" ? "there is" : "there are",
                            count, count == "1" ? "" : "s");
    }
    result += forced.repeats
                  ? fmt::format(", and the motion repeats every {}.",
                                *forced.repeats == 1 ? "period"
                                                     : fmt::format("{} periods", *forced.repeats))
                  : fmt::format(", and no repetition is seen in the {:.3g} periods of the run.",
                                motion_.solution().end_time() / forced.period);
    return result;
  }

  [[nodiscard]] std::string energy() const {
    const SystemLedger& ledger = motion_.ledger();
    const SystemLedger errors = motion_.ledger_errors();
    if (!std::isfinite(ledger.work)) {  // on the way to a ring tensions grow without bound
      return "Kinetic energy: " + part(ledger.start, std::max(0.0, errors.start)) +
             " at the start; at the end it is beyond all bounds.";
    }
    const double lost = ledger.impacts + ledger.completions;
    const double error = errors.impacts < 0.0 ? -1.0 : errors.impacts + errors.completions;
    const std::string elastic = first_elastic(motion_.system())
                                    ? fmt::format(" Elastic cables lose {} and {} {}.",
                                                  part(ledger.dissipated, errors.dissipated),
                                                  ledger.stored < 0.0 ? "give back" : "store",
                                                  part(std::abs(ledger.stored), errors.stored))
                                    : "";
    return fmt::format(
               "Kinetic energy: {} at the start, {} at the end. Gravity, forces, drag and what "
               "moves ends and lengths give {}{}.",
               part(ledger.start, std::max(0.0, errors.start)), part(ledger.end, errors.end),
               part(ledger.work, errors.work),
               has_impacts() ? "; impacts take " + part(lost, error) : "") +
           elastic;
  }

  [[nodiscard]] std::string sureness() const {
    if (!motion_.is_checked()) {
      return "These digits are not checked: leave out --fast to compare them with a solution in 30 "
             "digits.";
    }
    if (!motion_.horizon()) {
      return fmt::format("All these digits are those of a solution in {} digits, too.",
                         motion_.digits());
    }
    return fmt::format(
        "From t = {:.6g} on the motion is beyond the horizon: this is one of many that start "
        "alike. "
        "What is said of the whole run is of this one.",
        *motion_.horizon());
  }

  const BasicCheckedMotion<D>& motion_;
  const SystemSettling& settling_;
  SystemSettlingErrors errors_;
};

}  // namespace

template <int D>
std::string system_text(const BasicCheckedMotion<D>& motion) {
  return Sentences<D>(motion).text();
}

template <int D>
std::string contacts_text(const BasicCheckedMotion<D>& motion, bool all,
                          const TerminalStyle& style) {
  const std::vector<CheckedContact> contacts = motion.contacts();
  const std::size_t shown = all ? contacts.size() : std::min(contacts.size(), most_events);
  if (shown == 0) {
    return "";
  }
  Table table({ranked("contact at", 0), ranked("cable", 0), ranked("until", 0),
               ranked("speed in", 0), ranked("speed out", 1), ranked("peak", 0),
               ranked("peak at", 1), ranked("stretch", 1), ranked("impulse", 0)});
  const auto time = [&](double value, double error) {
    return error < 0.0 && motion.is_checked()
               ? dash
               : right_fixed(value, std::max(error, 0.0), summary_time_digits);
  };
  const auto number = [&](double value, double error) {
    return error < 0.0 && motion.is_checked()
               ? dash
               : right_general(value, std::max(error, 0.0), summary_digits);
  };
  for (std::size_t index = 0; index < shown; ++index) {
    const auto& [contact, errors] = contacts[index];
    if (motion.is_checked() && motion.horizon() && contact.entry > *motion.horizon()) {
      table.add(std::vector<std::string>{dash, "beyond the horizon: one of many motions"});
      break;
    }
    std::vector<std::string> cells = {
        time(contact.entry, errors.entry),
        std::to_string(contact.cable),
        contact.exit ? time(*contact.exit, *errors.exit) : dash,
        number(contact.entry_speed, errors.entry_speed),
        contact.exit ? number(contact.exit_speed, errors.exit_speed) : dash,
        number(contact.peak, errors.peak),
        time(contact.peak_time, errors.peak_time),
        number(contact.greatest_stretch, errors.greatest_stretch),
        contact.exit ? number(contact.impulse, errors.impulse) : dash};
    table.add(std::move(cells));
  }
  const std::string rest = shown < contacts.size() ? fmt::format("and {} more: --events prints all",
                                                                 contacts.size() - shown)
                                                   : "";
  return "\n" + table.plain(style) + wrapped(rest, style.text);
}

template <int D>
std::string events_text(const BasicCheckedMotion<D>& motion, bool all, const TerminalStyle& style) {
  constexpr int event_digits = 12;
  const auto& events = motion.solution().events();
  const std::size_t shown = all ? events.size() : std::min(events.size(), most_events);
  if (shown == 0) {
    return "";
  }
  std::vector<Column> columns = {ranked("event at", 0), ranked("kind", 0), ranked("cables", 0),
                                 ranked("closing rate", 1), ranked("impulses", 0)};
  Table table(std::move(columns));
  for (std::size_t index = 0; index < shown; ++index) {
    const auto& event = events[index];
    const Bounded time = motion.time(index);
    if (time.error < 0.0 && motion.is_checked()) {
      table.add(std::vector<std::string>{dash, "beyond the horizon: one of many motions"});
      break;
    }
    const bool impact = event.kind == EventKind::impact;
    std::string impulses;
    for (const Bounded& one : motion.impulses(index)) {
      impulses += (impulses.empty() ? "" : ", ") +
                  right_general(one.value, std::max(one.error, 0.0), summary_digits);
    }
    const double closing = closing_speed(motion.system(), event.cables, event.before);
    std::vector<std::string> cells = {
        right_fixed(time.value, std::max(time.error, 0.0), event_digits),
        std::string(to_string(event.kind)), cable_list(event.cables),
        impact ? right_scientific(closing, 0.0, summary_digits) : dash, impact ? impulses : dash};
    table.add(std::move(cells));
  }
  const std::string rest =
      shown < events.size() ? fmt::format("and {} more: --events prints all", events.size() - shown)
                            : "";
  return "\n" + table.plain(style) + wrapped(rest, style.text);
}

template <int D>
std::string samples_text(const BasicCheckedMotion<D>& motion, const std::vector<double>& times,
                         const TerminalStyle& style) {
  constexpr int digits = 17;
  constexpr std::size_t longest_number = 24;  // [columns], -1.7976931348623157e+308
  std::vector<std::string> names;
  for (const SampleName& one : motion.names()) {
    names.push_back(one.name);
  }
  return samples_table(names, times, longest_number, style, [&](double time) {
    std::vector<std::string> result;
    const std::vector<Bounded> numbers = motion.at(time);
    const bool unsure = motion.is_checked() && numbers.front().error < 0.0;
    for (const Bounded& one : unsure ? std::vector<Bounded>() : numbers) {
      result.push_back(right_general(one.value, motion.is_checked() ? one.error : 0.0, digits));
    }
    return result;
  });
}

template std::string system_text(const BasicCheckedMotion<2>&);
template std::string contacts_text(const BasicCheckedMotion<2>&, bool, const TerminalStyle&);
template std::string events_text(const BasicCheckedMotion<2>&, bool, const TerminalStyle&);
template std::string samples_text(const BasicCheckedMotion<2>&, const std::vector<double>&,
                                  const TerminalStyle&);
template std::string system_text(const BasicCheckedMotion<3>&);
template std::string contacts_text(const BasicCheckedMotion<3>&, bool, const TerminalStyle&);
template std::string events_text(const BasicCheckedMotion<3>&, bool, const TerminalStyle&);
template std::string samples_text(const BasicCheckedMotion<3>&, const std::vector<double>&,
                                  const TerminalStyle&);

}  // namespace tautline::bench
