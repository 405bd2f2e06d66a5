// The largest tension and the largest impulse of a draw, beside closed forms and the long way.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/ensemble/largest_tension.hpp"
#include "bench/ensemble/output/comparison.hpp"
#include "bench/ensemble/output/output.hpp"
#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"
#include "tests/bench/ensemble/solved.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

/// Of a largest tension or impulse [-]: rounding of the motion, and the ten digits of a swing that
/// is told ahead.
constexpr double right_motion = 1e-11;
constexpr double right_swing = 1e-10;

/// The draws of one case and its two largest numbers.
class LargestOf {
 public:
  /// `vary` are tables [[vary]] of a spec.
  LargestOf(const std::string& the_case, const std::string& vary)
      : request_(request_of("case = \"" + folder_.file("case.toml", the_case).string() +
                            "\"\ncount = 40\n" + vary)),
        result_(solved(request_)) {}

  [[nodiscard]] std::size_t size() const { return result_.draws.front().size(); }
  [[nodiscard]] Case the_case(std::size_t draw) const {
    return std::get<Case>(case_of(request_.spec, request_.setups.front(), draw));
  }
  [[nodiscard]] double value(std::size_t draw, const std::string& name) const {
    const std::size_t place = place_of_statistic(statistics_of(request_.spec), name);
    return result_.draws.front().value(draw, place).value();
  }

  /// Expects `wanted` of each draw's case.
  template <class Wanted>
  void expect(const std::string& name, const Wanted& wanted) const {
    for (std::size_t draw = 0; draw < size(); ++draw) {
      const double right = wanted(the_case(draw));
      EXPECT_NEAR(value(draw, name), right, right_motion * right) << name << " of draw " << draw;
    }
  }

 private:
  test::TemporaryFolder folder_;
  EnsembleRequest request_;
  EnsembleResult result_;
};

/// A point mass on a cable of 2 m from the origin.
std::string on_one_cable(const std::string& position, const std::string& velocity,
                         double duration = 20.0) {
  return "name = \"one\"\nduration = " + std::to_string(duration) +
         "\ngravity = [0.0, -9.81]\n[body]\nmass = 1.0\ninertia = 0.0\n"
         "[[cables]]\nanchor = [0.0, 0.0]\nattachment = [0.0, 0.0]\nlength = 2.0\n"
         "restitution = 0.5\n[initial]\nposition = " +
         position + "\nvelocity = " + velocity + "\n";
}

const std::string vary_mass = "[[vary]]\nquantities = [\"mass\"]\nuniform = [0.5, 20]\n";
const std::string weightless = "[[vary]]\nquantities = [\"gravity_y\"]\nlist = [0]\n";

TEST(LargestTension, OfAPendulumIsThatOfItsLowestPoint) {
  const LargestOf draws(
      on_one_cable("[1.2, -1.6]", "[0.0, 0.0]"),
      vary_mass + "[[vary]]\nquantities = [\"gravity_y\"]\nuniform = [-20, -2]\n");
  draws.expect("largest_tension", [](const Case& the_case) {
    constexpr double cosine = 0.8;  // of the start
    return the_case.body.mass * the_case.gravity.norm() * (3.0 - 2.0 * cosine);
  });
  draws.expect("largest_impulse", [](const Case&) { return 0.0; });
}

// from the side, where its cable pulls with nothing, or with the little that a push gives
TEST(LargestTension, OfAPendulumThatGoesRoundIsThatOfItsLowestPoint) {
  const LargestOf draws(on_one_cable("[2.0, 0.0]", "[0.0, 0.0]"),
                        vary_mass + "[[vary]]\nquantities = [\"velocity_y\"]\nuniform = [8, 12]\n");
  draws.expect("largest_tension", [](const Case& the_case) {
    const double speed = the_case.initial.velocity.y();
    return the_case.body.mass * (3.0 * 9.81 + speed * speed / 2.0);
  });
}

TEST(LargestTension, OfACircleIsMassTimesSpeedSquaredByLength) {
  const LargestOf draws(
      on_one_cable("[2.0, 0.0]", "[0.0, 0.0]"),
      vary_mass + weightless + "[[vary]]\nquantities = [\"velocity_y\"]\nuniform = [0.1, 5]\n");
  draws.expect("largest_tension", [](const Case& the_case) {
    return the_case.body.mass * the_case.initial.velocity.squaredNorm() / 2.0;
  });
}

/// A box on slings that hang from a ceiling, all upright while it hangs still; it is let go aside,
/// where they have turned by an angle of cosine 0.8.
std::string on_slings(const std::vector<double>& places) {
  std::string text =
      "name = \"slings\"\nduration = 20.0\ngravity = [0.0, -9.81]\n"
      "[body]\nmass = 2.0\ninertia = 0.5\n[initial]\nposition = [1.2, -1.6]\n";
  for (const double place : places) {
    text += "[[cables]]\nanchor = [" + std::to_string(place) +
            ", 0.0]\nlength = 2.0\nrestitution = 0.5\nattachment = [" + std::to_string(place) +
            ", 0.0]\n";
  }
  return text;
}

TEST(LargestTension, OfParallelSlingsIsSharedByThem) {
  const LargestOf two(on_slings({-0.5, 0.5}), vary_mass);
  two.expect("largest_tension", [](const Case& the_case) {
    return the_case.body.mass * 9.81 * (3.0 - 2.0 * 0.8) / 2.0;
  });
  // statics do not say what each of three takes: the least sum of squares is an even share
  const LargestOf three(on_slings({-0.5, 0.0, 0.5}), vary_mass);
  three.expect("largest_tension", [](const Case& the_case) {
    return the_case.body.mass * 9.81 * (3.0 - 2.0 * 0.8) / 3.0;
  });
}

TEST(LargestImpulse, OfAPointMassIsThatOfItsOneImpact) {
  const LargestOf draws(on_one_cable("[0.0, -1.0]", "[0.0, 0.0]", 2.0),
                        vary_mass + weightless +
                            "[[vary]]\nquantities = [\"velocity_y\"]\nuniform = [-3, -1]\n"
                            "[[vary]]\nquantities = [\"restitution\"]\nuniform = [0, 1]\n");
  draws.expect("largest_impulse", [](const Case& the_case) {
    return the_case.body.mass * -the_case.initial.velocity.y() *
           (1.0 + the_case.cables.front().restitution);
  });
  draws.expect("largest_tension", [](const Case&) { return 0.0; });  // never taut
}

TEST(LargestImpulse, OfRedundantSlingsIsSharedByThem) {
  std::string falling = on_slings({-0.5, 0.0, 0.5});
  const std::string aside = "position = [1.2, -1.6]";
  falling.replace(falling.find(aside), aside.size(), "position = [0.0, -1.0]");
  const LargestOf draws(falling, vary_mass);
  draws.expect("largest_impulse", [](const Case& the_case) {
    return the_case.body.mass * std::sqrt(2.0 * 9.81 * 1.0) * (1.0 + 0.5) / 3.0;
  });
}

// swings that are told ahead and swings that are followed, taut phases in between
class LargestOfTheChapter : public ::testing::TestWithParam<const char*> {};

TEST_P(LargestOfTheChapter, IsThatOfTheWholeMotion) {
  const EnsembleRequest request = request_of(perturbed(GetParam(), 10));
  const EnsembleResult result = solved(request);
  const std::size_t place = place_of_statistic(statistics_of(request.spec), "largest_tension");
  for (std::size_t draw = 0; draw < 10; ++draw) {
    const auto the_case = std::get<Case>(case_of(request.spec, request.setups.front(), draw));
    const Solution solution = solve(the_case, {.until_locked = true});
    const double right = tautline::test::largest_sampled_tension(solution);
    const double found = result.draws.front().value(draw, place).value();
    EXPECT_NEAR(found, right, right_swing * right) << "draw " << draw;
    EXPECT_NEAR(largest_tension(solution), right, right_motion * right) << "draw " << draw;
  }
}

INSTANTIATE_TEST_SUITE_P(Ensemble, LargestOfTheChapter,
                         ::testing::Values("1910121100", "1510121100", "1710121100", "1933121100",
                                           "1921121100", "1900461100", "1110121100"),
                         [](const auto& drawn) { return std::string(drawn.param); });

TEST(LargestTension, OfRandomMotionsIsThatOfTheirArcs) {
  tautline::test::Random random(20261127);
  int taut = 0;
  double worst = 0.0;
  for (int sample = 0; sample < 150; ++sample) {
    const Case the_case =
        tautline::test::random_case(random, {1 + static_cast<std::size_t>(sample % 4), 0.0, 0.5});
    const Solution solution = solve(the_case);
    const double right = tautline::test::largest_sampled_tension(solution);
    const double found = largest_tension(solution);
    if (right > 0.0) {
      ++taut;
      worst = std::max(worst, std::abs(found / right - 1.0));
    } else {
      EXPECT_EQ(found, 0.0) << sample;
    }
  }
  EXPECT_GT(taut, 75);
  tautline::test::expect_within("difference of the largest tension", worst, right_motion);
}

TEST(Largest, AreInEveryFormOfTheResultsAndTheSameInTwoThreads) {
  const EnsembleRequest request =
      request_of("until = 3\n" + perturbed("1710121100", 250) +
                 "[[exact]]\nname = \"biased\"\nquantity = \"restitution\"\nfactor = 0.98\n");
  const EnsembleResult one = solved(request, 1);
  const EnsembleResult two = solved(request, 2);
  const Findings findings = findings_of(request, one, 1);
  const EnsembleReport report{request, one, findings};
  for (const std::string name : {"largest_impulse", "largest_tension"}) {
    const std::size_t place = place_of_statistic(findings.statistics, name);
    for (std::size_t draw = 0; draw < 250; ++draw) {
      EXPECT_EQ(one.draws[0].value(draw, place), two.draws[0].value(draw, place)) << draw;
    }
    const std::string& title = findings.statistics[place].heading;
    EXPECT_NE(ensemble_markdown(report).find(title), std::string::npos) << title;
    EXPECT_NE(ensemble_html(report, {}).find(title), std::string::npos) << title;
    EXPECT_NE(ensemble_json(report).find("\"" + name + "\""), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace tautline::bench
