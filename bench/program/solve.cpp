#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/solution/certify.hpp"
#include "bench/solution/digits/many_digits.hpp"
#include "bench/solution/plot_svg.hpp"
#include "bench/solution/solution_json.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// What `tautline solve` was asked.
struct SolveCommand {
  std::string the_case;
  std::optional<double> until;        // [s], instead of the case's duration
  std::vector<double> at;             // [s], times of samples
  std::optional<double> angle_limit;  // [rad], instead of the case's
  std::optional<double> ceiling;      // [m], instead of the case's
  std::vector<std::size_t> taut;      // cables that start taut
  ImpactLaw law = ImpactLaw::simultaneous;
  std::int64_t max_events = static_cast<std::int64_t>(SolveOptions().max_events);
  std::int64_t max_steps = static_cast<std::int64_t>(SolveOptions().max_steps);
  bool certify = false;       // also solve with more digits, and compare
  std::optional<int> digits;  // of that, `default_digits` if not given; else right ones to print
  bool decimal = false;       // of the decimals that the case is written in
  std::string json;           // file, "-" for standard output, or empty
  std::string plot;           // the same, for a picture (SVG)
  bool events = false;        // print all of them
};

/// Everything `solve` says of a case beside its motion.
struct Extras {
  Settling settling;
  std::optional<Certificate> certificate;
};

/// The summary first, and below it what was asked for.
void print_solution(const SolveCommand& command, const Case& the_case, const SolveOptions& options,
                    const Solution& solution, const Extras& extras) {
  const Uncertainty uncertainty(the_case, solution, options);
  const TerminalStyle style = output_style();
  fmt::print(
      "{}: {} cable{}, {} event{}\n\n{}", printable(the_case.name), the_case.cables.size(),
      the_case.cables.size() == 1 ? "" : "s", solution.events().size(),
      solution.events().size() == 1 ? "" : "s",
      wrapped_lines(solution_text(the_case, solution, extras.settling, uncertainty), style.text));
  if (extras.certificate) {
    fmt::print("\n{}",
               wrapped_lines(certificate_text(*extras.certificate, the_case, solution, style),
                             style.text, 2));
  }
  fmt::print("{}{}", samples_text(solution, uncertainty, command.at, style),
             events_text(the_case, solution, uncertainty, command.events, style));
}

/// The one case that `command` means, with its overrides; or complains.
std::optional<Case> wanted_case(const SolveCommand& command) {
  CableSet taut;
  for (const std::size_t index : command.taut) {
    if (index >= max_cables) {
      complain({fmt::format("--taut {}: cables count from 0 to {}", index, max_cables - 1)});
      return std::nullopt;
    }
    taut.insert(index);
  }
  std::optional<Case> found = one_case(command.the_case, taut);
  if (!found) {
    return std::nullopt;
  }
  found->duration = command.until.value_or(found->duration);
  found->angle_limit = command.angle_limit ? command.angle_limit : found->angle_limit;
  found->ceiling = command.ceiling ? command.ceiling : found->ceiling;
  if (complain(problems(*found))) {
    return std::nullopt;
  }
  return found;
}

/// What is wrong with --certify, --digits and --decimal; none if nothing is.
std::optional<std::string> digits_usage_problem(const SolveCommand& command) {
  if (command.decimal && (!command.digits || command.certify)) {
    return "--decimal: is for --digits without --certify";
  }
  if (!command.digits || command.certify) {
    return command.digits ? digits_problem(*command.digits) : std::nullopt;
  }
  if (*command.digits < 1 || *command.digits > most_right_digits) {
    return fmt::format("--digits {}: must be 1 to {}", *command.digits, most_right_digits);
  }
  if (!command.json.empty() || !command.plot.empty()) {
    return fmt::format(
        "--digits {}: prints a summary, samples and events; --json and --plot need --certify",
        *command.digits);
  }
  return std::nullopt;
}

/// What is wrong with --plot and --json together; none if nothing is.
std::optional<std::string> output_problem(const SolveCommand& command) {
  if (command.plot.empty() || command.json.empty()) {
    return std::nullopt;
  }
  if (command.plot == "-" && command.json == "-") {
    return "--plot - and --json -: standard output takes one of them; give the other a file";
  }
  const auto file = [](const std::string& name) {
    return std::filesystem::absolute(name).lexically_normal();
  };
  if (command.plot != "-" && command.json != "-" && file(command.plot) == file(command.json)) {
    return fmt::format("--plot and --json are both {}: one would overwrite the other",
                       printable(command.plot));
  }
  return std::nullopt;
}

/// Everything that is wrong with what was asked, but for the case.
std::vector<std::string> usage_problems(const SolveCommand& command) {
  std::vector<std::string> broken = missing_folder("--json", command.json);
  append(broken, missing_folder("--plot", command.plot));
  for (const auto& [option, most] : {std::pair("--max-events", command.max_events),
                                     std::pair("--max-steps", command.max_steps)}) {
    if (most < 1) {
      broken.push_back(fmt::format("{} {}: must be at least 1", option, most));
    }
  }
  for (const auto& sentence : {digits_usage_problem(command), output_problem(command)}) {
    if (sentence) {
      broken.push_back(*sentence);
    }
  }
  return broken;
}

/// Says on standard error with how many digits the motion is solved next, where it takes long.
class PatienceNote {
 public:
  void operator()(int digits) const {
    constexpr std::chrono::seconds long_enough{1};
    if (std::chrono::steady_clock::now() - begin_ >= long_enough) {
      fmt::print(stderr, "tautline: going on with numbers of {} digits\n", digits);
    }
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A motion that was given up is a failure, though what is told of it is right.
int exit_code(Ending ending) {
  const bool given_up = ending == Ending::event_limit || ending == Ending::step_limit ||
                        ending == Ending::no_progress;
  return given_up ? exit_failed : exit_done;
}

int solve_command(const SolveCommand& command) {
  if (complain(usage_problems(command))) {
    return exit_usage;
  }
  const std::optional<Case> the_case = wanted_case(command);
  if (!the_case) {
    return exit_usage;
  }
  SolveOptions options;
  options.law = command.law;
  options.max_events = static_cast<std::size_t>(command.max_events);
  options.max_steps = static_cast<std::size_t>(command.max_steps);
  const Solution solution = solve(*the_case, options);
  if (complain(sample_problems(solution, command.at))) {
    return exit_usage;
  }
  if (command.digits && !command.certify) {
    fmt::print("{}", many_digits_text(*the_case, options, solution,
                                      {*command.digits, command.decimal, command.events,
                                       literals_of(command.the_case), command.at, PatienceNote()},
                                      output_style()));
    return exit_code(solution.ending());
  }
  Extras extras{settling(*the_case, solution), std::nullopt};
  if (command.certify) {
    extras.certificate =
        certify(*the_case, options, solution, command.digits.value_or(default_digits));
  }
  if (!command.plot.empty()) {
    write_output(command.plot, plot_svg(*the_case, solution));
  }
  if (command.json.empty()) {
    if (command.plot != "-") {
      print_solution(command, *the_case, options, solution, extras);
    }
    return exit_code(solution.ending());
  }
  write_output(command.json, solution_json(*the_case, options, solution, extras.settling,
                                           command.at, extras.certificate));
  return exit_code(solution.ending());
}

}  // namespace

void add_solve(CLI::App& app, int& code) {
  CLI::App* const command =
      app.add_subcommand("solve", "The exact motion of a case: its events and its end");
  const auto asked = std::make_shared<SolveCommand>();
  command->add_option("CASE", asked->the_case, case_help)->required();
  command->add_option("--until", asked->until,
                      "end the run at this time [s], not at the case's duration");
  command->add_option("--at", asked->at, "also give the state at these times [s]: 1,2.5,3")
      ->delimiter(',');
  command->add_option("--angle-limit", asked->angle_limit, "end where |angle| reaches this [rad]");
  command->add_option("--ceiling", asked->ceiling,
                      "end where an attachment rises to this height [m]");
  command
      ->add_option("--taut", asked->taut,
                   "cables that start taut: 0,1; the start moves as little as that takes, at most "
                   "0.001 of a length")
      ->delimiter(',');
  add_law(*command, asked->law, "the law for impacts on several cables");
  command->add_flag("--certify", asked->certify,
                    "also solve with many digits, and say until when the doubles are right");
  command->add_option("--digits", asked->digits,
                      "print so many right digits, 1 to 100; with --certify: compute with so "
                      "many, 20 to 1000 (default: 50)");
  command->add_flag("--decimal", asked->decimal,
                    "--digits of the decimals that the case is written in, not of their doubles");
  add_target(*command, "--json", asked->json, "write everything as JSON");
  add_target(*command, "--plot", asked->plot, "write a picture of the motion (SVG)");
  command->add_option("--max-events", asked->max_events,
                      fmt::format("give up after so many events (default: {})", asked->max_events));
  command->add_option("--max-steps", asked->max_steps,
                      fmt::format("give up after so many steps of taut motion, and of springs "
                                  "within impacts (default: {})",
                                  asked->max_steps));
  command->add_flag("--events", asked->events, "print all events, not the first 20");
  command->footer(
      "tautline solve breakwater/1910121100 --digits 12     twelve right digits\n"
      "tautline solve bouncing-ball --until 2.7             a few events\n"
      "tautline solve breakwater/1910121100 --plot p.svg    a picture of the motion");
  command->callback([asked, &code] { code = solve_command(*asked); });
}

}  // namespace tautline::bench
