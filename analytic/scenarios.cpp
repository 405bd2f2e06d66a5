#include "tautline/scenarios.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "instantiate.hpp"

namespace tautline {
namespace {

/// Four digits of a decimal number: `hundredths` / 100, rounded once.
template <class Real>
Real decimal(int hundredths) {
  return Real(hundredths) / 100;
}

/// A start of Table 5.1, in hundredths: position, angle, velocity, spin.
struct Start {
  int x = 10, y = 10, angle = 0, vx = 20, vy = -10, spin = 0;  // of all rigid-body rows, Eq. 5.122
};

/// A row of Table 5.1: number, then r, e, a, b in hundredths.
struct Row {
  std::string_view number;
  int r, e, a, b;
  Shape shape;
  Start start = {};
};

constexpr Row rows[] = {
    {"1910121100", 150, 90, 10, 0, Shape::ring},
    {"2910121100", 250, 90, 10, 0, Shape::ring},
    {"1911121100", 150, 90, 10, 10, Shape::box},
    {"2911121100", 250, 90, 10, 10, Shape::box},
    {"1921121100", 150, 90, 20, 10, Shape::box},
    {"2921121100", 250, 90, 20, 10, Shape::box},
    {"1110121100", 150, 100, 10, 0, Shape::ring},
    {"1710121100", 150, 70, 10, 0, Shape::ring},
    {"1510121100", 150, 50, 10, 0, Shape::ring},
    {"1920121100", 150, 90, 20, 0, Shape::ring},
    {"1930121100", 150, 90, 30, 0, Shape::ring},
    {"1922121100", 150, 90, 20, 20, Shape::box},
    {"1933121100", 150, 90, 30, 30, Shape::box},
    {"1931121100", 150, 90, 30, 10, Shape::box},
    {"19101211050", 150, 90, 10, 0, Shape::ring, {.angle = 5}},
    {"1910121110", 150, 90, 10, 0, Shape::ring, {.angle = 10}},
    {"19101211150", 150, 90, 10, 0, Shape::ring, {.angle = 15}},
    {"19101211002", 150, 90, 10, 0, Shape::ring, {.spin = 2}},
    {"19101211005", 150, 90, 10, 0, Shape::ring, {.spin = 5}},
    {"1910121101", 150, 90, 10, 0, Shape::ring, {.spin = 10}},
    {"1900461100", 150, 90, 0, 0, Shape::ring, {40, 100, 0, 60, -10, 0}},
};

}  // namespace

template <class Real>
BasicCase<Real> breakwater(const BasicBreakwater<Real>& parameters, const std::string& name,
                           ChapterLimits limits) {
  const auto& [r, e, a, b, shape, initial, duration] = parameters;
  const Real span = 1 - a;
  if (!(r > span)) {
    throw std::invalid_argument(
        "breakwater: r " + std::to_string(static_cast<double>(r)) + " is not above 1 - a = " +
        std::to_string(static_cast<double>(span)) + ": the body cannot float");
  }
  const Real h = sqrt(Real(r * r - span * span));  // Eq. 5.30
  const Real one(1);
  using Vector = BasicVec2<Real>;
  BasicCase<Real> result;
  result.name = name;
  result.body = {one, shape == Shape::ring ? Real(a * a) : Real((a * a + b * b) / 3)};
  result.cables = {{Vector(-one, h + b), Vector(-a, b), r, e},
                   {Vector(one, h + b), Vector(a, b), r, e}};
  result.initial = initial;
  result.duration = duration;
  if (limits == ChapterLimits::on) {
    result.angle_limit = pi<Real>() / 2;  // section 5.2.2.2
    result.ceiling = h + b;               // Eqs. 5.22 and 5.23
  }
  return result;
}

template <class Real>
std::vector<BasicTableRow<Real>> table_5_1() {
  std::vector<BasicTableRow<Real>> table;
  for (const Row& row : rows) {
    const Start& start = row.start;
    BasicBreakwater<Real> parameters;
    parameters.r = decimal<Real>(row.r);
    parameters.e = decimal<Real>(row.e);
    parameters.a = decimal<Real>(row.a);
    parameters.b = decimal<Real>(row.b);
    parameters.shape = row.shape;
    parameters.initial.position = {decimal<Real>(start.x), decimal<Real>(start.y)};
    parameters.initial.angle = decimal<Real>(start.angle);
    parameters.initial.velocity = {decimal<Real>(start.vx), decimal<Real>(start.vy)};
    parameters.initial.spin = decimal<Real>(start.spin);
    table.push_back({row.number, parameters});
  }
  return table;
}

template InstanceCase breakwater(const BasicBreakwater<Instance>&, const std::string&,
                                 ChapterLimits);
template std::vector<BasicTableRow<Instance>> table_5_1();

}  // namespace tautline
