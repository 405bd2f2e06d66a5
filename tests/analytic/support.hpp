#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <string_view>

#include "tautline/case.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solution.hpp"

namespace tautline::test {

/// Fails if `reached` is above `allowed`; prints and records both either way, so that a reader sees
/// the margin. TAUTLINE_TOL_SCALE in the environment scales what is allowed: 0 shows every figure.
void expect_within(const std::string& what, double reached, double allowed);

/// Runs a RapidCheck property from a fixed seed, which it prints; RC_PARAMS overrides it.
void expect_always(const std::string& claim, const std::function<void()>& property);

/// The row of Table 5.1 with this number; it must exist.
[[nodiscard]] Breakwater table_row(std::string_view number);

/// The case of that row.
[[nodiscard]] Case table_case(std::string_view number);

/// The breakwater at rest with both cables taut at this angle [rad]: on its four-bar linkage.
[[nodiscard]] State on_linkage(const Case& the_case, double angle);

/// The largest difference of one of the six numbers of two states, each in its own unit.
[[nodiscard]] double difference(const State& a, const State& b);

/// Every cable of a case.
[[nodiscard]] CableSet all_cables(const Case& the_case);

/// The largest tension of a cable along the arcs of `solution` [N], which are sampled and searched
/// by golden sections; 0 if no cable is ever taut.
[[nodiscard]] double largest_sampled_tension(const Solution& solution);

/// A measure of the energies that come and go in a case [J]: what its energy errors are relative
/// to. Kinetic energy at the start, and a fall by the longest cable.
[[nodiscard]] double energy_scale(const Case& the_case);

/// A random number source with the few distributions the tests need.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] double uniform(double low, double high);
  [[nodiscard]] double log_uniform(double low, double high);
  [[nodiscard]] bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  [[nodiscard]] Vec2 in_square(double half_width);

 private:
  std::mt19937_64 engine_;
};

/// What `random_case` may draw.
struct Draw {
  std::size_t cables = 2;
  double least_slack = 0.0;  // [-], of a cable's length at the start
  double taut_chance = 0.0;  // [-], that a cable starts at zero gap
};

/// A random body on random cables that starts admissible, with sizes near one.
[[nodiscard]] Case random_case(Random& random, const Draw& draw);

/// A case all of whose cables are at zero gap, up to rounding, and closing: the eve of an impact.
[[nodiscard]] Case random_impact(Random& random, std::size_t cables);

}  // namespace tautline::test
