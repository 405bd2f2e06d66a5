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

/// The arc of a body that stays where it is, but for its spin.
template <class Real>
[[nodiscard]] BasicArc<Real> resting_arc(const Real& start, const Real& end,
                                         const BasicState<Real>& state, CableSet taut) {
  BasicArc<Real> rest{start, end, state, taut, {}};
  rest.series.resize(2, 3);
  rest.series << state.position.x(), state.position.y(), state.angle, Real(0), Real(0), state.spin;
  return rest;
}

/// The body, the cables and gravity of `the_case`; `room` is for the cables.
template <class Real>
[[nodiscard]] BasicCase<Real> system_of(const BasicCase<Real>& the_case,
                                        std::vector<BasicCable<Real>> room = {}) {
  BasicCase<Real> result;
  result.body = the_case.body;
  room = the_case.cables;
  result.cables = std::move(room);
  result.gravity = the_case.gravity;
  return result;
}

/// What has been found out of a motion, in order of time.
template <class Real>
struct Record {
  std::vector<BasicArc<Real>> arcs;
  std::vector<BasicEvent<Real>> events;
  std::vector<BasicAccumulation<Real>> accumulations;
  std::optional<BasicSwing<Real>> swing;  // to and fro at its end, for ever
  std::optional<BasicRepetition<Real>> repetition;
  std::vector<BasicCable<Real>> cables = {};  // of a solution before: room

  /// An empty one with the room that a solution has had: memory comes and goes in pages, which cost
  /// more than what is written there.
  [[nodiscard]] static Record in_room_of(BasicSolution<Real>&& solution) {
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
  [[nodiscard]] BasicSolution<Real> solution(const BasicCase<Real>& the_case, Ending ending) {
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
