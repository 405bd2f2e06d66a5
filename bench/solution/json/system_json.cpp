#include <array>
#include <cstddef>
#include <utility>

#include "bench/cases/case_tables.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/solution/json/solution_fields.hpp"
#include "bench/solution/json/solution_json.hpp"
#include "tautline/case_text.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {

// The members of each object that a system has otherwise than a case.

struct WrittenSystem {
  Json file;
};
static Json json_of(const WrittenSystem& written) { return written.file; }
static Json schema_of(const WrittenSystem& /*written*/) {
  return {{"type", "object"},
          {"description", "a case file as JSON: `tautline schema case` has its schema"}};
}

template <int D>
struct PlacedBody {
  std::string name;
  typename Turning<double, D>::BodyState state;
};

template <class Visitor, int D>
void fields(Visitor& visit, PlacedBody<D>& body) {
  visit("name", body.name);
  fields(visit, body.state);
}

template <int D>
struct PlacedBodies {
  std::vector<PlacedBody<D>> bodies;
};

template <class Visitor, int D>
void fields(Visitor& visit, PlacedBodies<D>& state) {
  visit("bodies", state.bodies);
}

template <int D>
struct SystemEventErrors {
  double time = 0.0;
  CableVector impulses;
  PlacedBodies<D> before;
  PlacedBodies<D> after;
};

template <class Visitor, int D>
void fields(Visitor& visit, SystemEventErrors<D>& errors) {
  visit.means("how far the event's numbers are from those of the solution in more digits");
  error_fields(visit, errors, "[s]");
}

template <int D>
struct SystemEventRow {
  double time = 0.0;
  EventKind kind = EventKind::impact;
  CableSet cables;
  CableVector impulses;
  PlacedBodies<D> before;
  PlacedBodies<D> after;
  std::optional<SystemEventErrors<D>> errors;
};

template <class Visitor, int D>
void fields(Visitor& visit, SystemEventRow<D>& row) {
  event_fields(visit, row, row.errors, "null from `horizon` on");
}

/// All values of a sample, or all errors.
template <int D>
struct SystemSamplePart {
  PlacedBodies<D> state;
  std::array<std::vector<double>, 3> of_cables;  // gaps, their rates, tensions
  double energy = 0.0;
};

template <class Visitor, int D>
void fields(Visitor& visit, SystemSamplePart<D>& part) {
  fields(visit, part.state);
  visit("gaps", part.of_cables[0], or_null("of each cable [m]; null: it does not act"));
  visit("gap_rates", part.of_cables[1], or_null("[m/s]; null: the ends are at one point"));
  visit("tensions", part.of_cables[2], "[N]");
  visit("energy", part.energy, "[J]");
}

template <int D>
struct SystemSample {
  double time = 0.0;
  SystemSamplePart<D> values;
  std::vector<std::vector<BasicVector<double, D>>> points;
  std::optional<SystemSamplePart<D>> errors;
};

template <class Visitor, int D>
void fields(Visitor& visit, SystemSample<D>& sample) {
  visit("time", sample.time, "[s]");
  fields(visit, sample.values);
  visit("points", sample.points, "of each cable its ends, with the rings between them [m]");
  visit("errors", sample.errors,
        "how far these numbers are from those of the solution in more digits; null from `horizon` "
        "on");
}

template <class Visitor, class Row>
void ledger_fields(Visitor& visit, Row& row) {
  visit("start", row.ledger.start, "kinetic [J]");
  visit("work", row.ledger.work,
        "of gravity, forces, moments and drag, and of what moves ends and lengths [J]");
  visit("impacts", row.ledger.impacts, "lost in impacts [J]");
  visit("completions", row.ledger.completions, "lost in the completed accumulations [J]");
  visit.if_any("stored", row.stored,
               "in elastic cables at the end, less what it is at the start [J]");
  visit.if_any("dissipated", row.dissipated, "lost in elastic cables [J]");
  visit("end", row.ledger.end, "kinetic [J]");
}

struct LedgerErrors {
  SystemLedger ledger{};
  std::optional<double> stored = {};
  std::optional<double> dissipated = {};
};

template <class Visitor>
void fields(Visitor& visit, LedgerErrors& errors) {
  ledger_fields(visit, errors);
}

struct SystemLedgerRow {
  SystemLedger ledger{};
  std::optional<double> stored = {};
  std::optional<double> dissipated = {};
  std::optional<LedgerErrors> errors = {};
};

template <class Visitor>
void fields(Visitor& visit, SystemLedgerRow& row) {
  ledger_fields(visit, row);
  visit("residual", row.ledger.residual,
        "of rounding: end - start - work + what is lost or stored [J]");
  visit("range", row.ledger.range, "the largest kinetic energy, or sum of works, on the way [J]");
  visit("errors", row.errors, "null where the solutions part");
}

struct ContactRow {
  std::int32_t cable = 0;
  Bounded entry;
  std::optional<Bounded> exit;
  Bounded entry_speed;
  std::optional<Bounded> exit_speed;
  Bounded peak;
  Bounded peak_time;
  Bounded greatest_stretch;
  Bounded impulse;
};

template <class Visitor>
void fields(Visitor& visit, ContactRow& contact) {
  visit("cable", contact.cable, at_least(0));
  visit("entry", contact.entry, "when it begins to pull [s]");
  visit("exit", contact.exit, "when it pulls no more [s]; null: it pulls at the end");
  visit("entry_speed", contact.entry_speed, "at which it is stretched at the entry [m/s]");
  visit("exit_speed", contact.exit_speed, "at which it shrinks at the exit [m/s]");
  visit("peak", contact.peak, "the largest tension [N]");
  visit("peak_time", contact.peak_time, "[s]");
  visit("greatest_stretch", contact.greatest_stretch, "[m]");
  visit("impulse", contact.impulse,
        "of its tension [N s]; up to the end of the run, where it pulls then");
}

struct BoundedPeak {
  Bounded value;
  Bounded time;
};

template <class Visitor>
void fields(Visitor& visit, BoundedPeak& peak) {
  visit("value", peak.value);
  visit("time", peak.time, "the first of them [s]");
}

struct SystemLastImpact {
  double speed = 0.0;
  std::optional<Bounded> time;
};

template <class Visitor>
void fields(Visitor& visit, SystemLastImpact& last) {
  visit("speed", last.speed, "impacts that close faster than this [m/s]");
  visit("time", last.time, "of the last of them [s]; null without one");
}

struct CableUseRow {
  Bounded taut_share;
  std::optional<BoundedPeak> tension;
  std::optional<BoundedPeak> impulse;
};

template <class Visitor>
void fields(Visitor& visit, CableUseRow& use) {
  visit("taut_share", use.taut_share, "of the run [-]");
  visit("tension", use.tension, "the largest [N]; null where it is always slack");
  visit(
      "impulse", use.impulse,
      "the largest: its snap, or of an elastic cable a contact that ends [N s]; null without one");
}

struct SystemLockRow {
  Bounded time;
  CableSet cables;
  bool certain = false;
  bool at_rest = false;
  std::optional<Bounded> residual_energy;
  std::optional<Bounded> one_percent;
  std::optional<Bounded> ring_down;
};

template <class Visitor>
void fields(Visitor& visit, SystemLockRow& lock) {
  visit("time", lock.time, "from which on they are taut [s]");
  visit("cables", lock.cables);
  visit(
      "certain", lock.certain,
      "no tension falls to zero ever after: the bodies rest, or their energy is too low; else the "
      "lock is observed in this run alone");
  visit("at_rest", lock.at_rest, "the bodies rest");
  visit("residual_energy", lock.residual_energy,
        "above the equilibrium on these cables, at the end [J]; null: there is none on them");
  visit(
      "one_percent", lock.one_percent,
      "when drag or dampers have taken 99 % of what it is at `time` [s]; null: not within the run");
  visit("ring_down", lock.ring_down,
        "in which the swing of the stretch of a damped elastic cable falls to 1/e, at its "
        "stiffness at "
        "the end; the longest of these "
        "cables [s]; null: none of them is damped and elastic");
}

template <class Visitor>
void fields(Visitor& visit, ForcedMotion& forced) {
  visit("period", forced.period, "common to all waves [s]");
  visit("impacts", forced.impacts,
        "in a period, the mean of the last ones; contacts of elastic cables are not counted");
  visit("repeats", forced.repeats,
        "the motion comes again after this number of periods; null: it is not seen to do so three "
        "times");
}

struct SystemSettlingRow {
  std::vector<SystemLastImpact> last_impacts;
  std::vector<CableUseRow> cables;
  std::optional<SystemLockRow> lock;
  std::optional<ForcedMotion> forced;
};

template <class Visitor>
void fields(Visitor& visit, SystemSettlingRow& settling) {
  visit("last_impacts", settling.last_impacts);
  visit("cables", settling.cables, "of the system, in order");
  visit("lock", settling.lock, "the final set of taut cables; null: none, or something varies");
  visit("forced", settling.forced, "under waves; null: nothing varies, or without a period");
}

/// All that is written of a system.
template <int D>
struct SystemSolutionRow {
  WrittenSystem system;
  SolveOptions options;
  std::optional<std::int32_t> digits;
  std::optional<double> horizon;
  std::vector<SystemEventRow<D>> events;
  Ending ending = Ending::reached_duration;
  double end_time = 0.0;
  PlacedBodies<D> end_state;
  SystemLedgerRow energy;
  SystemSettlingRow settling;
  std::vector<AccumulationRow> accumulations;
  std::optional<std::vector<ContactRow>> contacts;
  std::optional<std::vector<SystemSample<D>>> samples;
};

template <class Visitor, int D>
void fields(Visitor& visit, SystemSolutionRow<D>& solution) {
  schema_field(visit, system_solution_schema);
  visit("system", solution.system);
  visit("options", solution.options);
  visit(
      "digits", solution.digits,
      "decimal, of the solution that this one is compared with; null: --fast, nothing is checked");
  visit("horizon", solution.horizon,
        "from here on the two solutions part: the motion is one of many that start alike [s]; "
        "null: they agree to the end");
  visit("events", solution.events);
  visit("ending", std::string(to_string(solution.ending)));
  visit("end_time", solution.end_time, "[s]");
  visit("end_state", solution.end_state);
  visit("energy", solution.energy);
  visit("settling", solution.settling);
  visit("accumulations", solution.accumulations);
  visit.if_any("contacts", solution.contacts, "of the elastic cables, by rising entry");
  visit.if_any("samples", solution.samples, "at the times asked for");
}

/// All values or all errors of `numbers`, which are in the order of `CheckedMotion::names`.
template <int D>
static SystemSamplePart<D> part_of(const BasicCheckedMotion<D>& motion,
                                   const std::vector<Bounded>& numbers, double Bounded::*part) {
  SystemSamplePart<D> result;
  auto next = numbers.begin();
  const auto& bodies = motion.system().bodies;
  for (std::size_t index = 0; index < bodies.size(); ++index) {
    PlacedBody<D>& body = result.state.bodies.emplace_back();
    body.name = name_in_file(bodies[index].name, index, bodies.size());
    for (const auto& one : coordinates(body.state)) {
      one.value = *(next++).*part;
    }
  }
  for (std::size_t cable = 0; cable < motion.system().cables.size(); ++cable) {
    for (auto& list : result.of_cables) {
      const double number = *(next++).*part;
      list.push_back(part == &Bounded::error && number < 0.0 ? infinity<double>() : number);
    }
  }
  result.energy = *next.*part;
  return result;
}

/// None where the numbers of one instant are beyond the horizon.
template <int D>
static std::optional<SystemSamplePart<D>> errors_of(const BasicCheckedMotion<D>& motion,
                                                    const std::vector<Bounded>& numbers) {
  return numbers.front().error < 0.0 ? std::nullopt
                                     : std::optional(part_of(motion, numbers, &Bounded::error));
}

template <int D>
static SystemEventRow<D> event_row(const BasicCheckedMotion<D>& motion, std::size_t index) {
  const auto& event = motion.solution().events()[index];
  const auto before = motion.at_event(index, Side::before);
  const auto after = motion.at_event(index, Side::after);
  SystemEventRow<D> row = {event.time,
                           event.kind,
                           event.cables,
                           event.impulses,
                           part_of(motion, before, &Bounded::value).state,
                           part_of(motion, after, &Bounded::value).state,
                           std::nullopt};
  if (const double time = motion.time(index).error; time >= 0.0) {
    SystemEventErrors<D>& errors = row.errors.emplace();
    errors.time = time;
    errors.impulses = event.impulses;
    Eigen::Index place = 0;
    for (const Bounded& impulse : motion.impulses(index)) {
      errors.impulses[place++] = impulse.error;
    }
    errors.before = part_of(motion, before, &Bounded::error).state;
    errors.after = part_of(motion, after, &Bounded::error).state;
  }
  return row;
}

template <int D>
static SystemSettlingRow settling_row(const BasicCheckedMotion<D>& motion) {
  const SystemSettling& settling = motion.settling();
  const SystemSettlingErrors errors = motion.settling_errors();
  const auto bounded_or_none = [](const std::optional<double>& value, double error) {
    return value ? std::optional(Bounded{*value, error}) : std::nullopt;
  };
  const auto peak = [](const std::optional<Peak>& one, double value, double time) {
    // no -0
    return one ? std::optional(BoundedPeak{{one->value + 0.0, value}, {one->time, time}})
               : std::nullopt;
  };
  SystemSettlingRow row;
  for (std::size_t i = 0; i < settling.last_impacts.size(); ++i) {
    const LastImpact& last = settling.last_impacts[i];
    row.last_impacts.push_back({last.speed, bounded_or_none(last.time, errors.last_impacts[i])});
  }
  for (std::size_t i = 0; i < settling.cables.size(); ++i) {
    const CableUse& use = settling.cables[i];
    row.cables.push_back({{use.taut_share, errors.shares[i]},
                          peak(use.tension, errors.tensions[i], errors.tension_times[i]),
                          peak(use.impulse, errors.impulses[i], errors.impulse_times[i])});
  }
  if (const auto& lock = settling.lock) {
    row.lock = {{lock->time, errors.lock},
                lock->cables,
                lock->certain,
                lock->at_rest,
                bounded_or_none(lock->residual_energy, errors.residual_energy),
                bounded_or_none(lock->one_percent, errors.one_percent),
                bounded_or_none(lock->ring_down, errors.ring_down)};
  }
  row.forced = settling.forced;
  return row;
}

template <int D>
static std::vector<ContactRow> contact_rows(const BasicCheckedMotion<D>& motion) {
  std::vector<ContactRow> rows;
  for (const auto& [contact, errors] : motion.contacts()) {
    ContactRow& row = rows.emplace_back();
    row.cable = static_cast<std::int32_t>(contact.cable);
    row.entry = {contact.entry, errors.entry};
    row.entry_speed = {contact.entry_speed, errors.entry_speed};
    if (contact.exit) {
      row.exit = {*contact.exit, *errors.exit};
      row.exit_speed = {contact.exit_speed, errors.exit_speed};
    }
    row.peak = {contact.peak, errors.peak};
    row.peak_time = {contact.peak_time, errors.peak_time};
    row.greatest_stretch = {contact.greatest_stretch, errors.greatest_stretch};
    row.impulse = {contact.impulse, errors.impulse};
  }
  return rows;
}

template <int D>
static SystemSample<D> sample_at(const BasicCheckedMotion<D>& motion, double time) {
  const std::vector<Bounded> numbers = motion.at(time);
  SystemSample<D> sample = {
      time, part_of(motion, numbers, &Bounded::value), {}, errors_of(motion, numbers)};
  const auto state = motion.solution().at(time);
  for (const auto& cable : motion.system().cables) {
    auto& points = sample.points.emplace_back();
    for (std::size_t index = 0; index <= cable.segments(); ++index) {
      points.push_back(moving_point(cable.end(index), state).position);
    }
  }
  return sample;
}

Json schema_of_system_solution() { return schema_of(SystemSolutionRow<2>()); }
Json schema_of_spatial_solution() { return schema_of(SystemSolutionRow<3>()); }

template <int D>
std::string solution_json(const BasicCheckedMotion<D>& motion, const SolveOptions& options,
                          std::span<const double> sample_times) {
  const auto& solution = motion.solution();
  const double end = solution.end_time();
  SystemSolutionRow<D> row;
  row.system = {Json::parse(write_system_json(motion.system()))};
  row.options = options;
  row.digits = motion.is_checked() ? std::optional(motion.digits()) : std::nullopt;
  row.horizon = motion.horizon();
  for (std::size_t index = 0; index < solution.events().size(); ++index) {
    row.events.push_back(event_row(motion, index));
  }
  row.ending = solution.ending();
  row.end_time = end;
  row.end_state = part_of(motion, motion.at(end), &Bounded::value).state;
  row.energy.ledger = motion.ledger();
  const bool is_elastic = first_elastic(motion.system()).has_value();
  if (is_elastic) {
    row.energy.stored = motion.ledger().stored;
    row.energy.dissipated = motion.ledger().dissipated;
    row.contacts = contact_rows(motion);
  }
  if (const SystemLedger errors = motion.ledger_errors(); errors.end >= 0.0) {
    row.energy.errors = LedgerErrors{errors};
    if (is_elastic) {
      row.energy.errors->stored = errors.stored;
      row.energy.errors->dissipated = errors.dissipated;
    }
  }
  row.settling = settling_row(motion);
  for (std::size_t index = 0; index < solution.accumulations().size(); ++index) {
    const double error = motion.accumulation_error(index);
    row.accumulations.push_back(
        {solution.accumulations()[index], error < 0.0 ? std::nullopt : std::optional(error)});
  }
  if (!sample_times.empty()) {
    auto& samples = row.samples.emplace();
    for (const double time : sample_times) {
      samples.push_back(sample_at(motion, time));
    }
  }
  return in_lines(json_of(row));
}

template std::string solution_json(const BasicCheckedMotion<2>&, const SolveOptions&,
                                   std::span<const double>);
template std::string solution_json(const BasicCheckedMotion<3>&, const SolveOptions&,
                                   std::span<const double>);

}  // namespace tautline::bench
