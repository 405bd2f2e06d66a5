#include "bench/solution/certificate_text.hpp"

#include <fmt/format.h>

#include <vector>

#include "bench/base/table.hpp"
#include "bench/solution/solution_text.hpp"

namespace tautline::bench {
namespace {

std::string mark_text(const std::optional<EventMark>& mark) {
  return mark ? fmt::format("{} on {} at t = {:.9f}", to_string(mark->kind),
                            cable_list(mark->cables), mark->time)
              : "no more event";
}

std::string certified_lock(const Lock& lock) {
  std::string result =
      fmt::format("{} taut from t = {:.9f} on", cables_are(lock.cables), lock.time);
  if (lock.swing) {
    result += fmt::format(", with a swing of energy {:.9g} and amplitude {:.9g} rad",
                          lock.swing->energy, lock.swing->amplitude);
  }
  return result;
}

std::vector<std::string> ledger_cells(const std::string& name, const EnergyLedger& ledger) {
  return {name,
          fmt::format("{:.15g}", ledger.start),
          fmt::format("{:.15g}", ledger.impacts),
          fmt::format("{:.3e}", ledger.completions),
          fmt::format("{:.15g}", ledger.end),
          fmt::format("{:.1e}", ledger.residual)};
}

}  // namespace

std::string certificate_text(const Certificate& certificate, const Case& the_case,
                             const Solution& solution) {
  std::string result = fmt::format(
      "Certificate: the same with {} digits. The numbers of the case are the doubles they are.\n"
      "Digits of position and angle, and of velocity while both take the same events:\n",
      certificate.digits);
  for (const CorrectDigits& correct : certificate.correct) {
    result +=
        fmt::format("  {} digits are correct {}\n", correct.digits,
                    correct.until ? fmt::format("until t = {:.9f}", *correct.until) : "to the end");
  }
  const EventMatch& events = certificate.events;
  if (events.all) {
    result += fmt::format("  both took the same events, {} of them\n", events.count);
  } else {
    result += fmt::format(
        "  both took the same {} events until t = {:.9f}; then {} in double, {} with {} digits\n",
        events.count, events.until, mark_text(events.in_double), mark_text(events.in_digits),
        certificate.digits);
  }
  if (certificate.ending != solution.ending()) {
    result += fmt::format("  with {} digits the ending is {} at t = {:.9f}\n", certificate.digits,
                          to_string(certificate.ending), certificate.end_time);
  }
  if (certificate.settling.lock) {
    result += fmt::format("  with {} digits {}\n", certificate.digits,
                          certified_lock(*certificate.settling.lock));
  }
  Table ledger({"energy", "start", "impacts", "completions", "end", "residual"}, 1);
  ledger.add(ledger_cells("double", energy_ledger(the_case, solution)));
  ledger.add(ledger_cells(fmt::format("{} digits", certificate.digits), certificate.energy));
  return result + "\n" + ledger.plain();
}

}  // namespace tautline::bench
