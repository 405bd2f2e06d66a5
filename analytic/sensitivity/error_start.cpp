// What a start on cables at zero gap leaves open: doubles hold few poses at which a gap is zero.

#include <algorithm>
#include <array>
#include <cmath>

#include "error_tracker.hpp"
#include "simultaneous.hpp"
#include "tangent.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
/// Adds what closing the gaps of the taut cables and of `more` adds to the errors of the pose.
void ErrorTracker::close(const Event& event, CableSet more) {
  look_at(event.before);
  const CableSet rows = basis(case_, event.before, taut_ | more);
  std::array<double, 3> gaps{};
  std::size_t row = 0;
  for (const std::size_t index : rows) {
    gaps[row++] = gap_error(index, event.before);
  }
  const Eigen::Vector3d off = closing_errors(case_, event.before, rows, gaps);
  now_.diagonal().head<3>() += off.cwiseAbs2();
}

/// How far the gap of a cable whose views are at the pose of `state` may be off zero [m].
double ErrorTracker::gap_error(std::size_t index, const State& state) const {
  return std::abs(views_[index].gap()) + 4 * one_rounding * gap_scale(case_, index, state);
}

/// Takes an impact at the start, which comes as much later as its cable's gap is open. False where
/// several cables pull, at once or after each other, and rounding decides which of them is the
/// first: where they are neither at zero gap to the last bit nor alike.
bool ErrorTracker::start(const Event& event) {
  started_ = started_ | pulled(event);
  if (next_ > 0) {
    return is_one_start(event);
  }
  close(event, event.cables);
  add_errors(now_, arc_rounding(sizes_, event.before, event.after, 0.0));
  double late = 0.0;
  for (const std::size_t index : started_) {
    const double rate = -views_[index].rate(event.before);
    late = std::max(late, rate > 0.0 ? gap_error(index, event.before) / rate : 0.0);
  }
  StateVector rate;
  rate << event.before.velocity, event.before.spin, case_.gravity, 0.0;
  add_errors(now_, late * rate);
  now_(6, 6) += late * late;
  return is_one_start(event);
}

/// True where the cables that pulled at the start do so at one instant, or are one.
bool ErrorTracker::is_one_start(const Event& event) {
  if (started_.size() <= 1 || are_exactly_taut(case_, event.before, started_) ||
      (next_ == 0 && delay_of(event, started_))) {
    return true;
  }
  tie_ = Tie{EventKind::impact, started_};
  return false;
}

}  // namespace tautline
