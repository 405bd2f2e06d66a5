#include "tautline/impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "support.hpp"
#include "tautline/geometry.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t impact_seed = 23;
constexpr int samples_per_count = 5000;

/// How far an impact is from the law and from the energy theorem, in units of rounding: all
/// relative to the largest rate before, or the energy before.
struct Errors {
  double complementarity = 0.0;
  double negative_impulse = 0.0;
  double energy_gain = 0.0;
  double energy_formula = 0.0;
};

Errors errors(const Case& the_case, const Impact& impact) {
  const State& before = the_case.initial;
  double fastest = 0.0;
  for (const Cable& cable : the_case.cables) {
    fastest = std::max(fastest, std::abs(gap_rate(cable, before)));
  }
  Errors result;
  double loss = 0.0;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const Cable& cable = the_case.cables[index];
    const double rate = gap_rate(cable, before);
    const double impulse = impact.impulses[static_cast<Eigen::Index>(index)];
    const double left = gap_rate(cable, impact.after) + cable.restitution * rate;
    const double diagonal = delassus(the_case, before, CableSet::of(index))(0, 0);
    const double broken = std::max(-left, std::min(std::abs(left), impulse * diagonal));
    result.complementarity = std::max(result.complementarity, broken / fastest);
    result.negative_impulse = std::max(result.negative_impulse, -impulse);
    loss -= 0.5 * impulse * (1.0 - cable.restitution) * rate;
  }
  const double kinetic = energy_scale(the_case);
  const double change = energy(the_case, impact.after) - energy(the_case, before);
  result.energy_gain = change / kinetic;
  result.energy_formula = std::abs(change + loss) / kinetic;
  return result;
}

class ImpactOnSeveralCables : public ::testing::TestWithParam<int> {
 protected:
  [[nodiscard]] std::size_t cables() const { return static_cast<std::size_t>(GetParam()); }
};

TEST_P(ImpactOnSeveralCables, IsComplementaryAndNeverGainsEnergy) {
  Random random(impact_seed);
  Errors worst;
  for (int sample = 0; sample < samples_per_count; ++sample) {
    const Case the_case = random_impact(random, cables());
    const Errors now =
        errors(the_case, newton_impact(the_case, the_case.initial, all_cables(the_case)));
    worst.complementarity = std::max(worst.complementarity, now.complementarity);
    worst.negative_impulse = std::max(worst.negative_impulse, now.negative_impulse);
    worst.energy_gain = std::max(worst.energy_gain, now.energy_gain);
    worst.energy_formula = std::max(worst.energy_formula, now.energy_formula);
  }
  std::cout << "  seed " << impact_seed << '\n';
  // random cables can be almost dependent: 1e-16 times the condition number of a 3 by 3 block,
  // seldom above 1e4 in as many draws
  constexpr double rounding = 1e-11;
  expect_within("complementarity", worst.complementarity, rounding);
  expect_within("negative impulse", worst.negative_impulse, 0.0);
  expect_within("energy gain", worst.energy_gain, rounding);
  expect_within("energy formula", worst.energy_formula, rounding);
}

TEST_P(ImpactOnSeveralCables, DoesNotDependOnTheirOrder) {
  Random random(impact_seed);
  double worst = 0.0;
  for (int sample = 0; sample < samples_per_count; ++sample) {
    const Case the_case = random_impact(random, cables());
    Case reversed = the_case;
    std::reverse(reversed.cables.begin(), reversed.cables.end());
    const State after = newton_impact(the_case, the_case.initial, all_cables(the_case)).after;
    const State other = newton_impact(reversed, the_case.initial, all_cables(the_case)).after;
    worst = std::max(worst, difference(after, other));
  }
  constexpr double rounding = 1e-9;  // velocities along almost dependent rows; see above, squared
  expect_within("difference of the states after", worst, rounding);
}

INSTANTIATE_TEST_SUITE_P(Cables, ImpactOnSeveralCables, ::testing::Range(1, 9));

TEST(SingleImpact, IsTheClosedForm) {
  Random random(impact_seed);
  double worst = 0.0;
  for (int sample = 0; sample < samples_per_count; ++sample) {
    const Case the_case = random_impact(random, 1);
    const Cable& cable = the_case.cables.front();
    const State& before = the_case.initial;
    const Vec2 arm = attachment_point(before, cable) - before.position;
    const Vec2 u = (attachment_point(before, cable) - cable.anchor).normalized();
    const double lever = cross(arm, u);
    const double inertia = the_case.body.inertia;
    const double turning = inertia > 0.0 ? lever * lever / inertia : 0.0;
    const double mobility = 1.0 / the_case.body.mass + turning;
    const double impulse = -(1.0 + cable.restitution) * gap_rate(cable, before) / mobility;
    const double got = newton_impact(the_case, before, CableSet::of(0)).impulses[0];
    worst = std::max(worst, std::abs(got - impulse) / std::max(impulse, 1e-3));
  }
  expect_within("relative error of the impulse", worst, 1e-13);  // rates may cancel to 1e-3
}

/// The standard breakwater near its equilibrium, both cables at zero gap: the left one rests, the
/// right one closes. `G12` is the off-diagonal term of the Delassus matrix.
Case left_rests_right_closes(Shape shape, double b) {
  Breakwater p;
  p.shape = shape;
  p.b = b;
  Case result = breakwater(p, "left rests, right closes");
  const State pose;
  const Eigen::Vector3d left = gap_gradient(result.cables[0], pose);
  const Eigen::Vector3d right = gap_gradient(result.cables[1], pose);
  // the part of -right that the left cable does not feel
  const Eigen::Vector3d motion = -(right - left * (left.dot(right) / left.squaredNorm()));
  result.initial = {pose.position, 0.0, motion.head<2>(), motion[2]};
  return result;
}

TEST(RestingCable, StaysRestingWhereTheOtherImpactPullsIt) {
  const Case the_case = left_rests_right_closes(Shape::ring, 0.0);
  const CableMatrix g = delassus(the_case, the_case.initial, all_cables(the_case));
  ASSERT_LT(g(0, 1), 0.0);
  const double rate = gap_rate(the_case.cables[1], the_case.initial);
  ASSERT_LT(rate, 0.0);
  const Impact impact = newton_impact(the_case, the_case.initial, all_cables(the_case));
  const double determinant = g(0, 0) * g(1, 1) - g(0, 1) * g(0, 1);
  constexpr double rounding = 1e-14;
  EXPECT_NEAR(gap_rate(the_case.cables[0], impact.after), 0.0, rounding);
  EXPECT_NEAR(gap_rate(the_case.cables[1], impact.after), -0.9 * rate, rounding);
  EXPECT_NEAR(impact.impulses[0], g(0, 1) * 1.9 * rate / determinant, rounding);
  EXPECT_NEAR(impact.impulses[1], -g(0, 0) * 1.9 * rate / determinant, rounding);
}

TEST(RestingCable, LeavesWhereTheOtherImpactSlackensIt) {
  const Case the_case = left_rests_right_closes(Shape::box, 0.1);
  const CableMatrix g = delassus(the_case, the_case.initial, all_cables(the_case));
  ASSERT_GT(g(0, 1), 0.0);
  const double rate = gap_rate(the_case.cables[1], the_case.initial);
  const Impact impact = newton_impact(the_case, the_case.initial, all_cables(the_case));
  constexpr double rounding = 1e-14;
  EXPECT_NEAR(impact.impulses[0], 0.0, rounding);
  EXPECT_NEAR(impact.impulses[1], -1.9 * rate / g(1, 1), rounding);
  EXPECT_NEAR(gap_rate(the_case.cables[0], impact.after), -1.9 * rate * g(0, 1) / g(1, 1),
              rounding);
}

TEST(RedundantCables, ActTogetherAsOne) {
  Random random(impact_seed);
  double worst = 0.0;
  for (int sample = 0; sample < samples_per_count; ++sample) {
    Case one = random_impact(random, 1);
    Case eight = one;
    eight.cables.assign(8, one.cables.front());
    for (std::size_t index = 0; index < 8; ++index) {  // different lengths of one line
      Cable& cable = eight.cables[index];
      const Vec2 point = attachment_point(one.initial, cable);
      const double factor = 1.0 + static_cast<double>(index);
      cable.anchor = point + factor * (cable.anchor - point);
      cable.length *= factor;
    }
    const State single = newton_impact(one, one.initial, all_cables(one)).after;
    const State many = newton_impact(eight, one.initial, all_cables(eight)).after;
    worst = std::max(worst, difference(single, many));
  }
  expect_within("difference from one cable", worst, 1e-12);  // lever / inertia up to 40 on 1e-15
}

TEST(MirroredImpact, IsTheMirrorImage) {
  Random random(impact_seed);
  double worst = 0.0;
  for (int sample = 0; sample < samples_per_count; ++sample) {
    const Case the_case = random_impact(random, 2);
    Case mirrored = the_case;
    for (Cable& cable : mirrored.cables) {
      cable.anchor.x() *= -1.0;
      cable.attachment.x() *= -1.0;
    }
    mirrored.initial.position.x() *= -1.0;
    mirrored.initial.velocity.x() *= -1.0;
    mirrored.initial.angle *= -1.0;
    mirrored.initial.spin *= -1.0;
    State after = newton_impact(mirrored, mirrored.initial, all_cables(mirrored)).after;
    after.position.x() *= -1.0;
    after.velocity.x() *= -1.0;
    after.angle *= -1.0;
    after.spin *= -1.0;
    const State expected = newton_impact(the_case, the_case.initial, all_cables(the_case)).after;
    worst = std::max(worst, difference(after, expected));
  }
  expect_within("difference from the mirror image", worst, 0.0);  // signs do not round
}

}  // namespace
}  // namespace tautline::test
