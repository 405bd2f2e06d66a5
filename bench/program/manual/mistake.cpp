#include "bench/program/manual/mistake.hpp"

#include <CLI/CLI.hpp>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// `near`, or where the right ones stand.
std::string or_help(const std::string& near, const std::string& command) {
  return near.empty() ? "; `tautline" + command + " --help` lists them" : near;
}

/// The word that no one expected, as it was typed; `--step=1` is `--step`.
std::string name_in(const std::string& word) {
  return word.starts_with('-') ? word.substr(0, word.find('=')) : word;
}

std::string unexpected_word(const std::string& word, const CLI::App& command) {
  const std::string name = name_in(word);
  if (!name.starts_with('-')) {
    return command.get_name() + " takes no further word: " + printable(name);
  }
  return command.get_name() + " has no option " + printable(name) +
         or_help(suggestion(name, option_names(command_of(command).options)),
                 " " + command.get_name());
}

}  // namespace

std::string unknown_command(const std::string& word, const Outline& outline) {
  const std::vector<std::string> names = listed(outline.commands, &Command::name);
  return "unknown command " + printable(word) + or_help(suggestion(word, names), "");
}

std::string mistake(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (const auto words = app.remaining(); !words.empty()) {
    const std::string name = name_in(words.front());
    return name.starts_with('-')
               ? "there is no option " + printable(name) +
                     or_help(suggestion(name, option_names(outline_of(app).options)), "")
               : unknown_command(name, outline_of(app));
  }
  if (parsed.empty()) {
    return error.what();
  }
  const CLI::App& command = *parsed.back();
  if (const auto words = command.remaining(); !words.empty()) {
    return unexpected_word(words.front(), command);
  }
  const std::string sentence = command.get_name() + ": " + error.what();
  return error.get_name() == "RequiredError"
             ? sentence + "; `tautline " + command.get_name() + " --help` says more"
             : sentence;
}

}  // namespace tautline::bench
