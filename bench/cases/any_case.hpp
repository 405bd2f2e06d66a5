#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "bench/cases/quantity.hpp"
#include "tautline/case_text.hpp"

namespace tautline::bench {

/// A case file holds one of these.
using AnyCase = std::variant<Case, System>;

[[nodiscard]] inline const std::string& name_of(const AnyCase& any) {
  return std::visit([](const auto& one) -> const std::string& { return one.name; }, any);
}

[[nodiscard]] inline double duration_of(const AnyCase& any) {  // [s]
  return std::visit([](const auto& one) { return one.duration; }, any);
}

[[nodiscard]] inline std::size_t cables_of(const AnyCase& any) {
  return std::visit([](const auto& one) { return one.cables.size(); }, any);
}

[[nodiscard]] inline std::vector<std::string> problems(const AnyCase& any) {
  return std::visit([](const auto& one) { return tautline::problems(one); }, any);
}

/// The text of its file.
[[nodiscard]] inline std::string written(const AnyCase& any) {
  if (const auto* const system = std::get_if<System>(&any)) {
    return write_system(*system);
  }
  return write_case(std::get<Case>(any));
}

/// The names of the numbers of a system that an ensemble may vary: of all bodies, cables or waves
/// ("mass", "length", "phase"), and of one: "hook.mass", "length_0", "phase_0".
/// Waves are numbered in the order of `each_function`.
[[nodiscard]] std::vector<std::string> quantities_of(const System& system);

/// The unit of a quantity: "m", or "" for a number without one.
[[nodiscard]] std::string_view unit_of_quantity(const AnyCase& any, std::string_view name);

/// The number that `name`, one of `quantities_of`, means; with several bodies, cables or waves the
/// first one's. If they are given over time, "length", "gravity_x" and "gravity_y" are the value
/// before the first knot, and "length_rate" is the first mean rate between knots that is not zero.
[[nodiscard]] double quantity(const System& system, std::string_view name);
/// Gives all of them this value. Of what is given over time all values move with the first, and all
/// changes of a length grow with its rate. All waves are one sea: "amplitude" and "period" keep
/// their ratios, and "phase" has all come earlier by one time.
void set_quantity(System& system, std::string_view name, double value);
void scale_quantity(System& system, std::string_view name, double factor);  // each of its numbers

}  // namespace tautline::bench
