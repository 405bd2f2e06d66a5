#include "bench/program/manual/manual.hpp"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "bench/base/table.hpp"

namespace tautline::bench {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

/// A longer name has a line of its own before its meaning [columns].
constexpr std::size_t longest_name = 24;

/// Names with their meanings beside them, which begin in one column.
std::string beside(const Rows& rows, std::size_t width) {
  std::size_t longest = 0;
  for (const auto& [name, meaning] : rows) {
    longest = std::max(longest, name.size() <= longest_name ? name.size() : 0);
  }
  const std::size_t start = 2 + std::max<std::size_t>(longest, 8) + 2;
  std::string result;
  for (const auto& [name, meaning] : rows) {
    std::istringstream lines(wrapped(meaning, width - start));
    result += "  " + name;
    std::size_t column = 2 + name.size();
    for (std::string line; std::getline(lines, line);) {
      const bool fits = column + 2 <= start;
      result += (fits ? std::string(start - column, ' ') : "\n" + std::string(start, ' ')) + line;
      column = width;
    }
    result += "\n";
  }
  return result;
}

std::string section(const std::string& title, const Rows& rows, std::size_t width) {
  return rows.empty() ? "" : "\n" + title + ":\n" + beside(rows, width);
}

Rows rows_of(const std::vector<Argument>& arguments) {
  Rows rows;
  for (const Argument& argument : arguments) {
    rows.emplace_back(spelling(argument), whole_meaning(argument));
  }
  return rows;
}

std::string example_lines(const std::string& examples, std::size_t width) {
  std::string result;
  std::istringstream lines(examples);
  for (std::string line; std::getline(lines, line);) {
    result += wrapped_lines("  " + line, width, 4);
  }
  return result.empty() ? "" : "\nexamples:\n" + result;
}

}  // namespace

std::string help_text(const Outline& outline, std::size_t width) {
  Rows commands;
  for (const Command& command : outline.commands) {
    commands.emplace_back(command.name, command.summary);
  }
  return wrapped(outline.summary, width) + "\nusage: tautline COMMAND [OPTIONS]\n" +
         section("commands", commands, width) + example_lines(outline.examples, width) + "\n" +
         wrapped("Run `tautline COMMAND --help` for details, `tautline --version` for the version.",
                 width);
}

std::string help_text(const Command& command, std::size_t width) {
  const std::string words = words_of(command);
  return wrapped(command.summary + ".", width) + "\nusage: tautline " + command.name +
         (words.empty() ? "" : " " + words) + " [OPTIONS]\n" +
         (command.words.empty() ? "" : "\n" + beside(rows_of(command.words), width)) +
         section("options", rows_of(command.options), width) +
         example_lines(command.examples, width);
}

}  // namespace tautline::bench
