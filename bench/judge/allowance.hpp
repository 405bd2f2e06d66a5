#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "bench/measure/reference.hpp"

namespace tautline::bench {

// How far any correct scheme with fixed steps may be off in a case, from the exact motion of that
// case alone: no table of cases, engines or models has a part in it.
//
// A scheme that comes to an impact late by a step, or flies with the first order of its step, is
// off by
//
//     A(t; h) = h (sum over impacts |P S(t, t_i) d_i| + sum over arcs |integral P S(t, s) b(s) ds|)
//
// to first order, where d_i is the derivative of the state by a delay of impact i, b the defect of
// a first-order scheme per unit of time, S the derivative of the motion and P its position rows.
// And a plain correct scheme (PlainScheme) is off by Y(t; h) at most, over many shifts of its first
// step. A misses impacts that swap and is infinite where no derivative exists; Y is blind where no
// shift happens on the worst. They fail in different places: the larger of the two is allowed.

/// Numbers along a motion; the largest so far counts.
struct AlongMotion {
  std::vector<double> times;   // [s], rising, the first is 0
  std::vector<double> values;  // one for each, never falling

  /// At the first of the times that is not before `time`; after the last, the last.
  [[nodiscard]] double at(double time) const;
};

/// Why no run is judged by its position after some instant.
enum class Barrier {
  end,     // nothing ends it before the exact motion does, or its horizon
  effort,  // more steps than the plain scheme is run for
  growth,  // what a step may be off by has grown to a tenth of the shortest cable
  fork,    // correct schemes may part: a near miss, or impacts of two cables that may swap
};

/// Roundings of an engine's numbers, relative to the largest of them [-].
[[nodiscard]] double rounding_of(std::string_view precision);

/// How far a run with steps of `step` may be off.
struct Allowance {
  double step = 0.0;               // [s]
  AlongMotion position;            // [m], of the centre of mass
  AlongMotion attachment;          // [m], of the attachment point that is off the most
  double until = 0.0;              // [s]: a step-by-step model can follow the motion up to here
  Barrier barrier = Barrier::end;  // why not for longer

  /// At `time` [s]: as two steps later, as a scheme may be late by that.
  [[nodiscard]] double at(double time) const { return position.at(time + 2.0 * step); }
  /// The same of where the cables are attached: what decides when one goes taut.
  [[nodiscard]] double of_cables(double time) const { return attachment.at(time + 2.0 * step); }
};

/// An impact of one cable in the exact motion.
struct ExactHit {
  double time;         // [s]
  std::size_t cable;   //
  double speed;        // [m/s]
  double rebound;      // [m/s]
  double restitution;  // [-]
  double change;       // [m/s^2], of the rate next to it
  bool alone;          // no other cable is struck at the same instant
};

/// Those up to `until` [s], in rising time. A reference is one of a case or of a system.
template <class TheReference>
[[nodiscard]] std::vector<ExactHit> exact_hits(const TheReference& reference, double until);

/// The error of the plain scheme at some instants, over shifts of its first step.
struct Yardstick {
  std::vector<double> worst;       // [m], the largest of all shifts up to each instant
  std::vector<double> mean;        // [m], of the largest of each
  std::vector<double> attachment;  // [m], as `worst`, of the attachment points
};

/// The error of the plain scheme on `reference` in steps of `step` [s], up to each of `times` [s],
/// which rise; of the first ones alone once an attachment point is off by `enough` [m].
template <class TheReference>
[[nodiscard]] Yardstick yardstick(const TheReference& reference, double step,
                                  const std::vector<double>& times, double enough);

/// Says of all runs of a case how far each may be off, from the exact motion. Any thread may ask.
/// Systems have the plain scheme alone, no derivative: three times its error is allowed to them.
template <class TheReference>
class BasicExpectation {
 public:
  /// `reference` must outlive this.
  explicit BasicExpectation(const TheReference& reference);

  [[nodiscard]] const TheReference& reference() const { return reference_; }

  /// For runs with steps of `step` [s] and numbers of the engine's `precision`: worked out when it
  /// is first asked for.
  [[nodiscard]] const Allowance& allowance(double step,
                                           std::string_view precision = "float64") const;

  /// How much rounding has grown to [m] at an instant: of numbers with a relative error of one,
  /// once in each second and once at each event. Random roundings add up by their squares. 0 of
  /// systems.
  [[nodiscard]] double rounding_at(double time, double step) const;

  /// The fastest that a body or an attachment point moves, or a cable closes, in the exact motion
  /// [m/s]; the largest acceleration of a body, of an attachment point by its spin, and
  /// ExactHit::change of an impact [m/s^2].
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] double acceleration() const { return acceleration_; }
  [[nodiscard]] double turning() const { return turning_; }
  [[nodiscard]] double change() const { return change_; }
  /// The farthest that a body is from the origin [m].
  [[nodiscard]] double extent() const { return extent_; }

 private:
  void follow();
  [[nodiscard]] Allowance made(double step, double rounding) const;

  const TheReference& reference_;
  double end_;                 // [s], of what is judged
  double speed_ = 0.0;         //
  double acceleration_ = 0.0;  //
  double turning_ = 0.0;       //
  double change_ = 0.0;        //
  double extent_ = 0.0;        //
  AlongMotion tangent_;        // [m / s], A for a step of one second
  AlongMotion of_cables_;      // [m / s], the same of the attachment points
  AlongMotion by_steps_;       // [m^2], of roundings in each second
  AlongMotion by_events_;      // [m^2], of roundings at events
  mutable std::map<std::pair<double, double>, Allowance> allowances_;  // by step and rounding
  mutable std::mutex guard_;
};

using Expectation = BasicExpectation<ReferenceCase>;
using SystemExpectation = BasicExpectation<ReferenceSystem>;

/// A run is compared with one of them.
using AnyExpectation = std::variant<Expectation, SystemExpectation>;
using Expectations = std::deque<AnyExpectation>;
/// For each of `references`, which must outlive them.
[[nodiscard]] Expectations expectations_of(const std::vector<Reference>& references);

}  // namespace tautline::bench
