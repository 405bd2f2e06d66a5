#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/commands.hpp"
#include "bench/solution_json.hpp"
#include "bench/table.hpp"
#include "bench/text.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

std::string cable_list(CableSet cables) {
  std::string result;
  for (const std::size_t index : cables) {
    result += (result.empty() ? "" : "+") + std::to_string(index);
  }
  return result;
}

/// The fastest closing rate and the sum of the impulses of one event.
std::vector<std::string> event_cells(const Case& the_case, const Event& event) {
  double closing = 0.0;
  for (const std::size_t index : event.cables) {
    closing = std::max(closing, -gap_rate(the_case.cables[index], event.before));
  }
  const State& after = event.after;
  return {fmt::format("{:.12f}", event.time),
          std::string(to_string(event.kind)),
          cable_list(event.cables),
          fmt::format("{:.6e}", closing),
          fmt::format("{:.6e}", event.impulses.sum()),
          fmt::format("{:.6f}", after.position.x()),
          fmt::format("{:.6f}", after.position.y()),
          fmt::format("{:.6f}", after.angle),
          fmt::format("{:.6f}", after.velocity.x()),
          fmt::format("{:.6f}", after.velocity.y()),
          fmt::format("{:.6f}", after.spin)};
}

/// What an ending means, in a sentence.
std::string ending_sentence(const Case& the_case, const Solution& solution) {
  const double end = solution.end_time();
  switch (solution.ending()) {
    case Ending::reached_duration:
      return fmt::format("The run reached its duration, t = {}.", end);
    case Ending::zeno:
      return fmt::format(
          "Impacts accumulate on cable {} at t = {:.9f} (+- {:.0e}): infinitely many before then.\n"
          "{:.6g} of the initial energy {:.6g} is left for the motion on taut cables, which is not "
          "followed further.",
          cable_list(solution.accumulation()->cables), solution.accumulation()->time,
          solution.accumulation()->uncertainty, solution.accumulation()->energy,
          energy(the_case, the_case.initial));
    case Ending::taut:
      return fmt::format(
          "Cable {} stays taut from t = {:.9f}; the motion on taut cables is not followed further.",
          cable_list(solution.events().back().cables), end);
    case Ending::angle_limit:
      return fmt::format("|angle| reached the limit {} at t = {:.9f}.", *the_case.angle_limit, end);
    case Ending::ceiling:
      return fmt::format("An attachment reached the ceiling {} at t = {:.9f}.", *the_case.ceiling,
                         end);
    case Ending::event_limit:
      return fmt::format("Stopped after {} events, at t = {:.9f}.", solution.events().size(), end);
    case Ending::overflow:
      return fmt::format(
          "Stopped at t = {:.9f}: past it the motion has numbers too large for a double.", end);
  }
  return "";
}

void print_solution(const Case& the_case, const Solution& solution,
                    const std::vector<double>& times) {
  fmt::print("{}: {} cable{}, {} events\n\n", printable(the_case.name), the_case.cables.size(),
             the_case.cables.size() == 1 ? "" : "s", solution.events().size());
  Table events({"event at", "kind", "cables", "closing rate", "impulse", "x", "y", "angle", "vx",
                "vy", "spin"},
               0);
  for (const Event& event : solution.events()) {
    events.add(event_cells(the_case, event));
  }
  if (!events.empty()) {
    fmt::print("{}\n", events.plain());
  }
  Table samples({"sample at", "x", "y", "angle", "vx", "vy", "spin"}, 0);
  for (const double time : times) {
    const State state = solution.at(time);
    samples.add({shortest(time), shortest(state.position.x()), shortest(state.position.y()),
                 shortest(state.angle), shortest(state.velocity.x()), shortest(state.velocity.y()),
                 shortest(state.spin)});
  }
  if (!samples.empty()) {
    fmt::print("{}\n", samples.plain());
  }
  fmt::print("{}\n", ending_sentence(the_case, solution));
}

/// The one case that `command` means, with its overrides; or complains.
std::optional<Case> wanted_case(const SolveCommand& command) {
  std::optional<Case> found = one_case(command.the_case);
  if (!found) {
    return std::nullopt;
  }
  found->duration = command.until.value_or(found->duration);
  found->angle_limit = command.angle_limit ? command.angle_limit : found->angle_limit;
  found->ceiling = command.ceiling ? command.ceiling : found->ceiling;
  if (const auto broken = problems(*found); !broken.empty()) {
    complain(broken);
    return std::nullopt;
  }
  return found;
}

}  // namespace

int solve_command(const SolveCommand& command) {
  const std::optional<Case> the_case = wanted_case(command);
  if (!the_case) {
    return exit_usage;
  }
  const SolveOptions options;
  const Solution solution = solve(*the_case, options);
  const std::vector<std::string> broken = sample_problems(solution, command.at);
  if (!broken.empty()) {
    complain(broken);
    return exit_usage;
  }
  if (command.json.empty()) {
    print_solution(*the_case, solution, command.at);
    return exit_done;
  }
  write_output(command.json,
               solution_json(*the_case, options, solution, command.at).dump(2) + "\n");
  return exit_done;
}

}  // namespace tautline::bench
