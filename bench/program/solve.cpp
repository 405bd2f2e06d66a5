#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>

#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/cases/literals.hpp"
#include "bench/plot/motion.hpp"
#include "bench/plot/svg.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/patience.hpp"
#include "bench/program/solve_files.hpp"
#include "bench/solution/certify.hpp"
#include "bench/solution/json/solution_json.hpp"
#include "bench/solution/many_digits.hpp"
#include "bench/solution/sample_times.hpp"
#include "bench/solution/samples.hpp"
#include "bench/solution/system_text.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// What `tautline solve` was asked.
struct SolveCommand {
  std::vector<std::string> cases;
  std::optional<double> until;        // [s], instead of the case's duration
  std::vector<std::string> at;        // times of samples, and ranges of them
  std::optional<double> every;        // [s], between samples
  std::optional<double> angle_limit;  // [rad], instead of the case's
  std::optional<double> ceiling;      // [m], instead of the case's
  std::vector<std::int64_t> taut;     // cables that start taut
  ImpactLaw law = ImpactLaw::simultaneous;
  std::int64_t max_events = static_cast<std::int64_t>(SolveOptions().max_events);
  std::int64_t max_steps = static_cast<std::int64_t>(SolveOptions().max_steps);
  bool certify = false;       // also solve with more digits, and compare
  std::optional<int> digits;  // of that, `default_digits` if not given; else right ones to print
  bool decimal = false;       // of the decimals that the case is written in
  std::string json;           // file, "-" for standard output, or empty
  std::vector<std::string> plots;  // KIND=FILE, KIND or FILE: pictures
  std::string csv;                 // the same, for the samples
  bool events = false;             // print all of them
  bool fast = false;               // of systems: without the solution in 30 digits
};

/// Everything `solve` says of a case beside its motion.
struct Extras {
  Settling settling;
  std::optional<Certificate> certificate;
  std::vector<double> times;  // [s], of samples
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
  const bool in_a_table = command.csv.empty();  // else the file has the samples
  fmt::print("{}{}{}",
             in_a_table ? samples_text(the_case, solution, uncertainty, extras.times, style) : "",
             events_text(the_case, solution, uncertainty, command.events, style),
             command.events ? tensions_text(the_case, solution, uncertainty, style) : "");
}

/// A sentence for each option of `command` that is for cases alone.
std::vector<std::string> for_cases_alone(const SolveCommand& command) {
  std::vector<std::string> result;
  for (const auto& [option, is_there] :
       {std::pair("--angle-limit", command.angle_limit.has_value()),
        std::pair("--ceiling", command.ceiling.has_value()),
        std::pair("--taut", !command.taut.empty())}) {
    if (is_there) {
      result.push_back(fmt::format("{}: is for cases alone, not for systems", option));
    }
  }
  if (command.digits && !command.certify) {
    result.push_back(fmt::format(
        "--digits {}: prints right digits of cases alone; of systems those that a solution in more "
        "digits has, too, are printed, in how many says --certify --digits",
        *command.digits));
  }
  if (command.certify && command.fast) {
    result.emplace_back("--fast: leaves out the solution in more digits that --certify asks for");
  }
  return result;
}

/// The cases and systems that `command` means, with its overrides; none, after complaining of every
/// one that is wrong, if one is.
CaseSelection wanted_cases(const SolveCommand& command) {
  CableSet taut;
  std::vector<std::string> broken;
  for (const std::int64_t index : command.taut) {
    if (index < 0 || index >= static_cast<std::int64_t>(max_cables)) {
      broken.push_back(fmt::format("--taut {}: cables count from 0 to {}", index, max_cables - 1));
    } else {
      taut.insert(static_cast<std::size_t>(index));
    }
  }
  CaseSelection selection = select_cases(command.cases, taut, Kinds::cases_and_systems);
  append(broken, selection.problems);
  complain(selection.notes);
  for (Case& found : selection.cases) {
    found.duration = command.until.value_or(found.duration);
    found.angle_limit = command.angle_limit ? command.angle_limit : found.angle_limit;
    found.ceiling = command.ceiling ? command.ceiling : found.ceiling;
    const bool several = selection.cases.size() > 1;
    for (const std::string& sentence : problems(found)) {
      broken.push_back(several ? printable(found.name) + ": " + sentence : sentence);
    }
  }
  const auto end_earlier = [&](auto& systems) {
    for (auto& found : systems) {
      found.duration = command.until.value_or(found.duration);
      for (const std::string& sentence : problems(found)) {
        broken.push_back(printable(found.name) + ": " + sentence);
      }
    }
  };
  end_earlier(selection.systems);
  end_earlier(selection.in_space);
  if (!selection.systems.empty() || !selection.in_space.empty()) {
    append(broken, for_cases_alone(command));
  } else if (command.fast && broken.empty()) {
    broken.push_back("--fast: is for systems alone; cases have bounds of their errors without it");
  }
  if (complain(broken)) {
    selection = {};
  }
  return selection;
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
  if (!command.json.empty() || !command.csv.empty() || !command.plots.empty()) {
    return fmt::format(
        "--digits {}: prints a summary, samples and events; --json, --csv and --plot need "
        "--certify",
        *command.digits);
  }
  return std::nullopt;
}

/// The files that `command` writes, by their options.
std::vector<OutputFile> outputs_of(const SolveCommand& command) {
  std::vector<OutputFile> result;
  for (const std::string& plot : command.plots) {
    result.push_back({"--plot", picture_of(plot).file, false});
  }
  if (!command.json.empty()) {
    result.push_back({"--json", command.json, true});
  }
  if (!command.csv.empty()) {
    result.push_back({"--csv", command.csv, false});
  }
  return result;
}

/// Everything that is wrong with what was asked, but for the cases.
std::vector<std::string> usage_problems(const SolveCommand& command) {
  std::vector<std::string> broken;
  for (const OutputFile& output : outputs_of(command)) {
    append(broken, missing_folder(output.option, output.file));
  }
  for (const std::string& plot : command.plots) {
    append(broken, picture_problems(plot));
  }
  for (const auto& [option, most] : {std::pair("--max-events", command.max_events),
                                     std::pair("--max-steps", command.max_steps)}) {
    if (most < 1) {
      broken.push_back(fmt::format("{} {}: must be at least 1", option, most));
    }
  }
  if (!command.csv.empty() && command.at.empty() && !command.every) {
    broken.push_back("--csv: writes samples; say at which times with --every STEP or --at TIMES");
  }
  append(broken, times_at(command.at).problems);
  if (const auto sentence = digits_usage_problem(command)) {
    broken.push_back(*sentence);
  }
  return broken;
}

/// The times at which to sample each case, or what is wrong with them.
SampleTimes times_for(const SolveCommand& command, double duration) {
  SampleTimes result = times_at(command.at);
  if (command.every) {
    SampleTimes regular = times_every(*command.every, duration);
    result.times.insert(result.times.end(), regular.times.begin(), regular.times.end());
    append(result.problems, regular.problems);
  }
  return result;
}

/// A motion that was given up is a failure, though what is told of it is right.
int exit_code(Ending ending) {
  const bool given_up = ending == Ending::event_limit || ending == Ending::step_limit ||
                        ending == Ending::no_progress;
  return given_up ? exit_failed : exit_done;
}

/// How `command` asks to solve.
SolveOptions options_of(const SolveCommand& command) {
  SolveOptions options;
  options.law = command.law;
  options.max_events = static_cast<std::size_t>(command.max_events);
  options.max_steps = static_cast<std::size_t>(command.max_steps);
  return options;
}

/// One case or system of `command` that is solved. Its JSON is written with that of the others.
struct Solved {
  int code = exit_done;
  std::string json;
};

/// Writes the pictures and the table of samples that are asked for. True if one of them, or the
/// JSON, goes to standard output.
bool write_files(const SolveCommand& command, const std::string& name,
                 const std::function<std::string(const Picture&)>& svg_of,
                 const std::function<std::string()>& csv) {
  bool to_output = command.json == "-" || command.csv == "-";
  for (const std::string& plot : command.plots) {
    const Picture picture = picture_of(plot);
    to_output = to_output || picture.file == "-";
    const std::string svg = svg_of(picture);
    write_output(file_for(picture.file, name), is_png(picture.file) ? png_of(svg) : svg);
  }
  if (!command.csv.empty()) {
    write_output(file_for(command.csv, name), csv());
  }
  return to_output;
}

/// The times to sample up to the end of `solution`; none, after complaining, if one is beyond it.
template <class Solution>
std::optional<std::vector<double>> times_within(const SolveCommand& command, double duration,
                                                const Solution& solution) {
  std::vector<double> times = times_for(command, duration).times;
  if (command.every) {  // it goes as far as the solution does
    std::erase_if(times, [&](double time) { return time > solution.end_time(); });
  }
  const std::vector<double> given = times_at(command.at).times;
  if (complain(sample_problems(solution.end_time(), solution.ending(), given))) {
    return std::nullopt;
  }
  return times;
}

/// The summary of a system first, and below it what was asked for.
template <int D>
void print_solution(const SolveCommand& command, const BasicCheckedMotion<D>& motion,
                    const std::vector<double>& times) {
  const auto& system = motion.system();
  const TerminalStyle style = output_style();
  const auto count = [](std::size_t number, const char* word) {
    return fmt::format("{} {}{}", number, word, number == 1 ? "" : "s");
  };
  const std::string bodies =
      system.bodies.size() == 1 ? "1 body" : fmt::format("{} bodies", system.bodies.size());
  fmt::print(
      "{}: {}, {}, {}\n\n{}{}{}{}", printable(system.name), bodies,
      count(system.cables.size(), "cable"), count(motion.solution().events().size(), "event"),
      wrapped_lines(system_text(motion), style.text),
      command.csv.empty() ? samples_text(motion, times, style) : "",
      contacts_text(motion, command.events, style), events_text(motion, command.events, style));
}

/// A picture of the motion of a system.
template <int D>
std::string picture_svg(const Picture& picture, const BasicCheckedMotion<D>& motion) {
  const BasicSystemMotion<D> drawn = {motion.system(), motion.solution(), motion.settling(),
                                      motion.is_checked() ? motion.horizon() : std::nullopt};
  return picture.motion ? plot_motion_svg(drawn) : plot_svg(drawn);
}

/// Solves one system of `command` and writes what is asked of it.
template <int D>
Solved solve_one(const SolveCommand& command, const BasicSystem<double, D>& system) {
  const SolveOptions options = options_of(command);
  const int digits = command.certify ? command.digits.value_or(default_digits) : digits_of_systems;
  const BasicCheckedMotion<D> motion(system, options, command.fast ? 0 : digits);
  const auto times = times_within(command, system.duration, motion.solution());
  if (!times) {
    return {exit_usage, ""};
  }
  const bool to_output = write_files(
      command, system.name, [&](const Picture& picture) { return picture_svg(picture, motion); },
      [&] { return samples_csv(motion, *times); });
  if (command.json.empty() && !to_output) {
    print_solution(command, motion, *times);
  }
  return {exit_code(motion.solution().ending()),
          command.json.empty() ? "" : solution_json(motion, options, *times)};
}

/// Solves one case of `command` and writes what is asked of it.
Solved solve_one(const SolveCommand& command, const Case& the_case, const std::string& argument) {
  const SolveOptions options = options_of(command);
  const Solution solution = solve(the_case, options);
  const auto times = times_within(command, the_case.duration, solution);
  if (!times) {
    return {exit_usage, ""};
  }
  Extras extras{{}, std::nullopt, *times};
  const int code = exit_code(solution.ending());
  if (command.digits && !command.certify) {
    fmt::print("{}", many_digits_text(the_case, options, solution,
                                      {*command.digits, command.decimal, command.events,
                                       literals_of(argument), extras.times, PatienceNote()},
                                      output_style()));
    return {code, ""};
  }
  extras.settling = settling(the_case, solution);
  if (command.certify) {
    extras.certificate =
        certify(the_case, options, solution, command.digits.value_or(default_digits));
  }
  const bool to_output = write_files(
      command, the_case.name,
      [&](const Picture& picture) {
        return picture.motion ? plot_motion_svg(the_case, solution) : plot_svg(the_case, solution);
      },
      [&] {
        const Uncertainty uncertainty(the_case, solution, options);
        return samples_csv(the_case, solution, uncertainty, extras.times);
      });
  if (command.json.empty()) {
    if (!to_output) {
      print_solution(command, the_case, options, solution, extras);
    }
    return {code, ""};
  }
  return {code, solution_json(the_case, options, solution, extras.settling, extras.times,
                              extras.certificate)};
}

/// Each case of a file is a name that `argument` gave; "" of a shipped one.
std::string argument_of(const SolveCommand& command, const Case& the_case) {
  for (const std::string& argument : command.cases) {
    const CaseSelection alone = select_cases({&argument, 1});
    if (alone.cases.size() == 1 && alone.cases.front().name == the_case.name) {
      return argument;
    }
  }
  return "";
}

int solve_command(const SolveCommand& command) {
  if (complain(usage_problems(command))) {
    return exit_usage;
  }
  const CaseSelection selection = wanted_cases(command);
  const std::vector<Case>& cases = selection.cases;
  std::vector<std::string> names;
  std::vector<std::string> broken;
  for (const Case& the_case : cases) {
    append(broken, times_for(command, the_case.duration).problems);
    names.push_back(the_case.name);
  }
  const auto name_all = [&](const auto& systems) {
    for (const auto& system : systems) {
      append(broken, times_for(command, system.duration).problems);
      names.push_back(system.name);
    }
  };
  name_all(selection.systems);
  name_all(selection.in_space);
  if (names.empty()) {
    return exit_usage;
  }
  append(broken, file_problems(outputs_of(command), names));
  if (complain(broken)) {
    return exit_usage;
  }
  const bool several = names.size() > 1;
  int code = exit_done;
  std::string all;  // the JSON of each, where it goes into one list
  auto name = names.begin();
  const auto take = [&](const std::function<Solved()>& solve_next) {
    if (name != names.begin() && command.json.empty() && command.csv != "-") {
      fmt::print("\n");
    }
    const Solved solved = solve_next();
    code = std::max(code, solved.code);
    if (!solved.json.empty()) {
      if (several && !names_case(command.json)) {
        all += (all.empty() ? "[\n" : ",\n") + solved.json.substr(0, solved.json.size() - 1);
      } else {
        write_output(file_for(command.json, *name), solved.json);
      }
    }
    ++name;
  };
  for (const Case& the_case : cases) {
    take([&] { return solve_one(command, the_case, argument_of(command, the_case)); });
  }
  const auto take_all = [&](const auto& systems) {
    for (const auto& system : systems) {
      try {
        take([&] { return solve_one(command, system); });
      } catch (const std::invalid_argument& error) {  // a law that does not take it
        complain({printable(system.name) + ": " + error.what()});
        return false;
      }
    }
    return true;
  };
  if (!take_all(selection.systems) || !take_all(selection.in_space)) {
    return exit_usage;
  }
  if (!all.empty()) {
    write_output(command.json, all + "\n]\n");
  }
  return code;
}

}  // namespace

void add_solve(CLI::App& app, int& code) {
  CLI::App* const command = app.add_subcommand(
      "solve", "The exact motion of cases: events, tensions, samples and pictures");
  const auto asked = std::make_shared<SolveCommand>();
  command->add_option("CASES", asked->cases, case_help)->required();
  command
      ->add_option("--until", asked->until,
                   "end at this time [s], before or after the case's own duration")
      ->option_text("SECONDS");
  command
      ->add_option("--at", asked->at,
                   "also print the state, gaps and tensions at these times [s]: 1,2.5,3 or 0:0.1:5")
      ->option_text("SECONDS")
      ->delimiter(',');
  command->add_option("--every", asked->every, "the same from 0 to the end, at this interval [s]");
  command->add_option("--angle-limit", asked->angle_limit, "end where |angle| reaches this [rad]");
  command->add_option("--ceiling", asked->ceiling,
                      "end where an attachment rises to this height [m]");
  command
      ->add_option("--taut", asked->taut,
                   "cables that start taut: 0,1; moves the start by as little as needed, at most "
                   "0.001 of a length")
      ->delimiter(',');
  add_law(*command, asked->law, "the law for impacts on several cables");
  command->add_flag(
      "--certify", asked->certify,
      "also solve with many digits, and say until when the doubles are right; of systems: "
      "with 50 instead of 30");
  command->add_option("--digits", asked->digits,
                      "print this many right digits, 1 to 100; with --certify: the digits to "
                      "compute with, 20 to 1000 (default: 50)");
  command->add_flag(
      "--decimal", asked->decimal,
      "with --digits: solve the decimals that the case is written in, not their doubles");
  add_target(*command, "--json", asked->json, "write everything as JSON");
  add_schema(*command, solution_schema_json);
  add_target(*command, "--csv", asked->csv,
             "write the samples of --every and --at, with two rows for each impact, as CSV");
  command
      ->add_option("--plot", asked->plots,
                   "write a picture (SVG, or PNG by its name): [KIND=]FILE, where KIND is path "
                   "(the default: where bodies go, in space from three sides) or motion "
                   "(position, gaps and tensions over time); KIND alone: to stdout")
      ->option_text("FILE")
      ->allow_extra_args(false);
  command->add_option("--max-events", asked->max_events,
                      fmt::format("stop after this many events (default: {})", asked->max_events));
  command->add_option(
      "--max-steps", asked->max_steps,
      fmt::format(
          "stop after this many steps of taut motion, and of springs within impacts (default: {})",
          asked->max_steps));
  command->add_flag("--fast", asked->fast,
                    "of systems: leave out the solution in 30 digits, which says how far the "
                    "doubles are right");
  command->add_flag("--events", asked->events,
                    "print all events, not the first 20, and the least and largest tensions");
  command->footer(
      "tautline solve breakwater/1910121100 --digits 12     twelve right digits\n"
      "tautline solve bouncing-ball --until 2.7             a few events\n"
      "tautline solve breakwater/1910121100 --plot p.svg    a picture of the motion\n"
      "tautline solve bouncing-ball --every 0.01 --csv b.csv    the motion over time\n"
      "tautline solve 'breakwater/19*' --json '{case}.json'     a file for each case");
  command->callback([asked, &code] { code = solve_command(*asked); });
}

}  // namespace tautline::bench
