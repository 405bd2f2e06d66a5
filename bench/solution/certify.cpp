#include "bench/solution/certify.hpp"

#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "bench/solution/certify_events.hpp"
#include "bench/solution/in_digits.hpp"
#include "tautline/geometry.hpp"
#include "tautline/multiprecision.hpp"

namespace tautline::bench {
namespace {

/// Completing accumulations costs more the smaller its error: bounces are followed for about the
/// square of its logarithm. This one is far below the rounding of a double and takes seconds [-].
constexpr int completion_digits = 30;

/// Digits left above rounding for the completion, where the numbers have few [-].
constexpr int completion_margin = 2;

/// Each arc is looked at this many times before the first instant that is wrong is bisected.
constexpr int samples_per_arc = 16;

/// Frees at its end the constants that MPFR keeps for its thread, which may end before the program.
struct ThreadConstants {
  ThreadConstants() = default;
  ThreadConstants(const ThreadConstants&) = delete;
  ThreadConstants& operator=(const ThreadConstants&) = delete;
  ThreadConstants(ThreadConstants&&) = delete;
  ThreadConstants& operator=(ThreadConstants&&) = delete;
  ~ThreadConstants() { ::mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

double rounded(const Multi& value) { return static_cast<double>(value); }

EnergyLedger rounded(const BasicEnergyLedger<Multi>& ledger) {
  return {rounded(ledger.start), rounded(ledger.impacts), rounded(ledger.completions),
          rounded(ledger.end), rounded(ledger.residual)};
}

Settling rounded(const BasicSettling<Multi>& settling) {
  Settling result;
  for (const BasicLastImpact<Multi>& last : settling.last_impacts) {
    LastImpact same{rounded(last.speed), std::nullopt};
    if (last.time) {
      same.time = rounded(*last.time);
    }
    result.last_impacts.push_back(same);
  }
  if (const auto& lock = settling.lock) {
    result.lock = {rounded(lock->time), rounded(lock->uncertainty),
                   lock->cables,        lock->permanent,
                   lock->rests,         std::nullopt};
    if (const auto& swing = lock->swing) {
      result.lock->swing = {rounded(swing->energy),    rounded(swing->period),
                            rounded(swing->least),     rounded(swing->largest),
                            rounded(swing->amplitude), swing->angle,
                            swing->goes_round};
    }
  }
  return result;
}

/// Two solutions of one case.
class Pair {
 public:
  Pair(const BasicCase<Multi>& the_case, const Solution& one,
       const BasicSolution<BasicCase<Multi>>& other)
      : case_(the_case), one_(one), other_(other), alignment_(one, other) {
    length_ = the_case.cables.front().length;
    for (const BasicCable<Multi>& cable : the_case.cables) {
      length_ = min(length_, cable.length);
    }
    for (const BasicArc<BasicCase<Multi>>& arc : other.arcs()) {
      speed_ = max(speed_, speed_scale(case_, arc.initial));
      speed_ = max(speed_, speed_scale(case_, arc.after(arc.end - arc.start, other.gravity())));
    }
  }

  [[nodiscard]] const EventMatch& events() const { return alignment_.match(); }

  /// How far they are apart at `time` [-].
  [[nodiscard]] double distance(double time) const {
    const BasicState<Multi> a = in_digits(one_.at(time));
    const BasicState<Multi> b = other_.at(Multi(time));
    Multi result = max(Multi((a.position - b.position).norm() / length_), abs(a.angle - b.angle));
    if (speed_ > 0 && alignment_.between_same_events(time)) {
      const BasicState<Multi> apart{a.position, a.angle, a.velocity - b.velocity, a.spin - b.spin};
      result = max(result, Multi(speed_scale(case_, apart) / speed_));
    }
    return static_cast<double>(result);
  }

  /// Sets `until` where they come to be further apart than 10^-digits.
  void find(CorrectDigits& correct) const {
    const double allowed = std::pow(10.0, -correct.digits);
    const double end = std::min(one_.end_time(), static_cast<double>(other_.end_time()));
    double good = 0.0;
    for (const Arc& arc : one_.arcs_until(end)) {
      for (int sample = 0; sample <= samples_per_arc; ++sample) {
        const double time = arc.start + (arc.end - arc.start) * sample / samples_per_arc;
        if (time > end || distance(time) <= allowed) {
          good = std::min(time, end);
          continue;
        }
        correct.until = last_within(allowed, good, time);
        return;
      }
    }
  }

 private:
  /// The last double before the distance exceeds `allowed`, which it does at `bad`.
  [[nodiscard]] double last_within(double allowed, double good, double bad) const {
    for (double middle = std::midpoint(good, bad); middle > good && middle < bad;
         middle = std::midpoint(good, bad)) {
      (distance(middle) <= allowed ? good : bad) = middle;
    }
    return good;
  }

  const BasicCase<Multi>& case_;
  const Solution& one_;
  const BasicSolution<BasicCase<Multi>>& other_;
  Alignment<Case, BasicCase<Multi>> alignment_;
  Multi length_ = 0;  // [m], of the shortest cable
  Multi speed_ = 0;   // [m/s], the fastest of the body's points
};

}  // namespace

std::optional<std::string> digits_problem(int digits) {
  if (digits >= least_digits && digits <= most_digits) {
    return std::nullopt;
  }
  return fmt::format("--digits {}: must be {} to {}", digits, least_digits, most_digits);
}

Certificate certify(const Case& the_case, const SolveOptions& options, const Solution& solution,
                    int digits) {
  assert(!digits_problem(digits));
  const ThreadConstants constants;
  const tautline::Digits precision(static_cast<unsigned>(digits));
  Certificate result;
  result.digits = digits;
  result.completion_error =
      std::pow(10.0, -std::min(completion_digits, digits - completion_margin));
  SolveOptions sharper = options;
  sharper.completion = {.error = result.completion_error, .speed = std::nullopt};
  const BasicCase<Multi> same_case = in_digits(the_case);
  const BasicSolution<BasicCase<Multi>> other = solve(same_case, sharper);
  const Pair pair(same_case, solution, other);
  for (CorrectDigits& correct : result.correct) {
    pair.find(correct);
  }
  result.events = pair.events();
  result.event_count = other.events().size();
  result.ending = other.ending();
  result.end_time = static_cast<double>(other.end_time());
  result.energy = rounded(energy_ledger(same_case, other));
  result.settling = rounded(settling(same_case, other));
  return result;
}

}  // namespace tautline::bench
