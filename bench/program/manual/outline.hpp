#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tautline::bench {

// The program's command line as data. Its help, manual pages and shell completion are all drawn
// from this, and this from the options themselves: none of them can miss one.

/// An option, or a word that is known by its place.
struct Argument {
  std::vector<std::string> names;    // "-h", "--help"; one without dashes is known by its place
  std::string value;                 // what stands for its value, as "FILE"; "" of a flag
  std::string meaning;               //
  std::string otherwise;             // its value where none is given, or ""
  std::vector<std::string> choices;  // all values that it may have; empty: any
  bool required = false;
  bool repeats = false;  // takes several values

  [[nodiscard]] bool is_word() const { return !names.front().starts_with('-'); }
};

/// A command of the program.
struct Command {
  std::string name;
  std::string summary;
  std::vector<Argument> words;    // in their places
  std::vector<Argument> options;  //
  std::string examples;           // a line each: a command, and after two blanks what it does
};

/// The whole command line.
struct Outline {
  std::string summary;
  std::string examples;
  std::vector<Argument> options;  // without a command
  std::vector<Command> commands;  //
};

[[nodiscard]] Outline outline_of(const CLI::App& app);

/// One command alone: `app` is a subcommand.
[[nodiscard]] Command command_of(const CLI::App& app);

/// All names of `options`.
[[nodiscard]] std::vector<std::string> option_names(const std::vector<Argument>& options);

/// "--engines ENGINES": the names of an argument, and its value.
[[nodiscard]] std::string spelling(const Argument& argument);

/// "[CASES...]", "CASE": the words of a command.
[[nodiscard]] std::string words_of(const Command& command);

/// What an argument means, with what it is where none is given.
[[nodiscard]] std::string whole_meaning(const Argument& argument);

}  // namespace tautline::bench
