#pragma once

#include <optional>
#include <string>

#include "bench/data/describer.hpp"
#include "bench/data/motion_fields.hpp"
#include "bench/solution/samples.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

// The members of the motions of cases and systems that are the same in JSON.

template <class Visitor, class Errors>
void error_fields(Visitor& visit, Errors& errors, const char* time) {
  visit("time", errors.time, time);
  visit("impulses", errors.impulses, "[N s]");
  visit("before", errors.before);
  visit("after", errors.after);
}

template <class Visitor, class TheEvent, class Errors>
void event_fields(Visitor& visit, TheEvent& event, std::optional<Errors>& errors,
                  const char* none) {
  event.impulses = event.impulses.cwiseMax(0.0);  // below are gravity's
  visit("time", event.time, "[s]");
  visit("kind", event.kind);
  visit("cables", event.cables);
  visit("impulses", event.impulses, at_least(0, "of each of `cables` [N s]"));
  visit("before", event.before);
  visit("after", event.after);
  visit("errors", errors, none);
}

template <class Visitor>
void fields(Visitor& visit, SolveOptions& options) {
  visit("law", std::string(to_string(options.law)));
  visit("completion_error", options.completion.error);
  visit("max_events", options.max_events);
  visit("max_steps", options.max_steps);
}

template <class Visitor>
void fields(Visitor& visit, Bounded& number) {
  const auto error = number.error < 0.0 ? std::nullopt : std::optional(number.error);
  visit("value", number.value);
  visit("error", error, "null: no digit is right");
}

struct AccumulationRow {
  Accumulation accumulation;
  std::optional<double> error;
};

template <class Visitor>
void fields(Visitor& visit, AccumulationRow& row) {
  visit("start", row.accumulation.start, "[s]");
  visit("time", row.accumulation.time, "of its limit [s]");
  visit("uncertainty", row.error, "of that time [s]");
  visit("cables", row.accumulation.cables);
  visit("energy_lost", row.accumulation.energy_lost, "[J]");
}

/// The schema of what `solution_json` writes of a system.
[[nodiscard]] Json schema_of_system_solution();
[[nodiscard]] Json schema_of_spatial_solution();

}  // namespace tautline::bench
