#pragma once

#include <tautline/tautline.h>

#include <memory>
#include <string>
#include <vector>

#include "tautline/case.hpp"

namespace tautline::c::test {

struct Free {
  void operator()(tautline_case* one) const { tautline_case_free(one); }
  void operator()(tautline_motion* one) const { tautline_motion_free(one); }
};
using OwnedCase = std::unique_ptr<tautline_case, Free>;
using OwnedMotion = std::unique_ptr<tautline_motion, Free>;

/// A struct of zeros that says how large it is.
template <class Struct>
Struct sized() {
  Struct one{};
  one.size = sizeof one;
  return one;
}

inline std::string problems_of(const OwnedCase& the_case) {
  std::string text(tautline_problems(the_case.get(), nullptr, 0), '\0');
  tautline_problems(the_case.get(), text.data(), text.size() + 1);
  return text;
}

inline std::string text_of(const OwnedCase& the_case, std::int32_t format) {
  std::size_t length = 0;
  tautline_case_text(the_case.get(), format, nullptr, 0, &length);
  std::string text(length, '\0');
  tautline_case_text(the_case.get(), format, text.data(), length + 1, nullptr);
  return text;
}

inline OwnedMotion solved(const OwnedCase& the_case, const tautline_options* options = nullptr) {
  tautline_motion* motion = nullptr;
  tautline_solve(the_case.get(), options, &motion);
  return OwnedMotion(motion);
}

/// A case of C++ through the structs of C.
inline OwnedCase from_numbers(const Case& from) {
  auto numbers = sized<tautline_planar_case>();
  numbers.mass = from.body.mass;
  numbers.inertia = from.body.inertia;
  numbers.gravity[0] = from.gravity.x();
  numbers.gravity[1] = from.gravity.y();
  const State& start = from.initial;
  const double row[] = {start.position.x(), start.position.y(), start.angle,
                        start.velocity.x(), start.velocity.y(), start.spin};
  std::copy(std::begin(row), std::end(row), numbers.start);
  numbers.duration = from.duration;
  numbers.has =
      (from.angle_limit ? TAUTLINE_HAS_ANGLE_LIMIT : 0) | (from.ceiling ? TAUTLINE_HAS_CEILING : 0);
  numbers.angle_limit = from.angle_limit.value_or(0.0);
  numbers.ceiling = from.ceiling.value_or(0.0);
  std::vector<tautline_cable> cables;
  std::vector<double> table;
  for (const Cable& cable : from.cables) {
    auto one = sized<tautline_cable>();
    one.anchor[0] = cable.anchor.x();
    one.anchor[1] = cable.anchor.y();
    one.attachment[0] = cable.attachment.x();
    one.attachment[1] = cable.attachment.y();
    one.length = cable.length;
    one.restitution = cable.restitution;
    one.capture_speed = cable.capture_speed;
    one.table_points = static_cast<std::int32_t>(cable.restitution_table.size());
    for (const RestitutionPoint& point : cable.restitution_table) {
      table.insert(table.end(), {point.speed, point.restitution});
    }
    cables.push_back(one);
  }
  return OwnedCase(tautline_case_from_numbers(&numbers, cables.data(), cables.size(), table.data(),
                                              table.size() / 2, from.name.c_str()));
}

}  // namespace tautline::c::test
