// What a start on cables at zero gap leaves open: doubles hold few poses at which a gap is zero.

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

/// Begins with an impact. False where several cables pull and rounding decides which of them is the
/// first: where they are neither at zero gap to the last bit nor alike.
bool ErrorTracker::start(const Event& event) {
  close(event, event.cables);
  add_errors(now_, arc_rounding(sizes_, event.before, event.after, 0.0));
  const CableSet hit = pulled(event);
  return hit.size() <= 1 || are_exactly_taut(case_, event.before, hit) ||
         delay_of(case_, event.before, hit);
}

}  // namespace tautline
