// Solves the shipped cases, 1,000 random systems and 300 hard ones, and prints a line for each: its
// name and a hash of every bit of its motion and of the bounds of its errors. Whatever compiles it
// prints the same: tests/analytic/benchmarks/same-bits holds two compilers to that.

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

#include "hard/hard_families.hpp"
#include "support.hpp"
#include "tautline/impact.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::test {
namespace {

constexpr int random_systems = 1'000;
constexpr int hard_samples = 300;
constexpr std::uint64_t random_seed = 20261125;

/// Bounces between elastic cables may be as many as one likes; these show whether bits differ.
constexpr std::size_t most_events = 2'000;

/// FNV-1a of the bits of numbers.
class Hash {
 public:
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) {
      value_ = (value_ ^ (bits & 0xffU)) * 0x100000001b3U;
      bits >>= 8U;
    }
  }
  void add(double value) {  // what is no number has no sign that means anything
    add(std::isnan(value) ? std::uint64_t{1} : std::bit_cast<std::uint64_t>(value));
  }
  void add(const State& state) {
    for (const double value : {state.position.x(), state.position.y(), state.angle,
                               state.velocity.x(), state.velocity.y(), state.spin}) {
      add(value);
    }
  }
  void add(CableSet cables) {
    for (const std::size_t index : cables) {
      add(std::uint64_t{index});
    }
  }
  template <class Numbers>
  void add_all(const Numbers& numbers) {
    for (Eigen::Index k = 0; k < numbers.size(); ++k) {
      add(numbers.data()[k]);
    }
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

std::uint64_t motion(const Solution& solution) {
  Hash hash;
  for (const Arc& arc : solution.arcs()) {
    hash.add(arc.start);
    hash.add(arc.end);
    hash.add(arc.initial);
    hash.add(arc.taut);
    hash.add_all(arc.series);
  }
  for (const Event& event : solution.events()) {
    hash.add(event.time);
    hash.add(static_cast<std::uint64_t>(event.kind));
    hash.add(event.cables);
    hash.add_all(event.impulses);
    hash.add(event.before);
    hash.add(event.after);
  }
  for (const Accumulation& accumulation : solution.accumulations()) {
    hash.add(accumulation.time);
    hash.add(accumulation.uncertainty);
    hash.add(accumulation.energy_lost);
  }
  hash.add(static_cast<std::uint64_t>(solution.ending()));
  if (const auto& swing = solution.swing()) {
    hash.add(swing->energy);
    hash.add(swing->period);
    hash.add(swing->amplitude);
  }
  return hash.value();
}

std::uint64_t bounds(const Case& the_case, const Solution& solution, const SolveOptions& options) {
  Hash hash;
  const Uncertainty uncertainty(the_case, solution, options);
  for (const auto& errors : uncertainty.events()) {
    if (errors) {
      hash.add(errors->time);
      hash.add(errors->rate);
      hash.add_all(errors->impulses);
      hash.add(errors->before);
      hash.add(errors->after);
    }
  }
  return hash.value();
}

void print(const std::string& name, const Case& the_case, const SolveOptions& options = {}) {
  const Solution solution = solve(the_case, options);
  std::printf("%s %016llx %016llx\n", name.c_str(),
              static_cast<unsigned long long>(motion(solution)),
              static_cast<unsigned long long>(bounds(the_case, solution, options)));
}

void print_random_systems() {
  Random random(random_seed);
  SolveOptions options;
  options.max_events = most_events;
  for (int sample = 0; sample < random_systems; ++sample) {
    const auto cables = static_cast<std::size_t>(sample) % max_cables + 1;
    Case the_case = random_case(random, {cables, 0.0, 0.2});
    the_case.duration = 20.0;
    options.law = impact_laws[static_cast<std::size_t>(sample) / max_cables % impact_laws.size()];
    print("random " + std::to_string(sample), the_case, options);
  }
}

void print_hard_systems() {
  Random random(hard_seed);
  SolveOptions options;
  options.max_events = most_events;
  for (int sample = 0; sample < hard_samples; ++sample) {
    const HardFamily& family =
        hard_families()[static_cast<std::size_t>(sample) % hard_families().size()];
    if (const auto system = hard_system(random, family, sample)) {
      options.law = system->law;
      print(std::string(family.name) + " " + std::to_string(sample), system->the_case, options);
    }
  }
}

}  // namespace
}  // namespace tautline::test

int main() {
  for (const tautline::Case& the_case : tautline::shipped_cases()) {
    tautline::test::print(the_case.name, the_case);
  }
  tautline::test::print_random_systems();
  tautline::test::print_hard_systems();
}
