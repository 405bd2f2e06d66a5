#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "tautline/solution.hpp"

namespace tautline {

/// Of an event without a jump.
template <class Real>
[[nodiscard]] BasicCableVector<Real> no_impulses(CableSet cables) {
  return BasicCableVector<Real>::Zero(static_cast<Eigen::Index>(cables.size()));
}

/// The arc of a body that stays where it is.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] BasicArc<TheCase> resting_arc(const Real& start, const Real& end,
                                            const StateOf<TheCase>& state, CableSet taut) {
  BasicArc<TheCase> rest{start, end, state, taut, {}};
  rest.series = resting_poses(state);
  return rest;
}

/// The body, the cables and gravity of `the_case`; `room` is for the cables.
template <class TheCase>
[[nodiscard]] TheCase system_of(const TheCase& the_case, std::vector<CableOf<TheCase>> room = {}) {
  TheCase result;
  bodies_of(result) = bodies_of(the_case);
  room = the_case.cables;
  result.cables = std::move(room);
  result.gravity = the_case.gravity;
  return result;
}

/// What has been found out of a motion, in order of time.
template <class TheCase>
struct Record {
  using Real = RealOf<TheCase>;

  std::vector<BasicArc<TheCase>> arcs;
  std::vector<BasicEvent<TheCase>> events;
  std::vector<BasicAccumulation<Real>> accumulations;
  std::optional<BasicSwing<Real>> swing;  // to and fro at its end, for ever
  std::optional<BasicRepetition<Real>> repetition;
  std::vector<CableOf<TheCase>> cables = {};  // of a solution before: room

  /// An empty one with the room that a solution has had: memory comes and goes in pages, which cost
  /// more than what is written there.
  [[nodiscard]] static Record in_room_of(BasicSolution<TheCase>&& solution) {
    Record record{std::move(solution.arcs_),
                  std::move(solution.events_),
                  std::move(solution.accumulations_),
                  {},
                  {},
                  std::move(solution.system_.cables)};
    record.arcs.clear();
    record.events.clear();
    record.accumulations.clear();
    return record;
  }

  /// Its end, of the motion of `the_case`: the record is then empty.
  [[nodiscard]] BasicSolution<TheCase> solution(const TheCase& the_case, Ending ending) {
    return {system_of(the_case, std::move(cables)),
            std::move(arcs),
            std::move(events),
            ending,
            std::move(accumulations),
            std::move(swing),
            std::move(repetition)};
  }
};

}  // namespace tautline
