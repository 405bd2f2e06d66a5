// The command line as data, and what is wrong with one that was typed.

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/program/manual.hpp"

namespace tautline::bench {
namespace {

std::string value_of(const CLI::Option& option) {
  const bool is_flag = option.get_items_expected_max() == 0;
  if (is_flag) {
    return "";
  }
  if (!option.get_option_text().empty()) {
    return option.get_option_text();
  }
  return option.get_type_name().starts_with("TEXT") ? "TEXT" : "NUMBER";
}

/// The values between the braces of "TEXT:{a,b}": CLI11 tells them in no other way.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) {
    return {};
  }
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

Argument argument_of(const CLI::Option& option) {
  Argument argument;
  for (const std::string& name : option.get_snames()) {
    argument.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    argument.names.push_back("--" + name);
  }
  if (argument.names.empty()) {
    argument.names.push_back(option.get_name(true));
  }
  argument.value = argument.is_word() ? "" : value_of(option);
  argument.meaning = option.get_description();
  argument.otherwise = option.get_default_str();
  argument.choices = choices_of(option);
  argument.required = option.get_required();
  argument.repeats = option.get_items_expected_max() > 1;
  return argument;
}

std::vector<Argument> arguments_of(const CLI::App& app, bool words) {
  std::vector<Argument> result;
  for (const CLI::Option* option : app.get_options()) {
    Argument argument = argument_of(*option);
    if (argument.is_word() == words) {
      result.push_back(std::move(argument));
    }
  }
  return result;
}

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

Command command_of(const CLI::App& app) {
  return {app.get_name(), app.get_description(), arguments_of(app, true), arguments_of(app, false),
          app.get_footer()};
}

Outline outline_of(const CLI::App& app) {
  Outline outline{app.get_description(), app.get_footer(), arguments_of(app, false), {}};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    outline.commands.push_back(command_of(*command));
  }
  return outline;
}

std::vector<std::string> option_names(const std::vector<Argument>& options) {
  std::vector<std::string> names;
  for (const Argument& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::string spelling(const Argument& argument) {
  return fmt::format("{}", fmt::join(argument.names, ", ")) +
         (argument.value.empty() ? "" : " " + argument.value);
}

std::string words_of(const Command& command) {
  std::string result;
  for (const Argument& word : command.words) {
    const std::string name = word.names.front() + (word.repeats ? "..." : "");
    result += (result.empty() ? "" : " ") + (word.required ? name : "[" + name + "]");
  }
  return result;
}

std::string whole_meaning(const Argument& argument) {
  std::string result = argument.meaning;
  for (std::size_t place = 0; place < argument.choices.size(); ++place) {
    result += (place == 0 ? ": " : ", ") + argument.choices[place];
  }
  if (argument.required && !argument.is_word()) {
    result += " (required)";
  }
  return argument.otherwise.empty() ? result : result + " (default: " + argument.otherwise + ")";
}

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
