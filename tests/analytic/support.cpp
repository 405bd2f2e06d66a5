#include "support.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <Eigen/LU>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "tautline/geometry.hpp"

namespace tautline::test {
namespace {

double tolerance_scale() {
  const char* const text = std::getenv("TAUTLINE_TOL_SCALE");
  return text == nullptr ? 1.0 : std::strtod(text, nullptr);
}

std::string text(double value) {
  std::ostringstream out;
  out.precision(3);
  out << value;
  return out.str();
}

}  // namespace

void expect_within(const std::string& what, double reached, double allowed) {
  std::cout << "  " << what << ": reached " << text(reached) << ", allowed " << text(allowed)
            << '\n';
  ::testing::Test::RecordProperty(what, text(reached));
  EXPECT_LE(reached, allowed * tolerance_scale()) << what;
}

void expect_always(const std::string& claim, const std::function<void()>& property) {
  // RapidCheck reads this once, at its first property; a caller's own value is kept
  static const bool seeded = setenv("RC_PARAMS", "seed=20240607 max_success=300", 0) == 0;
  ASSERT_TRUE(seeded) << "the environment cannot be set";
  std::cout << "  RC_PARAMS: " << std::getenv("RC_PARAMS") << '\n';
  EXPECT_TRUE(rc::check(claim, property)) << claim;
}

Breakwater table_row(std::string_view number) {
  const std::vector<TableRow> rows = table_5_1();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const TableRow& row) { return row.number == number; });
  if (found == rows.end()) {
    throw std::invalid_argument("Table 5.1 has no case " + std::string(number));
  }
  return found->parameters;
}

Case table_case(std::string_view number) {
  return breakwater(table_row(number), std::string(number));
}

State on_linkage(const Case& the_case, double angle) {
  State state;
  state.angle = angle;
  constexpr int enough = 50;  // of Newton's method, far more than it takes
  for (int iteration = 0; iteration < enough; ++iteration) {
    Eigen::Matrix2d slope;
    Vec2 gaps;
    for (const Eigen::Index row : {0, 1}) {
      const Cable& cable = the_case.cables[static_cast<std::size_t>(row)];
      slope.row(row) = gap_gradient(cable, state).head<2>().transpose();
      gaps[row] = gap(cable, state);
    }
    state.position -= slope.inverse() * gaps;
  }
  return state;
}

double difference(const State& a, const State& b) {
  return std::max({(a.position - b.position).cwiseAbs().maxCoeff(), std::abs(a.angle - b.angle),
                   (a.velocity - b.velocity).cwiseAbs().maxCoeff(), std::abs(a.spin - b.spin)});
}

CableSet all_cables(const Case& the_case) {
  CableSet result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    result.insert(index);
  }
  return result;
}

double largest_sampled_tension(const Solution& solution) {
  constexpr int samples = 32;  // of an arc, whose tension turns once or twice
  constexpr int sections = 40;
  constexpr double golden = 0.6180339887498949;
  double largest = 0.0;
  for (const Arc& arc : solution.arcs()) {
    const double step = (arc.end - arc.start) / samples;
    const auto tension = [&](double dt) { return solution.tensions(arc, dt).maxCoeff(); };
    for (int k = 0; k <= samples && step > 0.0; ++k) {
      double low = std::max(0, k - 1) * step;
      double high = std::min(samples, k + 1) * step;
      const double here = tension(k * step);
      if (here < tension(low) || here < tension(high)) {
        continue;
      }
      largest = std::max(largest, here);
      for (int section = 0; section < sections; ++section) {
        const double a = high - golden * (high - low);
        const double b = low + golden * (high - low);
        (tension(a) < tension(b) ? low : high) = tension(a) < tension(b) ? a : b;
      }
      largest = std::max(largest, tension(low));
    }
  }
  return largest;
}

double energy_scale(const Case& the_case) {
  Case still = the_case;
  still.gravity.setZero();
  double longest = 0.0;
  for (const Cable& cable : the_case.cables) {
    longest = std::max(longest, cable.length);
  }
  return energy(still, the_case.initial) + the_case.body.mass * the_case.gravity.norm() * longest;
}

double Random::uniform(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine_);
}

double Random::log_uniform(double low, double high) {
  const double drawn = std::exp(uniform(std::log(low), std::log(high)));
  // without the digits that depend on the processor, so that all draw the same systems
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(drawn) & ~std::uint64_t{0xffffffff});
}

Vec2 Random::in_square(double half_width) {
  const double x = uniform(-half_width, half_width);
  return {x, uniform(-half_width, half_width)};
}

Case random_case(Random& random, const Draw& draw) {
  Case result;
  result.name = "random";
  result.body.mass = random.log_uniform(0.3, 3.0);
  const double radius_of_gyration = random.log_uniform(0.1, 0.6);
  result.body.inertia = result.body.mass * radius_of_gyration * radius_of_gyration;
  result.gravity = random.chance(0.1) ? Vec2(0.0, 0.0) : random.in_square(1.0);
  result.initial = {random.in_square(0.5), random.uniform(-1.0, 1.0), random.in_square(1.0),
                    random.uniform(-2.0, 2.0)};
  const bool point_mass = random.chance(0.1);
  if (point_mass) {
    result.body.inertia = 0.0;
  }
  for (std::size_t index = 0; index < draw.cables; ++index) {
    Cable cable;
    cable.anchor = random.in_square(2.0);
    cable.attachment = point_mass ? Vec2(0.0, 0.0) : random.in_square(0.4);
    const double distance = (attachment_point(result.initial, cable) - cable.anchor).norm();
    const bool taut = random.chance(draw.taut_chance);
    const double slack = taut ? 0.0 : draw.least_slack + random.uniform(0.0, 0.5);
    cable.length = std::max(distance * (1.0 + slack), 0.05);
    const double which = random.uniform(0.0, 1.0);
    cable.restitution = which < 0.1 ? 0.0 : which < 0.2 ? 1.0 : random.uniform(0.0, 1.0);
    result.cables.push_back(cable);
  }
  result.duration = 5.0;
  return result;
}

Case random_impact(Random& random, std::size_t cables) {
  Case result = random_case(random, {cables, 0.0, 1.0});
  for (Cable& cable : result.cables) {
    // a separating cable is mirrored through its attachment: then it closes as fast
    if (gap_rate(cable, result.initial) > 0.0) {
      cable.anchor = 2.0 * attachment_point(result.initial, cable) - cable.anchor;
    }
  }
  return result;
}

}  // namespace tautline::test
