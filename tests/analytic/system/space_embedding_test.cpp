#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include "support.hpp"
#include "system/embedding.hpp"
#include "system/systems.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

// Planar motions in space: the kernel of dimension 3 against the planar one, of other text.

namespace tautline::test {
namespace {

Eigen::Matrix3d turned_by(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// Five planes, with the largest, the smallest and the middle moment of the bodies across them.
std::array<Plane, 5> planes() {
  const double quarter = pi<double>() / 2;
  return {{{Eigen::Matrix3d::Identity(), 2, {0.6, 0.7}},
           {turned_by(quarter, {1, 0, 0}), 0, {0.6, 0.7}},
           {turned_by(1.234, {1, 2, -1}), 1, {0.6, 0.7}},
           {turned_by(2.1, {-0.3, 0.5, 2}), 2, {1.5, 1.2}},
           {turned_by(0.7, {0.9, 0.5, -2}), 2, {0.8, 1.3}}}};
}

/// The units of a case: its shortest cable, and the time in which gravity takes a body so far.
struct UnitsOfCase {
  explicit UnitsOfCase(const Case& the_case)
      : length(shortest_length(the_case)),
        speed(std::sqrt(length * the_case.gravity.norm())),
        arm(attachment_radius(the_case)) {}

  double length;  // [m]
  double speed;   // [m/s]
  double arm;     // [m], of the farthest attachment
};

/// The largest difference of two states: of centres and of attachments as they turn [-].
double difference_in_space(const SpatialState& a, const SpatialState& b, const UnitsOfCase& unit) {
  return std::max({(a.position - b.position).norm() / unit.length,
                   (a.velocity - b.velocity).norm() / unit.speed,
                   unit.arm * angle_between<double>(a.orientation, b.orientation) / unit.length,
                   unit.arm * (a.spin - b.spin).norm() / unit.speed});
}

/// How far the centre is from the plane, and how fast it leaves it [-].
double out_of_plane(const SpatialState& state, const Plane& plane, const UnitsOfCase& unit) {
  const Eigen::Vector3d normal = plane.axes.col(2);
  return std::max(std::abs(normal.dot(state.position)) / unit.length,
                  std::abs(normal.dot(state.velocity)) / unit.speed);
}

struct InTwoKernels {
  std::size_t alike = 0;      // events of the same kind and cables, from the start on
  double first_ten = 0.0;     // the largest difference in ten of them [-]
  double out_of_plane = 0.0;  // in all of them, as long as the motions are the same to 1e-11 [-]
};

InTwoKernels in_two_kernels(const Case& the_case, const Plane& plane) {
  const Solution planar = solve(the_case);
  const SpatialSystem system = embedded(as_system(the_case), plane);
  EXPECT_TRUE(problems(system).empty()) << problems(system).front();
  const auto spatial = solve(system);
  const UnitsOfCase unit(the_case);
  InTwoKernels result;
  double apart = 0.0;
  const std::size_t count = std::min(planar.events().size(), spatial.events().size());
  for (; result.alike < count; ++result.alike) {
    const Event& one = planar.events()[result.alike];
    const auto& other = spatial.events()[result.alike];
    if (one.kind != other.kind || one.cables != other.cables) {
      break;
    }
    apart = std::max({apart, std::abs(one.time - other.time) * unit.speed / unit.length,
                      difference_in_space(plane.state(one.before), other.before.bodies[0], unit),
                      difference_in_space(plane.state(one.after), other.after.bodies[0], unit)});
    if (result.alike < 10) {
      result.first_ten = apart;
    }
    if (apart < 1e-11) {
      result.out_of_plane =
          std::max(result.out_of_plane, out_of_plane(other.after.bodies[0], plane, unit));
    }
  }
  EXPECT_TRUE(result.alike == planar.events().size() || apart > 1e-8 || result.alike > 150);
  return result;
}

TEST(InSpace, NinePlanarCasesMoveInFivePlanesAsInTheirOwn) {
  constexpr std::array<std::string_view, 9> names{
      "breakwater/1910121100", "breakwater/1911121100", "breakwater/1510121100",
      "breakwater/1900461100", "bouncing-ball",         "crane-load",
      "buoy-three-cables",     "plate-four-cables",     "tilted-gravity"};
  InTwoKernels worst;
  int count = 0;
  for (Case the_case : shipped_cases()) {
    if (std::find(names.begin(), names.end(), the_case.name) == names.end()) {
      continue;
    }
    the_case.angle_limit.reset();
    the_case.ceiling.reset();
    for (const Plane& plane : planes()) {
      SCOPED_TRACE(the_case.name + ", normal " + std::to_string(plane.normal));
      const InTwoKernels result = in_two_kernels(the_case, plane);
      std::printf("  %-22s %zu alike, first ten %.1e, out of plane %.1e\n", the_case.name.c_str(),
                  result.alike, result.first_ten, result.out_of_plane);
      worst.first_ten = std::max(worst.first_ten, result.first_ten);
      worst.out_of_plane = std::max(worst.out_of_plane, result.out_of_plane);
      ++count;
    }
  }
  EXPECT_EQ(count, 45);
  expect_within("difference in the first ten events [-]", worst.first_ten, 1e-13);
  expect_within("out of plane", worst.out_of_plane, 1e-11);
}

}  // namespace
}  // namespace tautline::test
