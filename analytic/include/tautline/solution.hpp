#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"

namespace tautline {

enum class EventKind {
  impact,  // a velocity jump: cables closed and rebound
  taut,    // cables at zero gap stay there, held by tension
  slack,   // a taut cable's tension fell to zero
};

/// An instant at which the motion changes. Times count from the start of the run.
struct Event {
  double time;           // [s]
  EventKind kind;        //
  CableSet cables;       // that take part
  CableVector impulses;  // [N s], one per cable of `cables`, in rising index order
  State before;
  State after;
};

/// A stretch of motion without events.
struct Arc {
  double start;   // [s]
  double end;     // [s], >= start
  State initial;  // at `start`
  CableSet taut;  // held at zero gap along the arc; empty in free flight
};

/// Why a solution ends.
enum class Ending {
  reached_duration,  // nothing ended it before the case's duration
  zeno,              // impacts accumulate: infinitely many before a finite time
  taut,              // a resting cable stays taut at once, without an accumulation
  angle_limit,       // |angle| reached the case's limit
  ceiling,           // an attachment reached the case's ceiling
  event_limit,       // more events than SolveOptions allows
  overflow,          // the numbers of the motion no longer fit a double
};

/// The accumulation that ended a solution with Ending::zeno.
struct Accumulation {
  double time;         // [s], the limit of the impact times
  double uncertainty;  // [s], `time` is off by at most this, rounding before the end not counted
  CableSet cables;     // taut from then on
  State state;         // where the solution ends, velocity projected onto the taut cables
  double energy;       // [J], of `state`: what is left for the motion on taut cables
};

/// The exact motion of a case: its arcs and events in rising time.
class Solution {
 public:
  Solution(Vec2 gravity, std::vector<Arc> arcs, std::vector<Event> events, Ending ending,
           std::optional<Accumulation> accumulation);

  /// The state at `time` in [0, end_time()], exact; at an event, the state after it.
  /// Throws std::out_of_range outside.
  [[nodiscard]] State at(double time) const;

  [[nodiscard]] const std::vector<Arc>& arcs() const { return arcs_; }
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  [[nodiscard]] Ending ending() const { return ending_; }
  [[nodiscard]] double end_time() const { return arcs_.back().end; }

  /// Present exactly when ending() is Ending::zeno.
  [[nodiscard]] const std::optional<Accumulation>& accumulation() const { return accumulation_; }

 private:
  Vec2 gravity_;
  std::vector<Arc> arcs_;  // never empty; each starts where the one before ends
  std::vector<Event> events_;
  Ending ending_;
  std::optional<Accumulation> accumulation_;
};

/// The names used in files: "impact", "reached_duration", and so on.
[[nodiscard]] std::string_view to_string(EventKind kind);
[[nodiscard]] std::string_view to_string(Ending ending);

}  // namespace tautline
