// Solves the shipped cases, random systems and hard ones, and prints a line for each: its name and
// a hash of every bit of its motion. Whatever compiles it, and whatever the solver's text is,
// prints the same: tests/analytic/benchmarks/same-bits holds two compilers to that, and its output
// can be kept to compare commits.
//
//   double   1,000 random systems and 300 hard ones, with the bounds of their errors
//   batch    the same by solve_batch, without the bounds
//   digits   the shipped cases and 100 random systems, in 60 digits

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hard/hard_families.hpp"
#include "support.hpp"
#include "tautline/impact.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/solve_batch.hpp"
#include "tautline/uncertainty.hpp"
#ifdef TAUTLINE_BITS_OF_DIGITS
#include "bench/solution/in_digits.hpp"
#endif

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
  template <class Real>
  void add(const Real& value) {
    if constexpr (std::is_same_v<Real, double>) {  // what is no number has no sign that matters
      add(std::isnan(value) ? std::uint64_t{1} : std::bit_cast<std::uint64_t>(value));
    } else {
      Real rest = value;
      for (int part = 0; part < 4; ++part) {  // 64 digits
        const auto leading = static_cast<double>(rest);
        add(leading);
        rest -= Real(leading);
      }
    }
  }
  template <class Real>
  void add(const BasicState<Real>& state) {
    for (const Real& value : {state.position.x(), state.position.y(), state.angle,
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

/// Of all arcs, events, accumulations and the ending.
template <class Real>
std::uint64_t motion_bits(const BasicSolution<BasicCase<Real>>& solution) {
  Hash hash;
  for (const BasicArc<BasicCase<Real>>& arc : solution.arcs()) {
    hash.add(arc.start);
    hash.add(arc.end);
    hash.add(arc.initial);
    hash.add(arc.taut);
    hash.add_all(arc.series);
  }
  for (const BasicEvent<BasicCase<Real>>& event : solution.events()) {
    hash.add(event.time);
    hash.add(static_cast<std::uint64_t>(event.kind));
    hash.add(event.cables);
    hash.add_all(event.impulses);
    hash.add(event.before);
    hash.add(event.after);
  }
  for (const BasicAccumulation<Real>& accumulation : solution.accumulations()) {
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

/// Of the bounds of all errors at its events.
std::uint64_t bound_bits(const Uncertainty& uncertainty) {
  Hash hash;
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

void print(const std::string& name, std::uint64_t motion) {
  std::printf("%s %016llx", name.c_str(), static_cast<unsigned long long>(motion));
}

void print_in_double(const std::string& name, const Case& the_case, const SolveOptions& options) {
  const Solution solution = solve(the_case, options);
  print(name, motion_bits(solution));
  const std::uint64_t bounds = bound_bits(Uncertainty(the_case, solution, options));
  std::printf(" %016llx\n", static_cast<unsigned long long>(bounds));
}

void print_by_batch(const std::string& name, const Case& the_case, const SolveOptions& options) {
  // beside one that is always in flight
  solve_batch(std::vector<Case>{the_case, bouncing_ball(), the_case}, options,
              [&](std::size_t index, const Solution& solution) {
                if (index != 1) {
                  print(name + (index == 0 ? " first" : " last"), motion_bits(solution));
                  std::printf("\n");
                }
              });
}

#ifdef TAUTLINE_BITS_OF_DIGITS
void print_in_digits(const std::string& name, const Case& the_case, const SolveOptions& options) {
  const Digits digits(60);
  print(name, motion_bits(solve(bench::in_digits(the_case), options)));
  std::printf("\n");
}
#endif

using Print = void (*)(const std::string&, const Case&, const SolveOptions&);

void print_random_systems(Print print_one, int count, std::size_t events) {
  Random random(random_seed);
  SolveOptions options;
  options.max_events = events;
  for (int sample = 0; sample < count; ++sample) {
    const auto cables = static_cast<std::size_t>(sample) % max_cables + 1;
    Case the_case = random_case(random, {cables, 0.0, 0.2});
    the_case.duration = 20.0;
    options.law = impact_laws[static_cast<std::size_t>(sample) / max_cables % impact_laws.size()];
    print_one("random " + std::to_string(sample), the_case, options);
  }
}

void print_hard_systems(Print print_one) {
  Random random(hard_seed);
  SolveOptions options;
  options.max_events = most_events;
  for (int sample = 0; sample < hard_samples; ++sample) {
    const HardFamily& family =
        hard_families()[static_cast<std::size_t>(sample) % hard_families().size()];
    if (const auto system = hard_system(random, family, sample)) {
      options.law = system->law;
      print_one(std::string(family.name) + " " + std::to_string(sample), system->the_case, options);
    }
  }
}

void print_shipped_cases(Print print_one, std::size_t events) {
  SolveOptions options;
  options.max_events = events;
  for (const Case& the_case : shipped_cases()) {
    print_one(the_case.name, the_case, options);
  }
}

}  // namespace
}  // namespace tautline::test

int main(int argc, char** argv) {
  using namespace tautline::test;
  const std::string_view how = argc > 1 ? argv[1] : "double";
#ifdef TAUTLINE_BITS_OF_DIGITS
  if (how == "digits") {
    constexpr std::size_t events = 100;  // each takes a thousand times as long
    constexpr int systems = 100;
    print_shipped_cases(print_in_digits, events);
    print_random_systems(print_in_digits, systems, events);
    return 0;
  }
#endif
  if (how != "double" && how != "batch") {
    std::fprintf(stderr, "%s: must be double, batch or, where it is built in, digits\n",
                 std::string(how).c_str());
    return 2;
  }
  const Print print_one = how == "double" ? print_in_double : print_by_batch;
  print_shipped_cases(print_one, tautline::SolveOptions{}.max_events);
  print_random_systems(print_one, random_systems, most_events);
  print_hard_systems(print_one);
  return 0;
}
