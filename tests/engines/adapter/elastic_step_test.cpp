#include "tautline/elastic_step.hpp"

#include <gtest/gtest.h>

#include "tautline/elasticity.hpp"
#include "tautline/system.hpp"

// Elastic cables at the start of a step.

namespace tautline::test {
namespace {

using Vec3 = Eigen::Vector3d;

/// A body that a cable of 1 m without a cut pulls at off its centre: how the cable feels the mass
/// depends on where the body is.
SpatialSystem on_a_damper() {
  SpatialSystem result;
  SpatialBody body;
  body.inertia = Vec3::Constant(0.01);
  result.bodies = {body};
  SpatialCable cable;
  cable.from = {0, Vec3(0.2, 0.0, 0.1), {}};
  cable.length = Function<1>::constant(1.0);
  cable.elasticity = Elasticity{{2e3}, 0.0, 0.5};
  cable.elasticity->cut = ElasticCut::never;
  result.cables = {cable};
  result.initial.bodies = {SpatialState()};
  return result;
}

TEST(ZonesOfAStep, WithoutACutKeepTheDampingOfTheStart) {
  const SpatialSystem system = on_a_damper();
  SpatialSystemState state = system.initial;
  const auto at = [&](const Vec3& place) {
    state.bodies[0].position = place;
    state = with_zones_of_step(system, state);
    return state.elastic.damping.at(0);
  };
  const double at_start = at(Vec3(0.0, 0.0, -1.3));
  ASSERT_TRUE(state.elastic.engaged.contains(0));
  for (const double way : {0.5, 1.3, 0.5}) {  // slack, stretched and slack, from another side
    EXPECT_EQ(at(Vec3(way, 0.0, 0.0)), at_start) << way;
    EXPECT_EQ(state.elastic.engaged.contains(0), way > 1.0);
    EXPECT_EQ(state.elastic.resisting.contains(0), way < 1.0);
  }
}

TEST(ZonesOfAStep, WithACutFindTheDampingOfEachEntry) {
  SpatialSystem system = on_a_damper();
  for (const ElasticCut cut : {ElasticCut::force, ElasticCut::stretch}) {
    system.cables[0].elasticity->cut = cut;
    SpatialSystemState state = system.initial;
    state.bodies[0].position = Vec3(0.0, 0.0, -1.3);
    state = with_zones_of_step(system, state);
    const double first = state.elastic.damping.at(0);
    state.bodies[0].position = Vec3(0.5, 0.0, 0.0);
    state = with_zones_of_step(system, state);
    EXPECT_FALSE(state.elastic.pulling().contains(0));
    state.bodies[0].position = Vec3(1.3, 0.0, 0.0);
    state = with_zones_of_step(system, state);
    EXPECT_NE(state.elastic.damping.at(0), first);
  }
}

}  // namespace
}  // namespace tautline::test
