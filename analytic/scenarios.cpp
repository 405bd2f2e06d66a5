#include "tautline/scenarios.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tautline {
namespace {

/// The start shared by all rigid-body rows of Table 5.1 (Eq. 5.122), but for angle and spin.
State table_start(double angle = 0.0, double spin = 0.0) {
  return {Vec2(0.1, 0.1), angle, Vec2(0.2, -0.1), spin};
}

TableRow row(std::string_view number, double r, double e, double a, double b, Shape shape,
             const State& initial = table_start()) {
  return {number, {r, e, a, b, shape, initial}};
}

/// A container of 2 t on one sling that is not above its centre of mass, SI units.
Case crane_load() {
  Case result;
  result.name = "crane-load";
  result.body = {2000.0, 3400.0};
  result.gravity = Vec2(0.0, -9.81);
  result.cables = {{Vec2(0.0, 12.0), Vec2(0.4, 1.2), 8.0, 0.3}};
  result.initial = {Vec2(0.5, 3.6), 0.1, Vec2(0.8, 0.0), 0.0};
  result.duration = 10.0;
  return result;
}

/// A buoy held down by gravity's mirror image: net buoyancy pulls it up, three cables hold it, SI.
Case buoy_three_cables() {
  Case result;
  result.name = "buoy-three-cables";
  result.body = {150.0, 40.0};
  result.gravity = Vec2(0.0, 3.0);
  result.cables = {{Vec2(-6.0, -8.0), Vec2(-0.6, -0.3), 10.0, 0.6},
                   {Vec2(0.0, -8.0), Vec2(0.0, -0.5), 8.4, 0.4},
                   {Vec2(6.0, -8.0), Vec2(0.6, -0.3), 10.0, 0.6}};
  result.initial = {Vec2(0.5, -0.4), 0.15, Vec2(-0.6, 0.5), 0.2};
  result.duration = 20.0;
  return result;
}

/// A square plate slung from its four corners, nondimensional.
Case plate_four_cables() {
  Case result;
  result.name = "plate-four-cables";
  result.body = {1.0, 0.06};
  result.cables = {{Vec2(-1.0, 1.5), Vec2(-0.3, 0.3), 1.6, 0.8},
                   {Vec2(1.0, 1.5), Vec2(0.3, 0.3), 1.6, 0.8},
                   {Vec2(-1.6, 1.5), Vec2(-0.3, -0.3), 2.3, 0.7},
                   {Vec2(1.6, 1.5), Vec2(0.3, -0.3), 2.3, 0.7}};
  result.initial = {Vec2(0.15, 0.1), 0.1, Vec2(-0.3, 0.2), 0.5};
  result.duration = 20.0;
  return result;
}

/// The standard breakwater with gravity turned by 0.2 rad: nothing is symmetric any more.
Case tilted_breakwater() {
  Case result =
      breakwater({1.5, 0.9, 0.1, 0.0, Shape::ring, table_start(), 20.0}, "tilted-gravity");
  constexpr double tilt = 0.2;  // [rad]
  result.gravity = Vec2(std::sin(tilt), -std::cos(tilt));
  return result;
}

}  // namespace

Case breakwater(const Breakwater& parameters, const std::string& name, ChapterLimits limits) {
  const auto& [r, e, a, b, shape, initial, duration] = parameters;
  if (!(r > 1.0 - a)) {
    throw std::invalid_argument("breakwater: r " + std::to_string(r) + " is not above 1 - a = " +
                                std::to_string(1.0 - a) + ": the body cannot float");
  }
  const double h = std::sqrt(r * r - (1.0 - a) * (1.0 - a));  // Eq. 5.30
  Case result;
  result.name = name;
  result.body = {1.0, shape == Shape::ring ? a * a : (a * a + b * b) / 3.0};
  result.cables = {{Vec2(-1.0, h + b), Vec2(-a, b), r, e}, {Vec2(1.0, h + b), Vec2(a, b), r, e}};
  result.initial = initial;
  result.duration = duration;
  if (limits == ChapterLimits::on) {
    result.angle_limit = 0.5 * std::numbers::pi;  // section 5.2.2.2
    result.ceiling = h + b;                       // Eqs. 5.22 and 5.23
  }
  return result;
}

const std::vector<TableRow>& table_5_1() {
  static const std::vector<TableRow> rows = {
      row("1910121100", 1.5, 0.9, 0.1, 0.0, Shape::ring),
      row("2910121100", 2.5, 0.9, 0.1, 0.0, Shape::ring),
      row("1911121100", 1.5, 0.9, 0.1, 0.1, Shape::box),
      row("2911121100", 2.5, 0.9, 0.1, 0.1, Shape::box),
      row("1921121100", 1.5, 0.9, 0.2, 0.1, Shape::box),
      row("2921121100", 2.5, 0.9, 0.2, 0.1, Shape::box),
      row("1110121100", 1.5, 1.0, 0.1, 0.0, Shape::ring),
      row("1710121100", 1.5, 0.7, 0.1, 0.0, Shape::ring),
      row("1510121100", 1.5, 0.5, 0.1, 0.0, Shape::ring),
      row("1920121100", 1.5, 0.9, 0.2, 0.0, Shape::ring),
      row("1930121100", 1.5, 0.9, 0.3, 0.0, Shape::ring),
      row("1922121100", 1.5, 0.9, 0.2, 0.2, Shape::box),
      row("1933121100", 1.5, 0.9, 0.3, 0.3, Shape::box),
      row("1931121100", 1.5, 0.9, 0.3, 0.1, Shape::box),
      row("19101211050", 1.5, 0.9, 0.1, 0.0, Shape::ring, table_start(0.05)),
      row("1910121110", 1.5, 0.9, 0.1, 0.0, Shape::ring, table_start(0.10)),
      row("19101211150", 1.5, 0.9, 0.1, 0.0, Shape::ring, table_start(0.15)),
      row("19101211002", 1.5, 0.9, 0.1, 0.0, Shape::ring, table_start(0.0, 0.02)),
      row("19101211005", 1.5, 0.9, 0.1, 0.0, Shape::ring, table_start(0.0, 0.05)),
      row("1910121101", 1.5, 0.9, 0.1, 0.0, Shape::ring, table_start(0.0, 0.10)),
      row("1900461100", 1.5, 0.9, 0.0, 0.0, Shape::ring,
          {Vec2(0.4, 1.0), 0.0, Vec2(0.6, -0.1), 0.0}),
  };
  return rows;
}

Case bouncing_ball(double restitution) {
  Case result;
  result.name = "bouncing-ball";
  result.body = {1.0, 0.4};
  result.cables = {{Vec2(0.0, 2.0), Vec2(0.0, 0.0), 2.0, restitution}};
  result.initial.position = Vec2(0.0, 0.5);
  result.duration = 10.0;
  return result;
}

std::vector<Case> shipped_cases() {
  std::vector<Case> cases;
  for (const TableRow& table_row : table_5_1()) {
    cases.push_back(
        breakwater(table_row.parameters, "breakwater/" + std::string(table_row.number)));
  }
  for (Case& other : std::vector<Case>{bouncing_ball(), crane_load(), buoy_three_cables(),
                                       plate_four_cables(), tilted_breakwater()}) {
    cases.push_back(std::move(other));
  }
  return cases;
}

}  // namespace tautline
