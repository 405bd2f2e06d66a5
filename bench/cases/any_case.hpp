#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "bench/cases/quantity.hpp"
#include "tautline/case_text.hpp"

namespace tautline::bench {

/// A case file holds one of these.
using AnyCase = std::variant<Case, System, SpatialSystem>;

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

[[nodiscard]] inline bool is_system(const AnyCase& any) {
  return !std::holds_alternative<Case>(any);
}

/// The text of its file.
[[nodiscard]] inline std::string written(const Case& the_case) { return write_case(the_case); }
template <int D>
[[nodiscard]] std::string written(const BasicSystem<double, D>& system) {
  return write_system(system);
}
[[nodiscard]] inline std::string written(const AnyCase& any) {
  return std::visit([](const auto& one) { return written(one); }, any);
}

/// The names of the numbers of a system that an ensemble may vary: of all bodies, cables or waves
/// ("mass", "length", "phase"), and of one: "hook.mass", "length_0", "phase_0". In space the
/// numbers of an axis end in its name: "spin_x". Waves are numbered in the order of
/// `each_function`.
template <int D>
[[nodiscard]] std::vector<std::string> quantities_of(const BasicSystem<double, D>& system);

/// The unit of a quantity: "m", or "" for a number without one.
[[nodiscard]] inline std::string_view unit_of_quantity(const Case& /*the_case*/,
                                                       std::string_view name) {
  return unit_of_quantity(name);
}
template <int D>
[[nodiscard]] std::string_view unit_of_quantity(const BasicSystem<double, D>& system,
                                                std::string_view name);

/// The number that `name`, one of `quantities_of`, means; with several bodies, cables or waves the
/// first one's. If they are given over time, "length", "gravity_x" and "gravity_y" are the value
/// before the first knot, and "length_rate" is the first mean rate between knots that is not zero.
/// "rotation_x" is a number of the file's `rotation`, an axis times an angle.
template <int D>
[[nodiscard]] double quantity(const BasicSystem<double, D>& system, std::string_view name);
/// Gives all of them this value. Of what is given over time all values move with the first, and all
/// changes of a length grow with its rate. All waves are one sea: "amplitude" and "period" keep
/// their ratios, and "phase" has all come earlier by one time.
template <int D>
void set_quantity(BasicSystem<double, D>& system, std::string_view name, double value);
template <int D>
void scale_quantity(BasicSystem<double, D>& system, std::string_view name,
                    double factor);  // each of its numbers

}  // namespace tautline::bench
