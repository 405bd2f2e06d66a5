#include "bench/solution/texts.hpp"

#include <fmt/format.h>

#include <vector>

#include "bench/base/table.hpp"
#include "bench/solution/cable_words.hpp"

namespace tautline::bench {
namespace {

std::string mark_text(const std::optional<EventMark>& mark) {
  return mark ? fmt::format("{} on {} at t = {:.9f}", to_string(mark->kind),
                            cable_list(mark->cables), mark->time)
              : "no more event";
}

std::string certified_lock(const Lock& lock) {
  std::string result = fmt::format("{} {} taut from t = {:.9f} on", cable_names(lock.cables),
                                   lock.cables.size() == 1 ? "is" : "are", lock.time);
  if (lock.swing && lock.swing->goes_round) {
    result += fmt::format(", making full turns with period {:.9g}", lock.swing->period);
  } else if (lock.swing) {
    result += fmt::format(", with a swing of energy {:.9g} and amplitude {:.9g} rad",
                          lock.swing->energy, lock.swing->amplitude);
  }
  return result;
}

/// Where the energy went, in doubles and in many digits side by side.
std::string ledger_text(const EnergyLedger& doubles, const Certificate& certificate,
                        const TerminalStyle& style) {
  const EnergyLedger& digits = certificate.energy;
  Table table({"energy", "double", fmt::format("{} digits", certificate.digits)}, 1);
  const auto add = [&](const char* name, double EnergyLedger::*part, int shown, char kind) {
    const auto text = [&](const EnergyLedger& ledger) {
      return kind == 'e' ? fmt::format("{:.{}e}", ledger.*part, shown)
                         : fmt::format("{:.{}g}", ledger.*part, shown);
    };
    table.add(std::vector<std::string>{name, text(doubles), text(digits)});
  };
  add("start", &EnergyLedger::start, 15, 'g');
  add("impacts", &EnergyLedger::impacts, 15, 'g');
  add("completions", &EnergyLedger::completions, 3, 'e');
  add("end", &EnergyLedger::end, 15, 'g');
  add("residual", &EnergyLedger::residual, 1, 'e');
  return table.plain(style);
}

}  // namespace

std::string certificate_text(const Certificate& certificate, const Case& the_case,
                             const Solution& solution, const TerminalStyle& style) {
  std::string result = fmt::format(
      "Certificate: compared with the same motion in {} digits, from the same doubles.\n"
      "Digits of position and angle, and of velocity while both have the same events:\n",
      certificate.digits);
  for (const CorrectDigits& correct : certificate.correct) {
    result +=
        fmt::format("  {} digits are correct {}\n", correct.digits,
                    correct.until ? fmt::format("until t = {:.9f}", *correct.until) : "to the end");
  }
  const EventMatch& events = certificate.events;
  const std::string same = fmt::format("{} event{}", events.count, events.count == 1 ? "" : "s");
  if (events.all) {
    result += events.count == 0 ? "  neither has an event\n"
                                : fmt::format("  both have the same {}\n", same);
  } else {
    result += fmt::format(
        "  both have the same {} until t = {:.9f}; then {} in double, {} in {} digits\n", same,
        events.until, mark_text(events.in_double), mark_text(events.in_digits), certificate.digits);
  }
  if (certificate.ending != solution.ending()) {
    result += fmt::format("  in {} digits the ending is {} at t = {:.9f}\n", certificate.digits,
                          to_string(certificate.ending), certificate.end_time);
  }
  if (certificate.settling.lock) {
    result += fmt::format("  in {} digits {}\n", certificate.digits,
                          certified_lock(*certificate.settling.lock));
  }
  return result + "\n" + ledger_text(energy_ledger(the_case, solution), certificate, style);
}

}  // namespace tautline::bench
