#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "fuzz/targets.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"
#include "tautline/solve_batch.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::fuzz {
namespace {

/// Few enough for a fuzzer to solve many systems a second.
constexpr std::size_t most_events = 100;
constexpr std::size_t most_steps = 100;

/// Numbers near the borders of what a case may have, and ordinary ones.
constexpr std::array edges = {0.0,   1.0,  -1.0,  0.5,   2.0,   -0.0, 1e-60, 1e20, -1e20,
                              1e-20, 1e-9, 1e-12, 1e9,   1e6,   -1e6, 0.1,   1e-3, 1e-300,
                              9.81,  10.0, 3.0,   1e-16, -1e-9, -0.1, 1e12,  -2.0};

/// Makes numbers from bytes. After the last byte all of them are zeros.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t below(std::size_t count) { return next() % count; }

  /// One of `edges`, an ordinary number or any finite double.
  [[nodiscard]] double number() {
    const std::size_t how = next();
    if (how < edges.size()) {
      return edges.at(how);
    }
    if (how < 192) {  // from -3.3 to 3.3
      const std::size_t high = next();
      return (static_cast<double>(256 * high + next()) - 32768.0) * 1e-4;
    }
    std::array<char, sizeof(double)> bits{};
    std::generate(bits.begin(), bits.end(), [&] { return static_cast<char>(next()); });
    double value = 0.0;
    std::memcpy(&value, bits.data(), sizeof value);
    return std::isfinite(value) ? std::clamp(value, -largest_number, largest_number) : 1.0;
  }

  [[nodiscard]] double size() {
    const double value = std::abs(number());
    return value < smallest_divisor ? 1.0 : value;
  }
  [[nodiscard]] double part() {
    const double value = std::abs(number());
    return value <= 1.0 ? value : 1.0 / value;
  }
  [[nodiscard]] Vec2 point() {
    const double x = number();
    return {x, number()};
  }

 private:
  std::size_t next() {
    if (place_ == bytes_.size()) {
      return 0;
    }
    return static_cast<unsigned char>(bytes_[place_++]);
  }

  std::string_view bytes_;
  std::size_t place_ = 0;
};

Cable cable_from(Bytes& bytes, const Case& so_far, bool point_mass) {
  Cable cable;
  cable.anchor = bytes.point();
  cable.attachment = point_mass ? Vec2(0.0, 0.0) : bytes.point();
  const double slack = bytes.below(2) == 0 ? 0.0 : bytes.part();
  const double distance = (attachment_point(so_far.initial, cable) - cable.anchor).norm();
  cable.length = std::max(distance * (1.0 + slack), smallest_divisor);
  cable.restitution = bytes.part();
  cable.capture_speed = bytes.below(8) == 0 ? bytes.part() : 0.0;
  return cable;
}

Case system_from(Bytes& bytes) {
  Case result;
  result.name = "extreme";
  const std::size_t count = 1 + bytes.below(4);
  const bool point_mass = bytes.below(4) == 0;
  result.body = {bytes.size(), point_mass ? 0.0 : bytes.size()};
  result.gravity = bytes.point();
  result.duration = bytes.size();
  result.initial.position = bytes.point();
  result.initial.angle = bytes.number();
  result.initial.velocity = bytes.point();
  result.initial.spin = bytes.number();
  for (std::size_t index = 0; index < count; ++index) {
    result.cables.push_back(cable_from(bytes, result, point_mass));
  }
  return result;
}

bool is_finite(const State& state) {
  return state.position.allFinite() && state.velocity.allFinite() && std::isfinite(state.angle) &&
         std::isfinite(state.spin);
}

void require_motion(const Case& the_case, const Solution& solution) {
  require(!solution.arcs().empty(), "a motion has an arc");
  double time = 0.0;
  for (const Arc& arc : solution.arcs()) {
    require(arc.start == time && arc.end >= arc.start, "arcs follow each other in time");
    require(is_finite(arc.initial), "an arc starts at numbers");
    time = arc.end;
  }
  require(time <= the_case.duration && solution.end_time() <= the_case.duration,
          "a motion ends with its duration");
  double before = 0.0;
  for (const Event& event : solution.events()) {
    require(event.time >= before && event.time <= time, "events follow each other in time");
    require(is_finite(event.before) && is_finite(event.after), "events are of numbers");
    require(event.impulses.allFinite(), "impulses are numbers");
    before = event.time;
  }
  for (const double part : {0.0, 0.3, 1.0}) {
    require(is_finite(solution.at(part * solution.end_time())), "states are numbers");
    require(solution.tensions(part * solution.end_time()).allFinite(), "tensions are numbers");
  }
  require(solution.events().size() <= most_events + max_cables, "the limit of events holds");
}

void require_bounds(const Case& the_case, const Solution& solution, const SolveOptions& options) {
  const Uncertainty uncertainty(the_case, solution, options);
  require(uncertainty.events().size() == solution.events().size(), "each event has its bounds");
  for (const double part : {0.0, 0.5, 1.0}) {
    const double time = part * solution.end_time();
    static_cast<void>(uncertainty.at(time));
    static_cast<void>(uncertainty.energy(time));
  }
  static_cast<void>(uncertainty.lock());
}

}  // namespace

void fuzz_systems(std::string_view input) {
  Bytes bytes(input);
  SolveOptions options;
  options.max_events = most_events;
  options.max_steps = most_steps;
  options.law = impact_laws.at(bytes.below(impact_laws.size()));
  options.until_locked = bytes.below(2) == 1;
  options.swing_ahead = options.until_locked && bytes.below(2) == 1;
  const Case the_case = system_from(bytes);
  if (!problems(the_case).empty()) {
    return;
  }
  const Solution solution = solve(the_case, options);
  require_motion(the_case, solution);
  require_bounds(the_case, solution, options);
  solve_batch({&the_case, 1}, options, [&](std::size_t /*index*/, const Solution& batched) {
    require(batched.ending() == solution.ending() &&
                batched.events().size() == solution.events().size() &&
                batched.end_time() == solution.end_time(),
            "a batch solves as solve does");
  });
}

}  // namespace tautline::fuzz
