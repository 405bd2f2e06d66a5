#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "bench/program/commands.hpp"
#include "bench/program/common.hpp"
#include "bench/program/patience.hpp"
#include "bench/vectors/solve_vector.hpp"
#include "bench/vectors/vector_output.hpp"

namespace tautline::bench {
namespace {

/// What `tautline vector` was asked.
struct VectorCommand {
  std::string the_case;
  std::optional<double> until;  // [s], instead of the case's duration
  VectorOptions options;
  std::string json;
  std::string text;
};

/// A vector has that many samples at most: more say nothing more.
constexpr int most_samples = 10'000;

std::vector<std::string> vector_usage_problems(const VectorCommand& command) {
  std::vector<std::string> broken;
  append(broken, missing_folder("--json", command.json));
  append(broken, missing_folder("--text", command.text));
  if (command.json == "-" && command.text == "-") {
    broken.emplace_back("--json -, --text -: only one of them can go to stdout");
  }
  const VectorOptions& options = command.options;
  if (options.samples < 1 || options.samples > most_samples) {
    broken.push_back(fmt::format("--samples {}: must be 1 to {}", options.samples, most_samples));
  }
  if (!(options.slowest > 0.0) || options.slowest > largest_number) {
    broken.push_back(fmt::format("--slowest {}: must be a speed above 0, in m/s", options.slowest));
  }
  return broken;
}

int vector_command(const VectorCommand& command) {
  std::vector<std::string> broken = vector_usage_problems(command);
  if (complain(broken)) {
    return exit_usage;
  }
  std::optional<Case> the_case = one_case(command.the_case);
  if (!the_case) {
    return exit_usage;
  }
  the_case->duration = command.until.value_or(the_case->duration);
  if (complain(problems(*the_case))) {
    return exit_usage;
  }
  VectorOptions options = command.options;
  options.on_attempt = PatienceNote();
  const VectorReading reading = vector_of(*the_case, options);
  if (!reading.vector) {
    complain({reading.problem});
    return exit_failed;
  }
  if (!command.text.empty()) {
    write_output(command.text, vector_text(*reading.vector));
  }
  if (!command.json.empty() || command.text.empty()) {
    write_output(command.json.empty() ? "-" : command.json, vector_json(*reading.vector));
  }
  return exit_done;
}

}  // namespace

void add_vector(CLI::App& app, int& code) {
  CLI::App* const command = app.add_subcommand(
      "vector", "An exact motion as a file, by which an engine can check itself");
  const auto asked = std::make_shared<VectorCommand>();
  command->add_option("CASE", asked->the_case, case_help)->required();
  command
      ->add_option(
          "--until", asked->until,
          "end at this time [s], before or after the case's own duration; a vector ends at "
          "the latest when its last cables become taut")
      ->option_text("SECONDS");
  add_law(*command, asked->options.law, "the law for impacts on several cables");
  command
      ->add_option("--samples", asked->options.samples,
                   "number of samples, about, at equal intervals")
      ->option_text("COUNT")
      ->capture_default_str();
  command
      ->add_option("--slowest", asked->options.slowest,
                   "leave out impacts that close slower than this [m/s]")
      ->option_text("SPEED")
      ->capture_default_str();
  add_target(*command, "--json", asked->json, "write the vector as JSON");
  add_target(*command, "--text", asked->text,
             "write it as lines of words and numbers, for readers without a library for JSON");
  add_schema(*command, vector_schema_json);
  command->footer(
      "tautline vector bouncing-ball --json ball.json --text ball.txt\n"
      "tautline vector level-beam --law poisson --until 0.6");
  command->callback([asked, &code] { code = vector_command(*asked); });
}

}  // namespace tautline::bench
