#pragma once

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace tautline::bench {

// The program's command line as data. Its help, manual pages and shell completion are all drawn
// from this, and this from the options themselves: none of them can miss one.

/// An option, or a word that is known by its place.
struct Argument {
  std::vector<std::string> names;    // "-h", "--help"; one without dashes is known by its place
  std::string value;                 // name of its value, as "FILE"; "" of a flag
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

/// What the program says without a command: what it is, its commands, and where to begin. In lines
/// of at most `width` columns.
[[nodiscard]] std::string help_text(const Outline& outline, std::size_t width);

/// The help of one command.
[[nodiscard]] std::string help_text(const Command& command, std::size_t width);

/// tautline(1): the program and its commands, as roff for `man`.
[[nodiscard]] std::string man_page(const Outline& outline);

/// tautline-solve(1) and the like: one of its commands.
[[nodiscard]] std::string man_page(const Outline& outline, const Command& command);

/// What may stand at the end of a command line, for a shell: `words` are those after `tautline`,
/// and the last of them, which may be "", is being typed. A line each: the word, a tab and its
/// meaning. A line ":files", a tab and a pattern asks the shell for its files, a line ":folders"
/// for folders.
[[nodiscard]] std::string completions(const Outline& outline,
                                      const std::vector<std::string>& words);

/// The script with which a shell asks for them, by the name of the shell.
[[nodiscard]] const std::map<std::string, std::string>& completion_scripts();

/// What is wrong with a command line that `app` could not parse, in one sentence: with the name
/// that was likely meant, or with where the right ones stand.
[[nodiscard]] std::string mistake(const CLI::App& app, const CLI::ParseError& error);

/// That `word` is no command, likewise.
[[nodiscard]] std::string unknown_command(const std::string& word, const Outline& outline);

}  // namespace tautline::bench
