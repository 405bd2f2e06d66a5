#include "bench/solution/json/solution_json.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/solution/json/solution_fields.hpp"
#include "bench/solution/samples.hpp"
#include "bench/solution/taut_phases.hpp"
#include "bench/solution/time_errors.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

// The members of each object, for writing and for the schema.

template <class Visitor>
void fields(Visitor& visit, EventErrors& errors) {
  visit.means("bounds of the errors of the event's numbers");
  error_fields(visit, errors, "[s]; of a completed accumulation: of its limit");
}

struct EventRow {
  Event event;
  std::optional<EventErrors> errors;
  CableSet indeterminate;
};

template <class Visitor>
void fields(Visitor& visit, EventRow& row) {
  event_fields(visit, row.event, row.errors,
               "null within `unsure`: the motion is one of many that start alike");
  const auto split = row.indeterminate.empty() ? std::nullopt : std::optional(row.indeterminate);
  visit.if_any("indeterminate", split,
               "cables among which the impulse can be split in several ways; it is the smallest");
}

template <class Visitor>
void fields(Visitor& visit, PeriodTension& one) {
  visit("cable", one.cable);
  visit("least", one.least, "[N]");
  visit("largest", one.largest, "[N]");
}

/// A lock, the error of its time, and the tensions of its swing over a period.
struct LockRow {
  Lock lock;
  std::optional<double> error;
  std::optional<std::vector<PeriodTension>> tensions;
};

struct SwingRow {
  Swing swing;
  std::optional<std::vector<PeriodTension>> tensions;
};

template <class Visitor>
void fields(Visitor& visit, SwingRow& row) {
  const Swing& swing = row.swing;
  const auto angle = [&](double value) {
    return swing.goes_round ? std::nullopt : std::optional(value);
  };
  const std::string angle_of = swing.angle == SwingAngle::body ? "body" : "cable";
  visit.means("to and fro, or round and round: then it has no turning points");
  visit("energy", swing.energy, "above the equilibrium [J]");
  visit("period", swing.period, "[s]");
  visit("least", angle(swing.least), "smallest angle [rad]");
  visit("largest", angle(swing.largest), "[rad]");
  visit("amplitude", angle(swing.amplitude), "half the difference [rad]");
  visit("angle_of", angle_of,
        one_of({"body", "cable"}, "cable: the first one; the body does not turn with it"));
  visit("goes_round", swing.goes_round);
  visit.if_any("tensions", row.tensions, "the extremes over a period");
}

template <class Visitor>
void fields(Visitor& visit, LockRow& row) {
  const Lock& lock = row.lock;
  const auto swing = lock.swing ? std::optional(SwingRow{*lock.swing, row.tensions}) : std::nullopt;
  visit("time", lock.time, "from which on they are taut [s]");
  visit("uncertainty", row.error,
        "bound of the error of the time: rounding, and how the bounces end; of a certificate the "
        "latter alone [s]");
  visit("cables", lock.cables);
  visit("permanent", lock.permanent,
        "the body rests, or a whole period of its swing passes without a release");
  visit("rests", lock.rests);
  visit("swing", swing, "of a body with one degree of freedom left");
}

struct SettlingRow {
  std::vector<LastImpact> last_impacts;
  std::optional<LockRow> lock;
};

template <class Visitor>
void fields(Visitor& visit, SettlingRow& settling) {
  visit("last_impacts", settling.last_impacts);
  visit("lock", settling.lock, "the final set of taut cables; null if all are slack at the end");
}

/// `error` is that of the time of the lock.
static SettlingRow settling_row(const Settling& settling, const std::optional<double>& error) {
  SettlingRow row = {settling.last_impacts, {}};
  if (settling.lock) {
    row.lock = {*settling.lock, error, {}};
  }
  return row;
}

template <class Visitor>
void fields(Visitor& visit, Tie& tie) {
  visit.means(
      "what rounding decides. impact: which of the cables, taut at one instant, is hit first; "
      "slack: whether the cable lets go, whose tension touches zero; taut: how the body goes on "
      "from a dead point of its taut cables");
  visit("kind", tie.kind);
  visit("cables", tie.cables);
}

template <class Visitor>
void fields(Visitor& visit, Unsure& stretch) {
  visit("from", stretch.from, "[s]");
  visit("until", stretch.until, or_null("[s]; null: to the end"));
  visit("tie", stretch.tie, "that begins it; null: errors have grown");
}

template <class Visitor>
void fields(Visitor& visit, TensionAt& extreme) {
  visit("tension", extreme.tension, "[N]");
  visit("time", extreme.time, "the first of them [s]");
}

template <class Visitor>
void fields(Visitor& visit, TautPhase& phase) {
  visit.means("a stretch of time in which a cable stays taut, and its tension there");
  visit("cable", phase.cable);
  visit("from", phase.from.value, "[s]");
  visit("until", phase.until.value, "[s]");
  visit("least", phase.least);
  visit("largest", phase.largest);
  visit("indeterminate", phase.indeterminate,
        "statics leave the share of the cable open: the tensions are the smallest then");
}

/// Of a sample all values, or all errors.
struct SamplePart {
  MotionSample sample;
  State state;
  double Bounded::*part = &Bounded::value;
};

template <class Visitor>
void fields(Visitor& visit, SamplePart& row) {
  const auto list = [&](Bounded CableSample::*member) {
    std::vector<double> numbers;
    for (const CableSample& cable : row.sample.cables) {
      numbers.push_back(cable.*member.*row.part);
    }
    return numbers;
  };
  fields(visit, row.state);
  visit("gaps", list(&CableSample::gap), "of each cable [m]");
  visit("gap_rates", list(&CableSample::gap_rate),
        or_null("[m/s]; null: the ends are at one point"));
  visit("tensions", list(&CableSample::tension), "[N]");
  visit("energy", row.sample.energy.*row.part, "[J]");
}

template <class Visitor>
void fields(Visitor& visit, MotionSample& sample) {
  SamplePart values = {sample, sample.state, &Bounded::value};
  std::optional<SamplePart> errors;
  if (sample.errors) {
    errors = {sample, *sample.errors, &Bounded::error};
  }
  visit("time", sample.time.value, "[s]");
  fields(visit, values);
  visit("errors", errors, "bounds of the errors of these numbers; null beyond the horizon");
}

template <class Visitor>
void fields(Visitor& visit, EventMark& mark) {
  visit("time", mark.time, "[s]");
  visit("kind", mark.kind);
  visit("cables", mark.cables);
}

template <class Visitor>
void fields(Visitor& visit, EnergyLedger& ledger) {
  visit("start", ledger.start, "[J]");
  visit("impacts", ledger.impacts, "of the impacts [J]");
  visit("completions", ledger.completions, "of the completed accumulations [J]");
  visit("end", ledger.end, "[J]");
  visit("residual", ledger.residual, "[J]");
}

template <class Visitor>
void fields(Visitor& visit, Certificate& certificate) {
  const std::optional<Lock>& lock = certificate.settling.lock;  // without rounding to speak of
  const EventMatch& events = certificate.events;
  visit.means("the motion compared with the same one in many digits");
  visit("digits", certificate.digits, at_least(20, "decimal, of the other solution's numbers"));
  visit("completion_error", certificate.completion_error);
  visit("correct", std::vector(certificate.correct.begin(), certificate.correct.end()));
  visit.group("events", "", [&](auto& inside) {
    inside("same", events.count, "from the first on");
    inside("until", events.until, "of the last of them [s]");
    inside("all", events.all, "neither solution has another");
    inside("next_in_double", events.in_double);
    inside("next_in_digits", events.in_digits);
    inside("in_digits", certificate.event_count, "events of the other solution");
  });
  visit("ending", std::string(to_string(certificate.ending)));
  visit("end_time", certificate.end_time, "[s]");
  visit("energy", certificate.energy);
  visit("settling",
        settling_row(certificate.settling, lock ? std::optional(lock->uncertainty) : std::nullopt));
}

/// All that is written.
struct SolutionRow {
  Case the_case;
  SolveOptions options;
  std::vector<EventRow> events;
  Ending ending = Ending::reached_duration;
  double end_time = 0.0;
  State end_state;
  EnergyLedger energy{};
  SettlingRow settling;
  std::vector<Unsure> unsure;
  std::vector<AccumulationRow> accumulations;
  std::vector<TautPhase> taut;
  std::optional<std::vector<MotionSample>> samples;
  std::optional<Certificate> certificate;
};

template <class Visitor>
void fields(Visitor& visit, SolutionRow& solution) {
  schema_field(visit, solution_schema);
  visit("case", solution.the_case);
  visit("options", solution.options);
  visit("events", solution.events);
  visit("ending", std::string(to_string(solution.ending)));
  visit("end_time", solution.end_time, "[s]");
  visit("end_state", solution.end_state);
  visit("energy", solution.energy);
  visit("settling", solution.settling);
  visit("unsure", solution.unsure, "stretches of time in which nothing but the energy is sure");
  visit("accumulations", solution.accumulations);
  visit("taut", solution.taut);
  visit.if_any("samples", solution.samples, "at the times asked for");
  visit.if_any("certificate", solution.certificate);
}

std::vector<std::string> sample_problems(double end, Ending ending,
                                         std::span<const double> sample_times) {
  std::vector<std::string> result;
  for (const double time : sample_times) {
    if (!(time >= 0.0 && time <= end)) {
      result.push_back("sample time " + shortest(time) + " is outside [0, " + shortest(end) +
                       "]: the solution ends there (" + std::string(to_string(ending)) + ")");
    }
  }
  return result;
}

std::string solution_schema_json() {
  return text_of(headed(
      "Motion of `tautline solve --json`",
      "The exact motion of a case or of a system. Each value, event and sample is a line.",
      {{"oneOf",
        {schema_of(SolutionRow()), schema_of_system_solution(), schema_of_spatial_solution()}}}));
}

std::string solution_json(const Case& the_case, const SolveOptions& options,
                          const Solution& solution, const Settling& settling,
                          std::span<const double> sample_times,
                          const std::optional<Certificate>& certificate) {
  const Uncertainty uncertainty(the_case, solution, options);
  const double end = solution.end_time();
  SolutionRow row = {
      .the_case = the_case,
      .options = options,
      .events = {},
      .ending = solution.ending(),
      .end_time = end,
      .end_state = solution.at(end),
      .energy = energy_ledger(the_case, solution),
      .settling = settling_row(settling, lock_error(solution, settling, uncertainty)),
      .unsure = {uncertainty.unsure().begin(), uncertainty.unsure().end()},
      .accumulations = {},
      .taut = taut_phases(the_case, solution, uncertainty),
      .samples = {},
      .certificate = certificate};
  for (std::size_t index = 0; index < solution.events().size(); ++index) {
    const Event& event = solution.events()[index];
    row.events.push_back(
        {event, uncertainty.events()[index], indeterminate(options.law, the_case, event)});
  }
  if (settling.lock && settling.lock->swing) {
    row.settling.lock->tensions =
        period_tensions(the_case, solution.events().back().after, settling.lock->cables,
                        *settling.lock->swing, uncertainty.energy(end).value_or(-1.0));
  }
  for (const Accumulation& one : solution.accumulations()) {
    row.accumulations.push_back({one, limit_error(solution, uncertainty, one)});
  }
  if (!sample_times.empty()) {
    auto& samples = row.samples.emplace();
    for (const double time : sample_times) {
      samples.push_back(sample_at(the_case, solution, uncertainty, time));
    }
  }
  return in_lines(json_of(row));
}

}  // namespace tautline::bench
