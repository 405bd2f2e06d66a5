// What the impact laws have in common, and where they part (analytic/README.md section 4).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "support.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t law_seed = 29;

Impact resolved(ImpactLaw law, const Case& the_case) {
  return resolve_impact(law, the_case, the_case.initial, all_cables(the_case));
}

CableVector rates(const Case& the_case, const State& state) {
  return gap_rates(the_case, state, all_cables(the_case));
}

CableVector rates_after(ImpactLaw law, const Case& the_case) {
  return rates(the_case, resolved(law, the_case).after);
}

/// The largest difference of two sets of rates, against the largest rate before.
double scaled_difference(const Case& the_case, const CableVector& a, const CableVector& b) {
  const double scale = rates(the_case, the_case.initial).cwiseAbs().maxCoeff();
  return (a - b).cwiseAbs().maxCoeff() / scale;
}

Case with_restitution(Case the_case, double restitution) {
  for (Cable& cable : the_case.cables) {
    cable.restitution = restitution;
  }
  return the_case;
}

/// Two cables whose Delassus matrix is (1, coupling; coupling, 1) and whose rates are given: a
/// point mass of 1, the first cable straight up, the second at an angle with that cosine.
Case two_cables(double coupling, const Vec2& wanted, double e) {
  Case result;
  result.body = {1.0, 0.0};
  const double across = std::sqrt(1.0 - coupling * coupling);
  result.cables = {Cable{Vec2(0.0, 1.0), Vec2::Zero(), 1.0, e},
                   Cable{Vec2(across, coupling), Vec2::Zero(), 1.0, e}};
  // a gap rate is the velocity's component towards the anchor
  result.initial.velocity = Vec2((wanted.y() - coupling * wanted.x()) / across, wanted.x());
  return result;
}

/// A set of 1 to 8 closing cables, some of them brought to rest where that leaves the others
/// closing or resting, and some of them doubled: rows that depend on each other.
Case any_impact(Random& random) {
  Case result = random_impact(random, 1 + static_cast<std::size_t>(random.uniform(0.0, 8.0)));
  if (result.cables.size() > 1 && random.chance(0.3)) {
    const State still = with_zero_rates(result, result.initial, CableSet::of(0));
    if (rates(result, still).maxCoeff() <= 1e-15) {
      result.initial = still;
    }
  }
  if (result.cables.size() < max_cables && random.chance(0.3)) {
    result.cables.push_back(result.cables.front());
    result.cables.back().restitution = random.uniform(0.0, 1.0);
  }
  return result;
}

class EveryLaw : public ::testing::TestWithParam<ImpactLaw> {};

TEST_P(EveryLaw, IsNewtonsForOneCable) {
  Random random(law_seed);
  double worst = 0.0;
  for (int sample = 0; sample < 2000; ++sample) {
    const Case the_case = random_impact(random, 1);
    const double expected = resolved(ImpactLaw::simultaneous, the_case).impulses[0];
    const double got = resolved(GetParam(), the_case).impulses[0];
    worst = std::max(worst, std::abs(got - expected) / expected);
  }
  expect_within("relative difference of the impulse", worst, 1e-14);
}

TEST_P(EveryLaw, NeverGainsEnergyAndLeavesNothingClosing) {
  Random random(law_seed);
  double gain = -1.0;
  double closing = 0.0;
  double pushed = 0.0;
  for (int sample = 0; sample < 20'000; ++sample) {
    const Case the_case = any_impact(random);
    const Impact impact = resolved(GetParam(), the_case);
    ASSERT_TRUE(impact.impulses.allFinite()) << "sample " << sample << " of seed " << law_seed;
    const double before = kinetic_energy(the_case.body, the_case.initial);
    gain = std::max(gain, kinetic_energy(the_case.body, impact.after) / before - 1.0);
    closing = std::max(closing, -rates(the_case, impact.after).minCoeff() /
                                    speed_scale(the_case, the_case.initial));
    pushed = std::max(pushed, -impact.impulses.minCoeff());
  }
  // almost dependent cables: rounding times the condition of a 3 by 3 block, as in impact_test
  expect_within("energy gain", gain, 1e-11);
  expect_within("closing rate left", closing, 1e-11);
  expect_within("negative impulse", pushed, 0.0);
}

TEST_P(EveryLaw, StopsDeadWithoutRestitutionAtRightAngles) {
  const Case the_case = two_cables(0.0, Vec2(-1.0, -0.3), 0.0);
  EXPECT_LE(rates_after(GetParam(), the_case).cwiseAbs().maxCoeff(), 1e-15);
}

TEST_P(EveryLaw, TreatsCablesAtRightAnglesAsIndependent) {
  // G12 = 0: no cable feels the other's impulse
  Case the_case = two_cables(0.0, Vec2(-1.0, -0.3), 0.9);
  the_case.cables[1].restitution = 0.4;
  const CableVector after = rates_after(GetParam(), the_case);
  constexpr double rounding = 1e-14;  // of the ends of a spring's swing, some ten ulp
  EXPECT_NEAR(after[0], 0.9, rounding);
  EXPECT_NEAR(after[1], 0.12, rounding);
}

TEST_P(EveryLaw, GivesNumbersThatDoNotFitAsNaN) {
  Case the_case = two_cables(-0.2, Vec2(-1.0, -0.8), 0.9);
  the_case.initial.velocity *= std::numeric_limits<double>::infinity();
  EXPECT_TRUE(resolved(GetParam(), the_case).impulses.array().isNaN().all());
}

/// Three cables through its centre leave the body no way to go; a fourth, hit by its spin, pulls it
/// against them. Elastic ones would be struck in turn forever.
TEST_P(EveryLaw, EndsWhereElasticCablesLeaveTheBodyNoWayToGo) {
  Case the_case;
  the_case.body = {1.0, 0.1};
  for (const double angle : {0.5, 2.6, 4.7}) {
    the_case.cables.push_back(
        Cable{Vec2(std::cos(angle), std::sin(angle)), Vec2::Zero(), 1.0, 1.0});
  }
  the_case.cables.push_back(Cable{Vec2(0.5, 1.0), Vec2(0.3, 0.0), std::hypot(0.2, 1.0), 1.0});
  the_case.initial.spin = -1.0;
  const Impact impact = resolved(GetParam(), the_case);
  ASSERT_TRUE(impact.impulses.allFinite());
  const double before = kinetic_energy(the_case.body, the_case.initial);
  EXPECT_LE(kinetic_energy(the_case.body, impact.after), before * (1.0 + 1e-13));
  EXPECT_GE(rates(the_case, impact.after).minCoeff(), -1e-11);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, ::testing::ValuesIn(impact_laws),
                         [](const auto& law) { return std::string(to_string(law.param)); });

TEST(OneRestitution, MakesSimultaneousAndPoissonTheSame) {
  Random random(law_seed);
  double worst = 0.0;
  for (int sample = 0; sample < 20'000; ++sample) {
    const Case the_case = with_restitution(any_impact(random), random.uniform(0.0, 1.0));
    const Impact lcp = resolved(ImpactLaw::simultaneous, the_case);
    const Impact poisson = resolved(ImpactLaw::poisson, the_case);
    worst = std::max(worst, scaled_difference(the_case, rates(the_case, lcp.after),
                                              rates(the_case, poisson.after)));
  }
  // rates of well conditioned pairs agree to 1e-14; eight cables reach a condition of some 1e3
  expect_within("difference of the rates after", worst, 1e-11);
}

TEST(OneRestitution, MakesThemTheSameToRoundingForTwoCables) {
  Random random(law_seed);
  double worst = 0.0;
  for (int sample = 0; sample < 20'000; ++sample) {
    const double first = -random.uniform(0.0, 1.0);
    const Case the_case =
        two_cables(random.uniform(-0.8, 0.8), Vec2(first, -1.0), random.uniform(0.0, 1.0));
    worst =
        std::max(worst, scaled_difference(the_case, rates_after(ImpactLaw::simultaneous, the_case),
                                          rates_after(ImpactLaw::poisson, the_case)));
  }
  expect_within("difference of the rates after", worst, 1e-14);
}

TEST(SeveralRestitutions, PartSimultaneousAndPoisson) {
  // both are compressed; Moreau's rates are e_i times those before, Poisson's rates feel the
  // impulses the other gives back: E P rather than G^-1 E v
  Case the_case = two_cables(-0.5, Vec2(-1.0, -1.0), 0.0);
  the_case.cables[0].restitution = 0.5;
  constexpr double rounding = 1e-15;
  const CableVector lcp = rates_after(ImpactLaw::simultaneous, the_case);
  EXPECT_NEAR(lcp[0], 0.5, rounding);
  EXPECT_NEAR(lcp[1], 0.0, rounding);
  // compression impulses (2, 2); the first gives back 1, which is 1 and -1/2 in the rates; the
  // second then takes 1/2 more, which is -1/4 in the first
  const CableVector poisson = rates_after(ImpactLaw::poisson, the_case);
  EXPECT_NEAR(poisson[0], 0.75, rounding);
  EXPECT_NEAR(poisson[1], 0.0, rounding);
}

TEST(SeveralRestitutions, LetPoissonTakeBackWhatWouldGainEnergy) {
  // nearly opposed cables: compression impulses (10, 10) all but cancel. One of them given back in
  // full makes the rates (10, -9), five times the energy; stopping the other leaves 19/20 of it
  Case the_case = two_cables(-0.9, Vec2(-1.0, -1.0), 0.0);
  the_case.cables[0].restitution = 1.0;
  const State after = resolved(ImpactLaw::poisson, the_case).after;
  constexpr double rounding = 1e-14;
  EXPECT_NEAR(rates(the_case, after)[0], 1.9, 10.0 * rounding);
  EXPECT_NEAR(rates(the_case, after)[1], 0.0, rounding);
  const double before = the_case.initial.velocity.squaredNorm();
  EXPECT_NEAR(after.velocity.squaredNorm() / before, 0.95, 10.0 * rounding);
}

TEST(Sequential, FollowsTheWorkedExample) {
  // e = 0.9, rates 1 and 0.8, coupling -0.2: the fastest first
  Case the_case = two_cables(-0.2, Vec2(-1.0, -0.8), 0.9);
  constexpr double printed = 5e-4;  // four digits
  CableVector after = rates_after(ImpactLaw::sequential, the_case);
  EXPECT_NEAR(after[0], 0.4516, printed);
  EXPECT_NEAR(after[1], 1.062, printed);
  // the fastest first, whichever it is
  the_case = two_cables(-0.2, Vec2(-0.8, -1.0), 0.9);
  after = rates_after(ImpactLaw::sequential, the_case);
  EXPECT_NEAR(after[1], 0.4516, printed);
  EXPECT_NEAR(after[0], 1.062, printed);
  after = rates_after(ImpactLaw::simultaneous, the_case);
  EXPECT_NEAR(after[0], 0.72, 1e-15);
  EXPECT_NEAR(after[1], 0.9, 1e-15);
}

TEST(Sequential, TakesTheLowestIndexOnATie) {
  const Case the_case = two_cables(-0.5, Vec2(-1.0, -1.0), 0.5);
  // hit 0: (0.5, -1.75); hit 1 by (1.5)(1.75) = 2.625: (-0.8125, 0.875); hit 0 by 1.21875:
  // (0.40625, 0.265625)
  const CableVector after = rates_after(ImpactLaw::sequential, the_case);
  constexpr double rounding = 1e-15;
  EXPECT_NEAR(after[0], 0.40625, rounding);
  EXPECT_NEAR(after[1], 0.265625, rounding);
}

TEST(Sequential, NeedsFiniteHitsBelowTheLimitAndCollapsesAboveIt) {
  // the number of hits is finite where p < 2 sqrt(e) / (1 + e), p = -G12: above, they shrink
  // geometrically and leave no rate at all
  constexpr double e = 0.05;
  const double limit = 2.0 * std::sqrt(e) / (1.0 + e);
  const Vec2 before(-1.0, -0.9);
  const CableVector below = rates_after(ImpactLaw::sequential, two_cables(-0.9 * limit, before, e));
  const CableVector above =
      rates_after(ImpactLaw::sequential, two_cables(-std::min(0.999, 1.02 * limit), before, e));
  EXPECT_GT(below.maxCoeff(), 1e-6);
  EXPECT_LT(above.cwiseAbs().maxCoeff(), 1e-13);
}

/// Cable 0 is taut and rests, cable 1 hits with rate -1.
TEST(TautCable, IsKeptTautByTheLcpWhereTheHitPullsIt) {
  constexpr double e = 0.7;
  constexpr double p = 0.3;
  const Case the_case = two_cables(-p, Vec2(0.0, -1.0), e);
  constexpr double rounding = 1e-15;
  for (const ImpactLaw law : {ImpactLaw::simultaneous, ImpactLaw::poisson}) {
    const Impact impact = resolved(law, the_case);
    const CableVector after = rates(the_case, impact.after);
    EXPECT_NEAR(after[0], 0.0, rounding) << to_string(law);
    EXPECT_NEAR(after[1], e, rounding) << to_string(law);
    const double determinant = 1.0 - p * p;
    EXPECT_NEAR(impact.impulses[0], p * (1.0 + e) / determinant, rounding) << to_string(law);
    EXPECT_NEAR(impact.impulses[1], (1.0 + e) / determinant, rounding) << to_string(law);
  }
}

TEST(TautCable, IsLeftSlackBySequentialHits) {
  constexpr double e = 0.7;
  constexpr double p = 0.3;
  const CableVector after = rates_after(ImpactLaw::sequential, two_cables(-p, Vec2(0.0, -1.0), e));
  constexpr double rounding = 1e-15;
  EXPECT_NEAR(after[0], e * (1.0 + e) * p, rounding);
  EXPECT_NEAR(after[1], e - (1.0 + e) * (1.0 + e) * p * p, rounding);
}

TEST(TautCable, IsSlackenedByAllLawsAlikeWhereTheHitPushesIt) {
  constexpr double e = 0.7;
  constexpr double g = 0.3;
  const Case the_case = two_cables(g, Vec2(0.0, -1.0), e);
  for (const ImpactLaw law : impact_laws) {
    const CableVector after = rates_after(law, the_case);
    EXPECT_NEAR(after[0], (1.0 + e) * g, 1e-14) << to_string(law);
    EXPECT_NEAR(after[1], e, 1e-14) << to_string(law);
  }
}

/// Both springs swing together, as one.
TEST(Energetic, IsNewtonsForASymmetricPair) {
  Random random(law_seed);
  double worst = 0.0;
  for (int sample = 0; sample < 2000; ++sample) {
    const double e = random.uniform(0.05, 1.0);
    const Case the_case = two_cables(random.uniform(-0.9, 0.9), Vec2(-1.0, -1.0), e);
    worst = std::max(worst, scaled_difference(the_case, rates_after(ImpactLaw::energetic, the_case),
                                              rates_after(ImpactLaw::simultaneous, the_case)));
  }
  // an ulp of the compression is e^-2 of it in the force on the steep line: 400 of them
  expect_within("difference of the rates after", worst, 1e-12);
}

TEST(Energetic, GivesBackAllTheEnergyOfElasticCables) {
  Random random(law_seed);
  double worst = 0.0;
  for (int sample = 0; sample < 2000; ++sample) {
    const auto count = 2 + static_cast<std::size_t>(random.uniform(0.0, 2.0));
    const Case the_case = with_restitution(random_impact(random, count), 1.0);
    const double before = kinetic_energy(the_case.body, the_case.initial);
    const double after =
        kinetic_energy(the_case.body, resolved(ImpactLaw::energetic, the_case).after);
    worst = std::max(worst, std::abs(after / before - 1.0));
  }
  expect_within("relative change of the energy", worst, 1e-12);  // some 50 steps of a few ulp
}

TEST(Energetic, HasNoJumpAtRestitutionZero) {
  // what is held at its largest compression is the limit of ever steeper lines
  for (const double coupling : {-0.6, -0.2, 0.3}) {
    const Vec2 before(-1.0, -0.4);
    const CableVector zero = rates_after(ImpactLaw::energetic, two_cables(coupling, before, 0.0));
    const CableVector small = rates_after(ImpactLaw::energetic, two_cables(coupling, before, 1e-3));
    // velocities swing by the restitution's size on the steep line
    EXPECT_LE((zero - small).cwiseAbs().maxCoeff(), 5e-3) << "coupling " << coupling;
  }
}

/// The same law by a second route: small steps of the force laws.
Vec2 by_small_steps(double coupling, const Vec2& before, const Vec2& e) {
  constexpr double dt = 2e-6;
  Vec2 rate = before;
  Vec2 compression = Vec2::Zero();
  Vec2 largest = Vec2::Zero();
  for (int step = 0; step < 20'000'000; ++step) {
    Vec2 force;
    for (int i = 0; i < 2; ++i) {
      largest[i] = std::max(largest[i], compression[i]);
      const double back = largest[i] - (largest[i] - compression[i]) / (e[i] * e[i]);
      force[i] = std::max(0.0, std::min(compression[i], back));
    }
    if (force.isZero(0.0) && rate.minCoeff() >= 0.0 && step > 0) {
      break;
    }
    rate += dt * Vec2(force[0] + coupling * force[1], coupling * force[0] + force[1]);
    compression -= dt * rate;
  }
  return rate;
}

TEST(Energetic, IsTheLimitOfSmallSteps) {
  const struct {
    double coupling;
    Vec2 before;
    Vec2 e;
  } examples[] = {{-0.2, {-1.0, -0.8}, {0.9, 0.9}},
                  {-0.6, {-1.0, -0.1}, {0.7, 0.3}},
                  {-0.3, {0.0, -1.0}, {0.7, 0.7}},
                  {0.5, {-1.0, -0.9}, {0.5, 0.95}}};
  for (const auto& example : examples) {
    Case the_case = two_cables(example.coupling, example.before, 1.0);
    the_case.cables[0].restitution = example.e[0];
    the_case.cables[1].restitution = example.e[1];
    const CableVector after = rates_after(ImpactLaw::energetic, the_case);
    const Vec2 expected = by_small_steps(example.coupling, example.before, example.e);
    // semi-implicit Euler is of first order
    EXPECT_NEAR(after[0], expected[0], 1e-4) << "coupling " << example.coupling;
    EXPECT_NEAR(after[1], expected[1], 1e-4) << "coupling " << example.coupling;
  }
}

}  // namespace
}  // namespace tautline::test
