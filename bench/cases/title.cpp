#include "bench/cases/title.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tautline::bench {
namespace {

/// Two numbers that were computed in different ways from the same decimals.
constexpr double rounding = 1e-9;

bool equal(double one, double other) {
  return std::abs(one - other) <= rounding * std::max(std::abs(one), std::abs(other));
}

/// "1.5", or "8.4 to 10" where the cables differ.
std::string range(const Case& the_case, double Cable::*member) {
  const auto [least, largest] = std::minmax_element(
      the_case.cables.begin(), the_case.cables.end(),
      [&](const Cable& one, const Cable& other) { return one.*member < other.*member; });
  const double low = (*least).*member;
  const double high = (*largest).*member;
  return equal(low, high) ? fmt::format("{:.4g}", low) : fmt::format("{:.4g} to {:.4g}", low, high);
}

std::string restitution(const Case& the_case) {
  const bool by_speed =
      std::any_of(the_case.cables.begin(), the_case.cables.end(), depends_on_speed<Cable>);
  return by_speed ? "e by speed" : "e = " + range(the_case, &Cable::restitution);
}

/// The corner that the attachments share but for signs: half the width and depth of a body hung
/// from its corners or its sides. NaN if they do not.
Vec2 shared_corner(const Case& the_case) {
  const Vec2 corner = the_case.cables.front().attachment.cwiseAbs();
  const bool shared =
      std::all_of(the_case.cables.begin(), the_case.cables.end(), [&](const Cable& cable) {
        const Vec2 other = cable.attachment.cwiseAbs();
        return equal(other.x(), corner.x()) && equal(other.y(), corner.y());
      });
  return shared ? corner : Vec2(Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
}

/// The shape whose inertia and attachments the body has, if it is a point, a ring or a box.
std::string shape(const Case& the_case) {
  const auto& [mass, inertia] = the_case.body;
  if (inertia == 0.0) {  // exactly: as given
    return ", point mass";
  }
  const Vec2 corner = shared_corner(the_case);
  const double radius = corner.norm();
  if (radius == 0.0) {
    return ", body hung at its centre";
  }
  if (equal(inertia, mass * radius * radius)) {
    return fmt::format(", ring of radius {:.4g}", radius);
  }
  if (equal(inertia, mass * radius * radius / 3)) {
    return fmt::format(", box {:.4g} x {:.4g}", 2 * corner.x(), 2 * corner.y());
  }
  return "";  // nothing to name
}

std::string cables(const Case& the_case) {
  static_assert(max_cables == 8);
  constexpr const char* counts[] = {"no",   "one", "two",   "three", "four",
                                    "five", "six", "seven", "eight"};
  const std::size_t count = the_case.cables.size();
  return fmt::format("{} cable{} of {}", counts[count], count == 1 ? "" : "s",
                     range(the_case, &Cable::length));
}

/// What of the start and of gravity is out of the ordinary.
std::vector<std::string> peculiarities(const Case& the_case) {
  std::vector<std::string> words;
  const auto& [position, angle, velocity, spin] = the_case.initial;
  if (angle != 0.0) {  // exactly: as given
    words.push_back(fmt::format("turned by {:.4g}", angle));
  }
  if (spin != 0.0) {
    words.push_back(fmt::format("spin {:.4g}", spin));
  }
  const Vec2& gravity = the_case.gravity;
  const double tilt = std::atan2(gravity.x(), -gravity.y());  // from straight down [rad]
  if (gravity.isZero(0.0)) {
    words.emplace_back("no gravity");
  } else if (equal(std::abs(tilt), std::numbers::pi)) {
    words.emplace_back("gravity upward");
  } else if (tilt != 0.0) {
    words.push_back(fmt::format("gravity tilted by {:.4g}", tilt));
  }
  return words;
}

}  // namespace

std::string title_of(const Case& the_case) {
  std::string title = restitution(the_case) + shape(the_case) + ", " + cables(the_case);
  for (const std::string& words : peculiarities(the_case)) {
    title += ", " + words;
  }
  return title;
}

}  // namespace tautline::bench
