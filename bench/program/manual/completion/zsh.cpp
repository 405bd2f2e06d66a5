#include <fmt/format.h>

#include "bench/program/manual/completion/offer.hpp"
#include "bench/program/manual/manual.hpp"

namespace tautline::bench {
namespace {

std::string zsh_offer(const Argument& argument) {
  switch (offer_of(argument)) {
    case Offer::file:
      return "_files";
    case Offer::folder:
      return "_files -/";
    case Offer::one_case:
      return "_tautline_case";
    case Offer::engine:
      return "_tautline_engine";
    case Offer::model:
      return "_tautline_model";
    case Offer::command:
      return "($command_names)";
    case Offer::choices:
      return "(" + spaced(argument.choices) + ")";
    case Offer::nothing:
      break;
  }
  return " ";
}

/// A meaning in the brackets and between the colons of an _arguments spec.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    result +=
        std::string(letter == '[' || letter == ']' || letter == ':' || letter == '\\' ? "\\" : "") +
        letter;
  }
  return result;
}

std::string zsh_command(const Command& command) {
  std::string specs;
  for (const Argument& option : command.options) {
    for (const std::string& name : option.names) {
      std::string spec = name + "[" + zsh_text(option.meaning) + "]";
      if (!option.value.empty()) {
        spec += ":" + zsh_text(option.value) + ":" + zsh_offer(option);
      }
      specs += " \\\n        " + in_quotes(spec);
    }
  }
  for (const Argument& word : command.words) {
    specs += " \\\n        " + in_quotes((word.repeats ? "*:" : ":") +
                                         zsh_text(word.names.front()) + ":" + zsh_offer(word));
  }
  return fmt::format("      {})\n        _arguments{} ;;\n", command.name, specs);
}

}  // namespace

std::string zsh_completion(const Outline& outline) {
  std::string commands;
  std::string cases;
  for (const Command& command : outline.commands) {
    commands += "    " + in_quotes(command.name + ":" + zsh_text(command.summary)) + "\n";
    cases += zsh_command(command);
  }
  return fmt::format(
      R"zsh(#compdef tautline
# zsh completion of tautline, made by `tautline help --completion zsh`
{functions}
_tautline_case() {{
  _alternative 'cases:case:({cases})' 'files:case file:_files -g "*.toml"'
}}
_tautline_engine() {{
  local -a engines=(${{(f)"$(_tautline_engines)"}})
  _alternative 'engines:engine:_sequence compadd -a engines' 'files:plug-in:_files -g "*.so"'
}}
_tautline_model() {{
  local -a models=(${{(f)"$(_tautline_models)"}})
  _sequence compadd -a models
}}
_tautline() {{
  local context state line
  local command_names='{command_names}'
  local -a commands=(
{commands}  )
  _arguments -C '(- *)--help[help]' '(- *)--version[the version]' '1:command:->command' '*::word:->words'
  case $state in
    command) _describe command commands ;;
    words)
      case $words[1] in
{per_command}      esac ;;
  esac
}}
_tautline "$@"
)zsh",
      fmt::arg("functions", shell_functions), fmt::arg("cases", case_names()),
      fmt::arg("commands", commands), fmt::arg("command_names", command_names(outline)),
      fmt::arg("per_command", cases));
}

}  // namespace tautline::bench
