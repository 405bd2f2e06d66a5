#pragma once

#include "loop/record.hpp"
#include "tautline/case.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solution.hpp"

// A gap is the difference of positions and has their rounding. The solver looks at a system far
// from the origin from near by, where the numbers of the input lose nothing.

namespace tautline {

/// Where to look at the case from: the origin, unless the anchor of the shortest cable is many
/// lengths away.
template <class Real>
[[nodiscard]] BasicVec2<Real> local_origin(const BasicCase<Real>& the_case) {
  constexpr double far = 16.0;  // [-] lengths: four bits of a gap
  const auto shortest =
      std::min_element(the_case.cables.begin(), the_case.cables.end(),
                       [](const auto& a, const auto& b) { return a.length < b.length; });
  return shortest->anchor.norm() > far * shortest->length
             ? shortest->anchor
             : BasicVec2<Real>(BasicVec2<Real>::Zero());
}

/// The same case with the world's origin at `origin`.
template <class Real>
[[nodiscard]] BasicCase<Real> seen_from(const BasicVec2<Real>& origin, BasicCase<Real> the_case) {
  for (BasicCable<Real>& cable : the_case.cables) {
    cable.anchor -= origin;
  }
  the_case.initial.position -= origin;
  if (the_case.ceiling) {
    *the_case.ceiling -= origin.y();
  }
  return the_case;
}

/// The same motion with the world's origin at `origin`, where it is that of `the_case`.
template <class Real>
[[nodiscard]] BasicSolution<BasicCase<Real>> seen_from(
    const BasicVec2<Real>& origin, const BasicSolution<BasicCase<Real>>& solution,
    const BasicCase<Real>& the_case) {
  std::vector<BasicArc<BasicCase<Real>>> arcs = solution.arcs();
  for (BasicArc<BasicCase<Real>>& arc : arcs) {
    arc.initial.position -= origin;
    if (arc.series.rows() > 0) {
      arc.series(0, 0) -= origin.x();
      arc.series(0, 1) -= origin.y();
    }
  }
  std::vector<BasicEvent<BasicCase<Real>>> events = solution.events();
  for (BasicEvent<BasicCase<Real>>& event : events) {
    event.before.position -= origin;
    event.after.position -= origin;
  }
  return {system_of(the_case),      std::move(arcs),  std::move(events),    solution.ending(),
          solution.accumulations(), solution.swing(), solution.repetition()};
}

}  // namespace tautline
