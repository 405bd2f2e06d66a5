// No gravity, and a cable that stays slack: nothing may change the speed or the spin. Engines cut
// what is fast, so that it does not fly through others, and brake what is slow, so that it sleeps.

#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "bench/check/stepping.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// What thousands of roundings to float leave is below, a damping of 0.001 / s above [-].
constexpr double kept_limit = 1e-3;

constexpr double slack = 1e6;  // [m], farther than any body here comes

/// A body in flight without gravity.
Case flight(double speed, double spin) {
  Case result = bouncing_ball();
  result.gravity = Vec2::Zero();
  result.cables.front().length = slack;
  result.initial = {Vec2::Zero(), 0.0, Vec2(0.6 * speed, -0.8 * speed), spin};
  return result;
}

/// A speed or a spin to which an engine cuts what is faster.
struct Cap {
  double value = 0.0;            // [m/s] or [rad/s], at the usual step
  std::optional<double> step_s;  // [m] or [rad], where it is so much in a step, whatever the step
};

/// What a step of `step` leaves of a speed: the lesser of that after it and of the way it made.
double speed_left(const Subject& subject, double step, double speed) {
  const auto simulation = subject.start(flight(speed, 0.0), step);
  simulation->step(step);
  const State after = simulation->state();
  return std::min(after.velocity.norm(), after.position.norm() / step);
}

/// The same of a spin. A step may turn by an arctangent, which is no cap.
double spin_left(const Subject& subject, double step, double spin) {
  const auto simulation = subject.start(flight(0.0, spin), step);
  simulation->step(step);
  const State after = simulation->state();
  const bool turned = std::abs(after.angle) >= (1.0 - kept_limit) * std::atan(spin * step);
  return turned ? std::abs(after.spin) : std::min(std::abs(after.spin), after.angle / step);
}

using Left = double(const Subject& subject, double step, double speed);

/// To what speed a step of `step` cuts growing speeds up to `fastest`; none if it does not.
std::optional<double> cut(const Subject& subject, Left* left, double step, double fastest) {
  for (double speed = 1.0; speed <= fastest; speed *= 2.0) {
    const double kept = left(subject, step, speed);
    if (kept < (1.0 - kept_limit) * speed) {
      return kept;
    }
  }
  return std::nullopt;
}

std::optional<Cap> cap(const Subject& subject, Left* left, double fastest, double fastest_coarse) {
  constexpr double coarse_step = 10.0 * usual_step;
  const auto fine = cut(subject, left, usual_step, fastest);
  if (!fine) {
    return std::nullopt;
  }
  const auto coarse = cut(subject, left, coarse_step, fastest_coarse);
  const double in_a_step = *fine * usual_step;
  const bool of_the_step =
      coarse && std::abs(*coarse * coarse_step / in_a_step - 1.0) < 10.0 * kept_limit;
  return Cap{*fine, of_the_step ? std::optional(in_a_step) : std::nullopt};
}

/// "speeds are cut to 400 m/s", "spins are cut to 785 rad/s, 0.785 rad in a step".
std::string sentence_of(std::string_view what, const Cap& cap, std::string_view unit) {
  std::string text = fmt::format("{} are cut to {:.4g} {}/s", what, cap.value, unit);
  return cap.step_s ? text + fmt::format(", {:.4g} {} in a step", *cap.step_s, unit) : text;
}

// What the cases that ship come to, rounded up: 6.3 m/s in elastic-box, 37.9 rad/s in spinning-rod.
constexpr double usual_speed = 10.0;  // [m/s]
constexpr double usual_spin = 40.0;   // [rad/s]

// Powers of two, as they are tried: beyond what any engine is known to cut but the way of a step.
constexpr double fastest = 8192.0;             // [m/s]
constexpr double fastest_spin = 2048.0;        // [rad/s], 2 rad in the usual step
constexpr double fastest_coarse_spin = 256.0;  // [rad/s], 2.6 rad in the coarse step

/// The caps that growing speeds and spins meet, in words.
std::string caps(const Subject& subject) {
  std::string text;
  if (const auto of_speed = cap(subject, speed_left, fastest, fastest)) {
    text = sentence_of("speeds", *of_speed, "m");
  }
  if (const auto of_spin = cap(subject, spin_left, fastest_spin, fastest_coarse_spin)) {
    text += (text.empty() ? "" : "; ") + sentence_of("spins", *of_spin, "rad");
  }
  return text.empty() ? fmt::format("speeds to {:g} m/s and spins to {:g} rad/s are kept", fastest,
                                    fastest_spin)
                      : text;
}

constexpr std::array slow_speeds = {2.0, 0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4};  // [m/s] and [rad/s]
constexpr double slow_end = 2.5;  // [s]: engines that let bodies sleep wait for 0.5 to 2 s

/// What a slow body lost.
struct Loss {
  double at = 0.0;     // [m/s] or [rad/s], the speed it had
  double share = 0.0;  // [-], of that
  std::string_view of = "speed";

  [[nodiscard]] bool is_kept() const { return share <= kept_limit; }
};

Loss slow_loss(const Subject& subject, double speed) {
  const auto simulation = subject.start(flight(speed, speed), usual_step);
  State last;
  run_whole(*simulation, usual_step, slow_end, [&](const Moment& moment) { last = moment.after; });
  const double of_speed = std::abs(1.0 - last.velocity.norm() / speed);
  const double of_spin = std::abs(1.0 - last.spin / speed);
  return of_spin > of_speed ? Loss{speed, of_spin, "spin"} : Loss{speed, of_speed, "speed"};
}

/// "one at 0.1 m/s loses 61 % of its speed in 2.5 s".
std::string sentence_of(const Loss& loss) {
  return fmt::format("one at {:g} {}/s loses {:.3g} % of its {} in {:g} s", loss.at,
                     loss.of == "spin" ? "rad" : "m", 100.0 * loss.share, loss.of, slow_end);
}

}  // namespace

Measure measure_fast_flight(const Subject& subject) {
  const double found =
      std::max({0.0, 1.0 - speed_left(subject, usual_step, usual_speed) / usual_speed,
                1.0 - spin_left(subject, usual_step, usual_spin) / usual_spin});
  try {
    return {found, kept_limit, caps(subject)};
  } catch (const std::exception& error) {  // what no case here comes to may be refused
    return {found, kept_limit, std::string("what is faster is refused: ") + error.what()};
  }
}

Measure measure_slow_flight(const Subject& subject) {
  double found = 0.0;
  bool some_kept = false;
  std::optional<Loss> first;  // the fastest that is braked
  for (const double speed : slow_speeds) {
    const Loss loss = slow_loss(subject, speed);
    found = std::max(found, loss.share);
    some_kept = some_kept || loss.is_kept();
    if (!first && !loss.is_kept()) {
      first = loss;
    }
  }
  if (!first) {
    return {found, kept_limit,
            fmt::format("speeds of {:g} to {:g} m/s are kept", slow_speeds.back(),
                        slow_speeds.front())};
  }
  return {found, kept_limit,
          (some_kept ? "slow bodies are braked: " : "bodies are damped: ") + sentence_of(*first)};
}

}  // namespace tautline::bench
