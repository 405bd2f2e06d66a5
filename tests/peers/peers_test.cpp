#include <gtest/gtest.h>

#include "measure.hpp"

// What the comparison of scripts/bench-peers stands on: peers and the exact solver have the same
// problem, and the arcs whose misses are counted do have an impact.

namespace tautline::peers {
namespace {

constexpr Effort effort = {1e-9, 0.01};
/// An instant is that many tolerances right at the first impact [s]: speeds are of order 1, and an
/// integrator holds the error of a step, of which there are some hundred.
constexpr double first_impact = 100.0;
constexpr std::uint64_t seed = 7;

TEST(Peers, AgreeWithTheExactSolverOnFirstImpacts) {
  const std::vector<KnownMotion> motions = known_motions(1);
  ASSERT_GE(motions.size(), 10U);
  for (const auto& peer : all_peers()) {
    const Accuracy found = accuracy(*peer, motions, effort);
    EXPECT_EQ(found.followed, found.of) << peer->name();
    EXPECT_LE(found.first, first_impact * effort.tolerance) << peer->name();
  }
}

TEST(Peers, FindADeepImpactOnTheGrazingArcs) {
  std::vector<Graze> arcs;
  for (Graze& arc : grazes(200, seed)) {
    if (arc.width > 5.0 * effort.longest_step) {  // a step or more ends below zero
      arcs.push_back(std::move(arc));
    }
  }
  ASSERT_GE(arcs.size(), 10U) << "seed " << seed;
  for (const auto& peer : all_peers()) {
    for (const std::size_t count : missed(*peer, arcs, effort).missed) {
      EXPECT_EQ(count, 0U) << peer->name() << ", seed " << seed;
    }
  }
}

TEST(Peers, TheExactSolverMissesNoGraze) {
  const std::unique_ptr<Peer> exact = exact_peer();
  for (const std::size_t count : missed(*exact, grazes(5000, seed), effort).missed) {
    EXPECT_EQ(count, 0U) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tautline::peers
