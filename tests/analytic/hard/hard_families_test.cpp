#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>
#include <numbers>

#include "stopwatch.hpp"
#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/rounding.hpp"
#include "tautline/solve.hpp"

// Random systems from families that are hard for a double. TAUTLINE_HARD_SYSTEMS in the environment
// says how many of each family; the hundred of a usual run take seconds.

namespace tautline::test {
namespace {

constexpr std::uint64_t hard_seed = 20261114;

int systems_of_a_family() {
  const char* const asked = std::getenv("TAUTLINE_HARD_SYSTEMS");
  return asked != nullptr ? std::atoi(asked) : 15;
}

/// The case with every length multiplied by `factor`.
Case scaled(Case the_case, double factor) {
  for (Cable& cable : the_case.cables) {
    cable.anchor *= factor;
    cable.attachment *= factor;
    cable.length *= factor;
  }
  the_case.initial.position *= factor;
  the_case.initial.velocity *= std::sqrt(factor);
  the_case.initial.spin /= std::sqrt(factor);
  the_case.duration *= std::sqrt(factor);
  the_case.body.inertia *= factor * factor;
  return the_case;
}

/// Makes cable `index` start taut along `direction` [rad], whatever it was.
void pull_along(Case& the_case, std::size_t index, double direction) {
  Cable& cable = the_case.cables[index];
  const Vec2 point = attachment_point(the_case.initial, cable);
  cable.anchor = point + cable.length * Vec2(std::cos(direction), std::sin(direction));
  cable.length = (point - cable.anchor).norm();
}

Case light_or_heavy(Random& random, Case the_case) {
  const double arm = attachment_radius(the_case);
  the_case.body.inertia = the_case.body.mass * arm * arm * random.log_uniform(1e-9, 1e9);
  return the_case;
}

Case fast(Random& random, Case the_case) {
  the_case.initial.spin = random.log_uniform(10.0, 1e7);
  return the_case;
}

Case doubled(Random&, Case the_case) {
  const std::size_t count = std::min(the_case.cables.size(), max_cables / 2);
  the_case.cables.resize(count);
  for (std::size_t index = 0; index < count; ++index) {
    the_case.cables.push_back(the_case.cables[index]);
    the_case.cables.back().restitution *= 0.5;
  }
  return the_case;
}

Case wedged(Random& random, Case the_case) {
  double direction = random.uniform(0.0, 6.0);
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    pull_along(the_case, index, direction);
    direction += 2.0 * std::numbers::pi / 3.0 + random.uniform(-0.3, 0.3);
  }
  return the_case;
}

Case near_one_line(Random& random, Case the_case) {
  const double direction = random.uniform(0.0, 6.0);
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    the_case.cables[index].attachment *= random.log_uniform(1e-6, 1.0);
    const double side = random.chance(0.5) ? std::numbers::pi : 0.0;
    pull_along(the_case, index, direction + side + random.log_uniform(1e-9, 1e-2));
  }
  return the_case;
}

Case tiny_or_huge(Random& random, Case the_case) {
  return scaled(std::move(the_case), random.log_uniform(1e-6, 1e6));
}

Case far_away(Random& random, Case the_case) {
  const Vec2 away = random.in_square(1e6);
  for (Cable& cable : the_case.cables) {
    cable.anchor += away;
    const Vec2 point = attachment_point(the_case.initial, cable) + away;
    cable.length = std::max(cable.length, (point - cable.anchor).norm());
  }
  the_case.initial.position += away;
  return the_case;
}

Case elastic_and_plastic(Random& random, Case the_case) {
  for (Cable& cable : the_case.cables) {
    cable.restitution = random.chance(0.5) ? 1.0 : 0.0;
  }
  return the_case;
}

struct Family {
  const char* name;
  Case (*make)(Random&, Case);
};
constexpr std::array families = {Family{"LightOrHeavy", light_or_heavy},
                                 Family{"Fast", fast},
                                 Family{"Doubled", doubled},
                                 Family{"Wedged", wedged},
                                 Family{"NearOneLine", near_one_line},
                                 Family{"TinyOrHuge", tiny_or_huge},
                                 Family{"FarAway", far_away},
                                 Family{"ElasticAndPlastic", elastic_and_plastic}};

constexpr double most_seconds = 2.0;  // of an idle machine, in processor time

class HardFamilies : public ::testing::TestWithParam<Family> {};

TEST_P(HardFamilies, EndInTimeAndTruthfully) {
  Random random(hard_seed);
  double slowest = 0.0;
  double gain = 0.0;
  double overstretch = 0.0;
  int refused = 0;
  std::map<std::string_view, int> endings;
  const int count = systems_of_a_family();
  for (int sample = 0; sample < count; ++sample) {
    SCOPED_TRACE("seed " + std::to_string(hard_seed) + " sample " + std::to_string(sample));
    const auto cables = static_cast<std::size_t>(1 + sample % 8);
    Case the_case = random_case(random, {cables, 0.0, 0.3});
    the_case.duration = 10.0;
    the_case = GetParam().make(random, std::move(the_case));
    if (sample % 3 == 2) {  // two difficulties at once
      const auto other =
          static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(families.size())));
      the_case = families[other].make(random, std::move(the_case));
    }
    if (!problems(the_case).empty()) {  // anchors so far apart that the body cannot float
      ++refused;
      continue;
    }
    SolveOptions options;
    options.law = impact_laws[static_cast<std::size_t>(sample) % impact_laws.size()];
    const std::clock_t begin = std::clock();
    const Solution solution = solve(the_case, options);
    const double taken = seconds_since(begin);
    if (taken > 1.0) {
      std::cout << "  sample " << sample << ": " << taken << " s, " << to_string(solution.ending())
                << ", " << solution.events().size() << " events\n";
    }
    slowest = std::max(slowest, taken);
    ++endings[to_string(solution.ending())];
    for (const Event& event : solution.events()) {
      const double change = energy(the_case, event.after) - energy(the_case, event.before);
      gain = std::max(gain, change / rounding_of_energy(the_case, event.before));
      for (const Cable& cable : the_case.cables) {
        // far away lengths are given to 1e-10 m, and a wedge multiplies that by one over its sine
        constexpr double wedge = 1000.0;  // [-]
        const double moved =              // while time advances by a rounding
            epsilon<double>() * event.time * speed_scale(the_case, event.before);
        const double told = wedge * (rounding_of_gap(cable, event.after) + moved);
        overstretch = std::max(overstretch, (-gap(cable, event.after) - told) / cable.length);
      }
      ASSERT_TRUE(std::isfinite(change)) << "at " << event.time;
    }
  }
  for (const auto& [ending, times] : endings) {
    std::cout << "  " << ending << ": " << times << '\n';
  }
  EXPECT_LE(10 * refused, count);
  expect_within("slowest [s of an idle machine]", slowest / slowness(), most_seconds);
  expect_within("energy gained by an event [roundings]", gain, 1000.0);
  expect_within("overstretch after an event, beyond rounding, of the length", overstretch, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Random, HardFamilies, ::testing::ValuesIn(families),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tautline::test
