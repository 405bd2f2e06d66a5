// Both runs must also end alike: a run that stops at once would agree with anything.

#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "bench/check/cases.hpp"
#include "bench/check/stepping.hpp"

namespace tautline::bench {
namespace {

/// Solvers that go from cable to cable leave 1e-6 by their order in ten sweeps; what rounding
/// grows to is below, in double.
constexpr double mirror_limit = 1e-5;
constexpr double mirror_limit_in_float = 0.1;

constexpr double repeated_until = 3.0;  // [s]
constexpr double mirrored_until = 0.5;  // [s], while rounding has not grown

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The states after each step of a run, and how it ended.
struct Path {
  std::vector<State> states;
  std::optional<Simulation::Stop> stop;
};

Path path(const Subject& subject, const Case& the_case, double end) {
  const auto simulation = subject.start(the_case, usual_step);
  Path result;
  run(*simulation, usual_step, end,
      [&](const Moment& moment) { result.states.push_back(moment.after); });
  result.stop = simulation->stopped();
  return result;
}

/// "goes on" or "stops at t = 1: impacts accumulate".
std::string end_of(const Path& path) {
  return path.stop ? fmt::format("stops at t = {:.4g}: {}", path.stop->time, path.stop->reason)
                   : "goes on";
}

/// The end of a sentence about runs that all agree, one of which stopped as `path` did.
std::string early_end(const Path& path) {
  return path.stop ? fmt::format("; it {}", end_of(path)) : "";
}

/// True if the two end within `steps` of each other.
bool end_together(const Path& a, const Path& b, std::size_t steps) {
  const std::size_t fewer = std::min(a.states.size(), b.states.size());
  const std::size_t more = std::max(a.states.size(), b.states.size());
  return a.stop.has_value() == b.stop.has_value() && more - fewer <= steps;
}

/// The numbers of a state, and of the end, byte by byte.
class Digest {
 public:
  void add(double number) { add(&number, sizeof number); }
  void add(const void* data, std::size_t size) {
    const auto* const bytes = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < size; ++k) {  // FNV-1a
      hash_ = (hash_ ^ bytes[k]) * 1099511628211U;
    }
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 14695981039346656037U;
};

}  // namespace

Measure measure_mirror_symmetry(const Subject& subject) {
  const double limit = subject.in_double() ? mirror_limit : mirror_limit_in_float;
  double found = 0.0;
  std::string ends;
  for (const std::string_view name :
       {"breakwater/19101211150", "tilted-gravity", "plate-four-cables"}) {
    const Case the_case = shipped_case(name);
    const Path original = path(subject, the_case, mirrored_until);
    const Path image = path(subject, mirrored(the_case), mirrored_until);
    // rounding may move a stop into the next step
    if (!end_together(original, image, 1)) {
      return {infinite, limit,
              fmt::format("{}: the run {}, its mirror image {}", name, end_of(original),
                          end_of(image))};
    }
    for (std::size_t k = 0; k < std::min(original.states.size(), image.states.size()); ++k) {
      found = worse(found, largest_difference(original.states[k], mirrored(image.states[k])));
    }
    ends += original.stop ? fmt::format("; {} {}", name, end_of(original)) : "";
  }
  // a fall onto both cables at once stays on the mirror's line
  Case symmetric = standard_breakwater(0.9);
  symmetric.initial = {Vec2(0.0, 0.3), 0.0, Vec2::Zero(), 0.0};
  const Path on_the_line = path(subject, symmetric, 2.0);
  for (const State& state : on_the_line.states) {
    found = worse(found, std::max(std::abs(state.position.x()), std::abs(state.spin)));
  }
  ends += on_the_line.stop ? "; a fall onto two cables at once " + end_of(on_the_line) : "";
  return {found, limit,
          found <= limit
              ? fmt::format("the mirrored case moves in the mirror, to {:.2g}", found) + ends
              : fmt::format("the mirrored case does not move in the mirror: off by "
                            "{:.2g}; left and right, or the order of cables, matter",
                            found)};
}

Measure measure_determinism(const Subject& subject) {
  const Case the_case = shipped_case("plate-four-cables");
  const Path first = path(subject, the_case, repeated_until);
  const Path second = path(subject, the_case, repeated_until);
  if (!end_together(first, second, 0)) {
    return {
        infinite, 0.0,
        fmt::format("not deterministic: a run {}, a second one {}", end_of(first), end_of(second))};
  }
  double found = 0.0;
  std::size_t differs_at = first.states.size();
  for (std::size_t k = 0; k < first.states.size(); ++k) {
    const double apart = largest_difference(first.states[k], second.states[k]);
    differs_at = apart != 0.0 ? std::min(differs_at, k) : differs_at;
    found = worse(found, apart);
  }
  return {found, 0.0,
          found == 0.0
              ? "a second run is the same, bit by bit" + early_end(first)
              : fmt::format("not deterministic: a second run of the same case differs, from "
                            "t = {:.4g} on, by up to {:.2g}",
                            static_cast<double>(differs_at + 1) * usual_step, found)};
}

std::string run_digest(const Engine& engine, const std::string& model) {
  const Path run = path(Subject(engine, model), shipped_case("plate-four-cables"), repeated_until);
  Digest digest;
  for (const State& state : run.states) {
    for (const double number : {state.position.x(), state.position.y(), state.angle,
                                state.velocity.x(), state.velocity.y(), state.spin}) {
      digest.add(number);
    }
  }
  if (run.stop) {
    digest.add(run.stop->time);
    digest.add(run.stop->reason.data(), run.stop->reason.size());
  }
  return digest.text();
}

}  // namespace tautline::bench
