// `tautline calibrate`: the setting of an engine that gives the restitution that is wanted at a
// cable, as the engine's own code.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "bench/base/listed.hpp"
#include "bench/base/process.hpp"
#include "bench/base/progress.hpp"
#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/base/text.hpp"
#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/engine_json.hpp"
#include "bench/run/registry.hpp"
#include "bench/tools/calibrate/calibrate.hpp"
#include "tautline/elasticity.hpp"

namespace tautline::bench {
namespace {

/// What `tautline calibrate` was asked.
struct CalibrateCommand {
  std::string engine;
  std::string model;
  double restitution = 0.0;
  std::vector<std::string> fixed;  // "NAME=VALUE"
  std::string speeds = "0.05..2";  // [m/s]
  double step = 1e-3;              // [s]
  double tolerance = 0.01;         // [-]
  std::optional<int> settings;     // none: as many as the parameters need
  double time_limit = 60.0;        // [s]
  std::string json;
};

/// The model `name` of an engine; none if it does not say that it has it.
std::optional<Model> model_of(const RegisteredEngine& engine, const std::string& name) {
  for (const Model& model : engine.info->models) {
    if (model.name == name) {
      return model;
    }
  }
  return std::nullopt;
}

/// The models of an engine that can be calibrated, for a sentence.
std::string tunable_models(const EngineInfo& info) {
  std::vector<std::string> names;
  for (const Model& model : info.models) {
    if (!model.parameters.empty()) {
      names.push_back(model.name);
    }
  }
  return names.empty() ? "no model of " + info.name + " has one"
                       : "there are some in " + joined(names, "and");
}

/// "NAME=VALUE" in two; none if it is not that.
std::optional<std::pair<std::string, double>> fixed_value(const std::string& text) {
  const std::size_t sign = text.find('=');
  double value = 0.0;
  const bool read = sign != text.npos && CLI::detail::lexical_cast(text.substr(sign + 1), value);
  return read && std::isfinite(value) ? std::optional(std::pair(text.substr(0, sign), value))
                                      : std::nullopt;
}

/// What is wrong with the values that are fixed, and with searching the rest of the parameters.
std::vector<std::string> parameter_problems(const Model& model, const EngineInfo& info,
                                            const std::vector<std::string>& fixed) {
  if (model.parameters.empty()) {
    return {fmt::format("model {} has no parameter to calibrate; {}", model.name,
                        tunable_models(info))};
  }
  const std::vector<std::string> names = listed(model.parameters, &Parameter::name);
  std::vector<std::string> broken;
  for (const std::string& text : fixed) {
    const auto one = fixed_value(text);
    if (!one) {
      broken.push_back("--fix " + printable(text) + " is not NAME=VALUE");
    } else if (std::find(names.begin(), names.end(), one->first) == names.end()) {
      broken.push_back(fmt::format("--fix {}: model {} has no such parameter, but {}",
                                   printable(one->first), model.name, joined(names, "and")));
    }
  }
  return broken;
}

std::vector<std::string> calibration_problems(const CalibrateCommand& command) {
  std::vector<std::string> broken = missing_folder("--json", command.json);
  if (!(command.restitution >= 0.0 && command.restitution <= 1.0)) {
    broken.push_back(fmt::format("--restitution {:g} is outside [0, 1]", command.restitution));
  }
  if (!positive_range(command.speeds)) {
    broken.push_back("--speeds " + printable(command.speeds) +
                     " is no range of speeds above 0 m/s, such as 0.05..2");
  }
  for (const auto& [name, value] :
       {std::pair("--step", command.step), std::pair("--tolerance", command.tolerance),
        std::pair("--time-limit", command.time_limit)}) {
    if (!(value > 0.0 && std::isfinite(value))) {
      broken.push_back(fmt::format("{} {:g} is not above 0", name, value));
    }
  }
  if (command.settings && *command.settings < 1) {
    broken.push_back(fmt::format("--settings {} is not above 0", *command.settings));
  }
  return broken;
}

/// What was asked, once it is known to be sound.
CalibrationRequest request_of(const CalibrateCommand& command, const RegisteredEngine& engine,
                              const Model& model) {
  const auto [slowest, fastest] = positive_range(command.speeds).value();
  CalibrationRequest request{.plugin = engine.plugin,
                             .model = model,
                             .searched = {},
                             .fixed = {},
                             .restitution = command.restitution,
                             .slowest = slowest,
                             .fastest = fastest,
                             .step = command.step,
                             .tolerance = command.tolerance,
                             .settings = 1,
                             .limits = {.time = command.time_limit}};
  for (const std::string& text : command.fixed) {
    request.fixed.insert(fixed_value(text).value());
  }
  for (const Parameter& parameter : model.parameters) {
    if (!request.fixed.contains(parameter.name)) {
      request.searched.push_back(parameter);
    }
  }
  request.settings = command.settings.value_or(most_settings(request.searched.size()));
  return request;
}

/// Rows of bodies, columns of speeds: what each rebounds with.
std::string held_out_table(const Calibration& found) {
  std::vector<std::string> headings = {"arm [m]", "I [kg m²]", "by spin"};
  std::map<std::vector<double>, std::vector<Cell>> rows;  // by body
  const Strike& first = found.held_out.front().strike;
  for (const auto& [strike, restitution] : found.held_out) {
    if (strike.arm == first.arm) {  // the same number, not a computed one
      const bool is_first = strike.speed == first.speed;
      headings.push_back(fmt::format("{}{:.2g}", is_first ? "e at " : "", strike.speed));
    }
    std::vector<Cell>& row = rows[{strike.arm, strike.inertia, strike.spin_part}];
    if (row.empty()) {
      row = {fmt::format("{:g}", strike.arm), fmt::format("{:g}", strike.inertia),
             fmt::format("{:g}", strike.spin_part)};
    }
    row.push_back(number_cell(restitution, fixed(4)));
  }
  headings.back() += " m/s";
  Table table(headings, 0);
  for (auto& [body, row] : rows) {
    table.add(std::move(row));
  }
  return table.plain(output_style());
}

/// Which e the held-out strikes have, and how well they were hit.
std::string closing_words(const CalibrationRequest& request, const Calibration& found) {
  Reach held_out;
  for (const HeldOut& one : found.held_out) {
    held_out.include(one.restitution);
  }
  std::string words = fmt::format(
      "These numbers give e = {:.3g} to {:.3g}: the largest error is {:.2g}, the mean one {:.2g}; ",
      held_out.lowest, held_out.highest, found.worst, found.mean);
  words += found.evaluations == 1 ? "one setting tried."
                                  : fmt::format("{} settings tried.", found.evaluations);
  if (found.interrupted) {
    words += " The search was interrupted: it is the best so far.";
  }
  for (const std::string& sentence : found.why) {
    words += fmt::format(" Not within {:g}: {}.", request.tolerance, sentence);
  }
  return words;
}

/// The law of a cable that is a spring and a damper, and the restitution of its closed form.
std::string law_words(const SoftRow& law) {
  const double ratio = damping_ratio_of(law);
  const std::string words = fmt::format(
      "The cable is a spring and a damper: on a mass m it has k = {:.6g} m [N/m] and c = {:.6g} m "
      "[N s/m], a damping ratio of {:.4g}. In short steps and without a load that is e = {:.4g}.",
      law.stiffness, law.damping, ratio, restitution_of(ratio));
  return law.load > 0.0 ? fmt::format("{} It takes over {:g} of any load.", words, law.load)
                        : words;
}

void print_calibration(const RegisteredEngine& engine, const CalibrationRequest& request,
                       const Calibration& found) {
  const std::size_t width = output_style().text;
  fmt::print("{}\n", wrapped(fmt::format("{} {}, {}: e = {:g} at {:g} to {:g} m/s, "
                                         "step {:g} s",
                                         engine.info->name, engine.info->version,
                                         request.model.name, request.restitution, request.slowest,
                                         request.fastest, request.step),
                             width));
  for (const auto& [name, value] : found.parameters) {
    fmt::print("  {} = {:.6g}{}\n", name, value, request.fixed.contains(name) ? ", fixed" : "");
  }
  fmt::print("\n{}\n\n", found.code);
  if (found.law) {
    fmt::print("{}\n", wrapped(law_words(*found.law), width));
  }
  fmt::print("{}\n{}\n",
             wrapped("On strikes that the search did not see; by spin: the part of the closing "
                     "speed that the body's spin brings",
                     width),
             held_out_table(found));
  fmt::print("{}", wrapped(closing_words(request, found), width));
}

int calibrate_command(const CalibrateCommand& command) {
  const EngineChoice choice = choose_engines({command.engine});
  std::vector<std::string> broken = calibration_problems(command);
  append(broken, choice.problems);
  if (choice.problems.empty() && choice.engines.front().info) {
    append(broken, unknown_models(choice.engines, {command.model}));
  }
  if (complain(broken)) {
    return exit_usage;
  }
  const RegisteredEngine& engine = choice.engines.front();
  if (!engine.info) {
    complain({fmt::format("engine {}: {}", engine.name, printable(engine.failure))});
    return exit_failed;
  }
  const Model model = model_of(engine, command.model).value();
  if (complain(parameter_problems(model, *engine.info, command.fixed))) {
    return exit_usage;
  }
  const CalibrationRequest request = request_of(command, engine, model);
  catch_interruption();
  const auto most = static_cast<std::size_t>(request.settings);
  Progress progress(static_cast<double>(most), most, "settings");
  const Calibration found = calibrate(request, [&progress] { progress.ended(1.0); });
  progress.finish();
  if (!found.failure.empty()) {
    complain({printable(found.failure, 1000)});
    return exit_failed;
  }
  if (command.json.empty()) {
    print_calibration(engine, request, found);
  } else {
    write_output(command.json, calibration_json(engine, request, found));
  }
  return found.reached(command.tolerance) && !found.interrupted ? exit_done : exit_failed;
}

}  // namespace

void add_calibrate(CLI::App& app, int& code) {
  CLI::App* const command =
      app.add_subcommand("calibrate", "The setting of an engine that gives a wanted restitution");
  const auto asked = std::make_shared<CalibrateCommand>();
  command
      ->add_option("ENGINE", asked->engine,
                   "an engine's name, or the path of a plug-in or an engine.toml")
      ->required();
  command->add_option("--model", asked->model, "one of its models that has parameters")
      ->option_text("MODEL")
      ->required();
  command->add_option("--restitution", asked->restitution, "the restitution to reach [-]")
      ->required();
  command->add_option("--fix", asked->fixed, "leave these parameters at these values")
      ->option_text("NAME=VALUE")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--speeds", asked->speeds, "the range of closing speeds [m/s]")
      ->option_text("FROM..TO")
      ->capture_default_str();
  command->add_option("--step", asked->step, "the engine's step [s]")
      ->option_text("SECONDS")
      ->capture_default_str();
  command
      ->add_option("--tolerance", asked->tolerance,
                   "the largest error allowed on strikes that the search did not use [-]")
      ->capture_default_str();
  command->add_option(
      "--settings", asked->settings,
      "try at most this many settings (default: 64 for each parameter that is searched)");
  command->add_option("--time-limit", asked->time_limit, "give up a setting after this long [s]")
      ->option_text("SECONDS")
      ->capture_default_str();
  add_target(*command, "--json", asked->json, "write the result as JSON");
  add_schema(*command, calibration_schema_json);
  command->footer("tautline calibrate mujoco --model tendon-limit --restitution 0.7 --step 1e-4");
  command->callback([asked, &code] { code = calibrate_command(*asked); });
}

}  // namespace tautline::bench
