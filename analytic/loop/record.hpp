#pragma once

#include <utility>
#include <vector>

#include "tautline/solution.hpp"

namespace tautline {

/// What has been found out of a motion, in order of time.
template <class Real>
struct Record {
  std::vector<BasicArc<Real>> arcs;
  std::vector<BasicEvent<Real>> events;
  std::vector<BasicAccumulation<Real>> accumulations;

  /// Its end: the record is then empty.
  [[nodiscard]] BasicSolution<Real> solution(const BasicVec2<Real>& gravity, Ending ending) {
    return {gravity, std::move(arcs), std::move(events), ending, std::move(accumulations)};
  }
};

}  // namespace tautline
