#include "bench/gate/changes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace tautline::bench {
namespace {

using Number = std::optional<double>;

/// Every number that decides the motion: body, cables, start and duration.
std::vector<Number> numbers_of(const CaseRow& the_case) {
  std::vector<Number> numbers = {the_case.duration,    the_case.start_energy,
                                 the_case.body.mass,   the_case.body.inertia,
                                 the_case.gravity.x(), the_case.gravity.y()};
  for (const CableRow& cable : the_case.geometry) {
    numbers.insert(numbers.end(), {cable.anchor.x(), cable.anchor.y(), cable.attachment.x(),
                                   cable.attachment.y(), cable.length, cable.restitution});
  }
  for (const auto* column : {&the_case.path.x, &the_case.path.y, &the_case.path.angle}) {
    numbers.push_back(column->steps.empty() ? std::nullopt : Number(column->start));
  }
  return numbers;
}

bool same_number(const Number& one, const Number& two) {
  constexpr double rounding = 1e-9;  // [-]
  if (!one || !two) {
    return one.has_value() == two.has_value();
  }
  return std::abs(*one - *two) <= rounding * std::max(1.0, std::abs(*one));
}

}  // namespace

bool same_case(const CaseRow& one, const CaseRow& two) {
  const std::vector<Number> its = numbers_of(one);
  const std::vector<Number> others = numbers_of(two);
  return std::equal(its.begin(), its.end(), others.begin(), others.end(), same_number);
}

}  // namespace tautline::bench
