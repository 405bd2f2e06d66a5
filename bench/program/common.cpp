#include "bench/program/common.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <system_error>

#include "bench/base/atomic_file.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

std::map<std::string, ImpactLaw> law_names() {
  std::map<std::string, ImpactLaw> names;
  for (const ImpactLaw law : impact_laws) {
    names.emplace(to_string(law), law);
  }
  return names;
}

}  // namespace

bool complain(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) {
    // without exceptions: there may be nowhere left to complain to
    static_cast<void>(std::fputs(("tautline: " + sentence + "\n").c_str(), stderr));
  }
  return !sentences.empty();
}

void append(std::vector<std::string>& sentences, const std::vector<std::string>& more) {
  sentences.insert(sentences.end(), more.begin(), more.end());
}

std::vector<std::string> missing_folder(const std::string& option, const std::string& file,
                                        const std::filesystem::path& made) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code error;
  if (file == "-" || folder.empty() || std::filesystem::is_directory(folder, error)) {
    return {};
  }
  const auto normal = [](const std::filesystem::path& path) {
    return (std::filesystem::absolute(path) / "").lexically_normal();
  };
  if (!made.empty() && normal(folder) == normal(made)) {
    return {};
  }
  return {fmt::format("{} {}: there is no folder {}; make it, or name a file in one that is there",
                      option, printable(file), printable(folder.string()))};
}

void write_output(const std::string& target, const std::string& text) {
  if (target != "-") {
    const std::filesystem::path folder = std::filesystem::path(target).parent_path();
    std::error_code error;
    if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
      throw FileError("cannot write " + printable(target) + ": there is no folder " +
                      printable(folder.string()));
    }
    write_file(target, text);
    return;
  }
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw FileError("cannot write to standard output");
  }
}

std::optional<std::pair<double, double>> positive_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == text.npos) {
    return std::nullopt;
  }
  double low = 0.0;
  double high = 0.0;
  const bool read = CLI::detail::lexical_cast(text.substr(0, dots), low) &&
                    CLI::detail::lexical_cast(text.substr(dots + 2), high);
  return read && low > 0.0 && high > low && std::isfinite(high)
             ? std::optional(std::pair(low, high))
             : std::nullopt;
}

std::optional<Case> one_case(const std::string& argument, CableSet taut) {
  CaseSelection selection = select_cases({&argument, 1}, taut);
  if (selection.cases.size() > 1) {
    selection.problems.push_back(fmt::format("{} means {} cases; this command takes one",
                                             printable(argument), selection.cases.size()));
  }
  if (complain(selection.problems)) {
    return std::nullopt;
  }
  complain(selection.notes);
  return std::move(selection.cases.front());
}

std::vector<BenchCase> bench_cases(CaseSelection selection, ImpactLaw law,
                                   std::vector<std::string>& problems) {
  std::vector<BenchCase> result;
  std::move(selection.cases.begin(), selection.cases.end(), std::back_inserter(result));
  const std::size_t first = result.size();
  for (const System& system : selection.systems) {
    result.emplace_back(in_space(system));
  }
  std::move(selection.in_space.begin(), selection.in_space.end(), std::back_inserter(result));
  for (std::size_t index = first; index < result.size(); ++index) {
    const auto& system = std::get<SpatialSystem>(result[index]);
    if (law == ImpactLaw::energetic && system.cables.size() > 3) {
      problems.push_back(
          fmt::format("--law energetic: {} has {} cables; of a system this law takes 3 at most",
                      printable(system.name), system.cables.size()));
    }
  }
  return result;
}

void add_law(CLI::App& command, ImpactLaw& law, const std::string& help) {
  command
      .add_option_function<std::string>(
          "--law", [&law](const std::string& name) { law = law_names().at(name); }, help)
      ->option_text("LAW")
      ->check(CLI::IsMember(law_names()))
      ->default_str("simultaneous");
}

CLI::Option* add_target(CLI::App& command, const std::string& option, std::string& file,
                        const std::string& help) {
  return command.add_option(option, file, help + " to this file, or to stdout: -")
      ->option_text("FILE")
      ->check([](const std::string& name) {
        return std::string(name.empty() ? "must be the name of a file, or -" : "");
      });
}

void add_schema(CLI::App& command, std::string (*schema)()) {
  command.add_flag_callback(
      "--schema",
      [schema] {
        fmt::print("{}", schema());
        throw CLI::Success();  // as --help ends
      },
      "print the JSON schema of what it writes, and end");
}

}  // namespace tautline::bench
