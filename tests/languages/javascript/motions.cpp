// Solves the shipped cases and 1,000 random systems, and writes to standard output what the module
// must have to the same bits: for each system a line of JSON, {"case": ..., "options": ...,
// "numbers": N}, and then N doubles.
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "support.hpp"
#include "tautline/case_text.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::test {
namespace {

constexpr int random_systems = 1'000;
constexpr std::uint64_t seed = 20261127;
constexpr std::size_t most_events = 300;  // of one system; elastic cables may have millions
constexpr int instants = 20;              // of each motion
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The numbers of one motion, in the order in which the test in JavaScript asks for them.
class Numbers {
 public:
  void add(double number) { all_.push_back(number); }
  void add(const State& state) {
    all_.insert(all_.end(), {state.position.x(), state.position.y(), state.angle,
                             state.velocity.x(), state.velocity.y(), state.spin});
  }
  void add(CableSet cables) {
    double bits = 0.0;
    for (const std::size_t cable : cables) {
      bits += std::ldexp(1.0, static_cast<int>(cable));
    }
    add(bits);
  }
  /// One of each cable of the case.
  void add(const CableVector& of, CableSet cables, std::size_t count) {
    std::vector<double> row(count, 0.0);
    Eigen::Index place = 0;
    for (const std::size_t cable : cables) {
      if (place < of.size()) {
        row[cable] = of[place++];
      }
    }
    all_.insert(all_.end(), row.begin(), row.end());
  }
  void add_none(std::size_t count) { all_.insert(all_.end(), count, none); }
  [[nodiscard]] const std::vector<double>& all() const { return all_; }

 private:
  std::vector<double> all_;
};

void add_events(Numbers& to, const Case& the_case, const Solution& solution) {
  const std::size_t cables = the_case.cables.size();
  for (const Event& event : solution.events()) {
    to.add(event.time);
    to.add(static_cast<double>(event.kind));
    to.add(event.cables);
    to.add(event.before);
    to.add(event.after);
    to.add(event.impulses, event.cables, cables);
  }
  for (const Arc& arc : solution.arcs()) {
    to.add(arc.start);
    to.add(arc.end);
    to.add(arc.taut);
  }
  for (const Accumulation& one : solution.accumulations()) {
    for (const double number : {one.start, one.time, one.uncertainty, one.energy_lost}) {
      to.add(number);
    }
    to.add(one.cables);
  }
}

void add_bounds(Numbers& to, const Case& the_case, const Solution& solution,
                const SolveOptions& options) {
  const Uncertainty bounds(the_case, solution, options);
  const std::size_t cables = the_case.cables.size();
  constexpr std::size_t of_state = 6;
  std::size_t index = 0;
  for (const auto& errors : bounds.events()) {
    if (errors) {
      to.add(errors->time);
      to.add(errors->rate);
      to.add(errors->before);
      to.add(errors->after);
      to.add(errors->impulses, solution.events()[index].cables, cables);
    } else {
      to.add_none(2 + 2 * of_state + cables);
    }
    ++index;
  }
  to.add(bounds.horizon().value_or(std::numeric_limits<double>::infinity()));
  to.add(bounds.lock().value_or(none));
  for (const Unsure& one : bounds.unsure()) {
    to.add(one.from);
    to.add(one.until);
  }
  for (int instant = 0; instant <= instants; ++instant) {
    const double time = solution.end_time() * (static_cast<double>(instant) / instants);
    to.add(solution.at(time));
    const auto error = bounds.at(time);
    error ? to.add(*error) : to.add_none(of_state);
    to.add(energy(the_case, solution.at(time)));
    to.add(bounds.energy(time).value_or(none));
    const CableVector pulls = solution.tensions(time);
    for (Eigen::Index cable = 0; cable < pulls.size(); ++cable) {
      to.add(pulls[cable]);
    }
  }
}

void add_settling(Numbers& to, const Case& the_case, const Solution& solution) {
  const Settling found = settling(the_case, solution);
  to.add(found.lock ? found.lock->time : none);
  to.add(found.lock && found.lock->swing ? found.lock->swing->period : none);
  to.add(found.lock && found.lock->swing ? found.lock->swing->amplitude : none);
  to.add(static_cast<double>(solution.ending()));
}

bool write(const Case& the_case, const SolveOptions& options) {
  const Solution solution = solve(the_case, options);
  Numbers numbers;
  add_events(numbers, the_case, solution);
  add_bounds(numbers, the_case, solution, options);
  add_settling(numbers, the_case, solution);
  const std::vector<double>& all = numbers.all();
  std::printf(R"({"case": %s, "options": {"law": "%s", "max_events": %zu}, "numbers": %zu})"
              "\n",
              write_case_json(the_case).c_str(), std::string(to_string(options.law)).c_str(),
              options.max_events, all.size());
  return std::fwrite(all.data(), sizeof(double), all.size(), stdout) == all.size();
}

bool write_all() {
  bool written = true;
  SolveOptions options;
  options.max_events = most_events;
  for (const Case& the_case : shipped_cases()) {
    written = write(the_case, options) && written;
  }
  Random random(seed);
  for (int sample = 0; sample < random_systems; ++sample) {
    Draw draw;
    draw.cables = static_cast<std::size_t>(sample) % max_cables + 1;
    draw.taut_chance = sample % 3 == 0 ? 0.3 : 0.0;
    Case the_case = random_case(random, draw);
    the_case.name = "random " + std::to_string(sample);
    the_case.duration = 20.0;
    options.law = impact_laws[static_cast<std::size_t>(sample) / max_cables % impact_laws.size()];
    written = write(the_case, options) && written;
  }
  return written;
}

}  // namespace
}  // namespace tautline::test

int main() { return tautline::test::write_all() ? 0 : 1; }
