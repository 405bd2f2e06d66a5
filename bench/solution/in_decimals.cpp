#include "bench/solution/in_decimals.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "bench/base/text.hpp"
#include "bench/solution/in_digits.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// The decimals that the doubles of a case are read from.
class Decimals {
 public:
  explicit Decimals(const Literals& written) : written_(written) {}

  /// As it is written in the file at `place`, if that is where the double is from; else the
  /// shortest decimal that it is the nearest to.
  [[nodiscard]] Multi number(const std::string& place, double value) const {
    const auto found = written_.find(place);
    const bool from_there =
        found != written_.end() && std::strtod(found->second.c_str(), nullptr) == value;
    return Multi(from_there ? found->second : shortest(value));
  }
  [[nodiscard]] BasicVec2<Multi> pair(const std::string& place, const Vec2& value) const {
    return {number(place + "[0]", value.x()), number(place + "[1]", value.y())};
  }

 private:
  const Literals& written_;
};

BasicCable<Multi> cable_in_decimals(const Decimals& read, const std::string& place,
                                    const Cable& cable) {
  BasicCable<Multi> result{read.pair(place + ".anchor", cable.anchor),
                           read.pair(place + ".attachment", cable.attachment),
                           read.number(place + ".length", cable.length),
                           read.number(place + ".restitution", cable.restitution),
                           read.number(place + ".capture_speed", cable.capture_speed),
                           {}};
  for (std::size_t index = 0; index < cable.restitution_table.size(); ++index) {
    const RestitutionPoint& point = cable.restitution_table[index];
    const BasicVec2<Multi> same = read.pair(fmt::format("{}.restitution_table[{}]", place, index),
                                            {point.speed, point.restitution});
    result.restitution_table.push_back({same.x(), same.y()});
  }
  return result;
}

}  // namespace

BasicCase<Multi> in_decimals(const Case& the_case, const Literals& written) {
  const Decimals read(written);
  BasicCase<Multi> result = in_digits(the_case);
  result.duration = read.number("duration", the_case.duration);
  for (const auto& row : table_5_1<Multi>()) {
    if (written.empty() && the_case.name == "breakwater/" + std::string(row.number)) {
      const Multi duration = result.duration;
      result = breakwater<Multi>(row.parameters, the_case.name);
      result.duration = duration;
      return result;
    }
  }
  result.body = {read.number("body.mass", the_case.body.mass),
                 read.number("body.inertia", the_case.body.inertia)};
  result.gravity = read.pair("gravity", the_case.gravity);
  if (the_case.angle_limit) {
    result.angle_limit = read.number("angle_limit", *the_case.angle_limit);
  }
  if (the_case.ceiling) {
    result.ceiling = read.number("ceiling", *the_case.ceiling);
  }
  const State& start = the_case.initial;
  result.initial = {
      read.pair("initial.position", start.position), read.number("initial.angle", start.angle),
      read.pair("initial.velocity", start.velocity), read.number("initial.spin", start.spin)};
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    result.cables[index] =
        cable_in_decimals(read, fmt::format("cables[{}]", index), the_case.cables[index]);
  }
  return result;
}

}  // namespace tautline::bench
