#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/detail/swing.hpp"

namespace tautline {

/// What happens at an event.
enum class EventKind {
  impact,  // a velocity jump: cables closed and rebound
  taut,    // cables at zero gap stay there, held by tension
  slack,   // a taut cable's tension fell to zero
  entry,   // an elastic cable begins to pull; nothing jumps
  exit,    // it ceases to pull
};

/// An instant at which the motion changes. Times count from the start of the run.
template <class TheCase>
struct BasicEvent {
  using Real = RealOf<TheCase>;

  Real time;        // [s]
  EventKind kind;   // what happens
  CableSet cables;  // that take part
  /// [N s], one per cable of `cables`, in rising index order. Of an accumulation that is completed:
  /// what removes the remaining rates, < 0 where gravity will have done it.
  BasicCableVector<Real> impulses;
  StateOf<TheCase> before;  // at its instant
  StateOf<TheCase> after;   // the same where nothing jumps
};
using Event = BasicEvent<Case>;

/// A stretch of motion without events.
template <class TheCase>
struct BasicArc {
  using Real = RealOf<TheCase>;

  Real start;                // [s]
  Real end;                  // [s], >= start
  StateOf<TheCase> initial;  // at `start`
  CableSet taut;             // held at zero gap along the arc; empty in free flight
  /// Taylor coefficients of the pose (x, y, angle) in the time since `start`; empty: the closed
  /// form of free flight. A system has these columns for each body; in space position, quaternion
  /// (w, x, y, z) and spin, and where it is empty the bodies rest, or turn at constant spins.
  PosesOf<TheCase> series;

  /// The state `dt` [s] after the start.
  [[nodiscard]] StateOf<TheCase> after(const Real& dt, const GravityOf<TheCase>& gravity) const;
};
using Arc = BasicArc<Case>;

/// Why a solution ends.
enum class Ending {
  reached_duration,  // nothing ended it before the case's duration
  rest,              // the body has come to rest for good, or to a steady spin about the centre it
                     // hangs at; the last arc lasts to the duration
  unstable_rest,     // the same, at an equilibrium that the smallest push ends
  locked,            // the body swings on its last cables from one turning point to the other, for
                     // ever; where SolveOptions::until_locked asks for it
  angle_limit,       // |angle| reached the case's limit
  ceiling,           // an attachment reached the case's ceiling
  singular,          // touching cables came into one line: no tension or impulse can be told there
  event_limit,       // as many events as SolveOptions allows
  step_limit,        // as many steps of taut motion and of springs as SolveOptions allows
  no_progress,       // event follows event and time does not advance
  overflow,          // the numbers of the motion no longer fit a double
};

/// Infinitely many impacts within a finite time, followed one by one up to `start` and completed at
/// once there: the state jumps to the one that the motion after `time` comes from.
template <class Real>
struct BasicAccumulation {
  Real start;        // [s], of the event that completes it, kind EventKind::taut
  Real time;         // [s], the limit of the impact times
  Real uncertainty;  // [s], `time` is off by at most this, rounding before `start` not counted
  CableSet cables;   // taut from then on
  Real energy_lost;  // [J], by the impacts after `start`
};
using Accumulation = BasicAccumulation<double>;

/// A motion that repeats for ever: the arcs from `first` on are one period of it, which is kept
/// once, however long the solution is.
template <class Real>
struct BasicRepetition {
  std::size_t first;  // arc, where the period starts; it ends with the last arc
  Real period;        // [s]
  Real turn;          // [rad], by which the body's angle grows in a period
  Real end;           // [s], of the solution
};
using Repetition = BasicRepetition<double>;

template <class Real>
struct Record;

/// The exact motion of a case: its arcs and events in rising time.
template <class TheCase>
class BasicSolution {
 public:
  using Real = RealOf<TheCase>;

  /// Made by solve(): arcs in order, each from the end of the one before. Of `system` the body, the
  /// cables and gravity are used.
  BasicSolution(TheCase system, std::vector<BasicArc<TheCase>> arcs,
                std::vector<BasicEvent<TheCase>> events, Ending ending,
                std::vector<BasicAccumulation<Real>> accumulations,
                std::optional<BasicSwing<Real>> swing = std::nullopt,
                std::optional<BasicRepetition<Real>> repetition = std::nullopt);

  /// The state at `time` in [0, end_time()], exact; at an event, the state after it.
  /// Throws std::out_of_range outside.
  [[nodiscard]] StateOf<TheCase> at(const Real& time) const;

  /// The tension [N] of each cable of the case at `time` in [0, end_time()], 0 for a slack one; at
  /// an event, the tension after it (Eq. 16). Statics do not determine the tensions of a redundant
  /// set of cables: these are the smallest, by the sum of their squares, of those that pull.
  /// Throws std::out_of_range outside.
  [[nodiscard]] BasicCableVector<Real> tensions(const Real& time) const;

  /// The same `dt` [s] after the start of `arc`, one of arcs(). At its end: before the event there.
  [[nodiscard]] BasicCableVector<Real> tensions(const BasicArc<TheCase>& arc, const Real& dt) const;

  /// The body, the cables and the gravity of its case.
  [[nodiscard]] const TheCase& system() const { return system_; }
  [[nodiscard]] const GravityOf<TheCase>& gravity() const { return system_.gravity; }  // [m/s^2]
  /// In order, at least one. A motion that repeats has them up to the end of its first period.
  [[nodiscard]] const std::vector<BasicArc<TheCase>>& arcs() const { return arcs_; }
  /// The arcs from the start to `time` [s], each as often as it comes; the last ends there.
  [[nodiscard]] std::vector<BasicArc<TheCase>> arcs_until(const Real& time) const;
  /// In order of time.
  [[nodiscard]] const std::vector<BasicEvent<TheCase>>& events() const { return events_; }
  [[nodiscard]] Ending ending() const { return ending_; }  // why it ends
  /// The end of the solution [s], which may lie beyond its arcs if the motion repeats.
  [[nodiscard]] const Real& end_time() const {
    return repetition_ ? repetition_->end : arcs_.back().end;
  }

  /// Where in the arcs the motion is at a time.
  struct Place {
    std::size_t arc;  // index
    Real dt;          // [s], since its start
    double periods;   // [-], whole ones that have gone by since then
  };
  /// Of `time` in [0, end_time()]; at an event, after it. Throws std::out_of_range outside.
  [[nodiscard]] Place place(const Real& time) const;

  /// Every accumulation that was completed, in rising time.
  [[nodiscard]] const std::vector<BasicAccumulation<Real>>& accumulations() const {
    return accumulations_;
  }

  /// The swing that goes on for ever where it ends with Ending::locked, else none.
  [[nodiscard]] const std::optional<BasicSwing<Real>>& swing() const { return swing_; }

  /// How its last arcs repeat, if they do so before its end.
  [[nodiscard]] const std::optional<BasicRepetition<Real>>& repetition() const {
    return repetition_;
  }

 private:
  friend struct Record<TheCase>;  // whose room it may have, and gives back

  TheCase system_;                       // without a name, a start and a duration
  std::vector<BasicArc<TheCase>> arcs_;  // never empty; each starts where the one before ends
  std::vector<BasicEvent<TheCase>> events_;
  Ending ending_;
  std::vector<BasicAccumulation<Real>> accumulations_;
  std::optional<BasicSwing<Real>> swing_;
  std::optional<BasicRepetition<Real>> repetition_;
};
using Solution = BasicSolution<Case>;

/// The names used in files: "impact", "reached_duration", and so on.
[[nodiscard]] std::string_view to_string(EventKind kind);
[[nodiscard]] std::string_view to_string(Ending ending);  // its name, such as "reached_duration"

}  // namespace tautline
