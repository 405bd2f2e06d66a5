#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/program/manual/completion/offer.hpp"
#include "bench/program/manual/manual.hpp"

namespace tautline::bench {
namespace {

std::string bash_offer(const Argument& argument) {
  switch (offer_of(argument)) {
    case Offer::file:
      return "_tautline_files -f";
    case Offer::folder:
      return "_tautline_files -d";
    case Offer::one_case:
      return "_tautline_files -f; _tautline_words \"$_tautline_cases\"";
    case Offer::engine:
      return "_tautline_files -f; _tautline_words \"$(_tautline_engines)\"";
    case Offer::model:
      return "_tautline_words \"$(_tautline_models)\"";
    case Offer::command:
      return "_tautline_words \"$_tautline_commands\"";
    case Offer::choices:
      return "_tautline_words " + in_quotes(spaced(argument.choices));
    case Offer::nothing:
      break;
  }
  return ":";
}

std::string bash_command(const Command& command) {
  std::string values;
  for (const Argument& option : command.options) {
    if (!option.value.empty()) {
      values += fmt::format("        {}) {}; return ;;\n", fmt::join(option.names, "|"),
                            bash_offer(option));
    }
  }
  const std::string word = command.words.empty() ? ":" : bash_offer(command.words.front());
  return fmt::format(
      "    {})\n{}{}      case \"$cur\" in\n        -*) _tautline_words {} ;;\n        *) {} ;;\n"
      "      esac ;;\n",
      command.name, values.empty() ? "" : "      case \"$prev\" in\n",
      values.empty() ? "" : values + "      esac\n",
      in_quotes(spaced(option_names(command.options))), word);
}

}  // namespace

std::string bash_completion(const Outline& outline) {
  std::string cases;
  for (const Command& command : outline.commands) {
    cases += bash_command(command);
  }
  return fmt::format(
      R"(# bash completion of tautline, made by `tautline help --completion bash`
_tautline_commands='{commands}'
_tautline_cases='{cases}'
{functions}
# adds those of the words that begin as the last item of a list with commas does
_tautline_words() {{
  local before=""
  [[ $cur == *,* ]] && before="${{cur%,*}},"
  COMPREPLY+=($(compgen -P "$before" -W "$1" -- "${{cur##*,}}"))
}}
_tautline_files() {{
  compopt -o filenames 2>/dev/null
  COMPREPLY+=($(compgen "$1" -- "$cur"))
}}
_tautline() {{
  local cur="${{COMP_WORDS[COMP_CWORD]}}" prev="${{COMP_WORDS[COMP_CWORD-1]}}" command="" word
  COMPREPLY=()
  if [[ $cur == "=" ]]; then
    cur=""
  elif [[ $prev == "=" ]]; then
    prev="${{COMP_WORDS[COMP_CWORD-2]}}"
  fi
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    [[ $word == -* ]] || {{ command="$word"; break; }}
  done
  case "$command" in
    "")
      case "$cur" in
        -*) _tautline_words '{options}' ;;
        *) _tautline_words "$_tautline_commands" ;;
      esac ;;
{per_command}  esac
}}
complete -F _tautline tautline
)",
      fmt::arg("commands", command_names(outline)), fmt::arg("cases", case_names()),
      fmt::arg("functions", shell_functions),
      fmt::arg("options", spaced(option_names(outline.options))), fmt::arg("per_command", cases));
}

}  // namespace tautline::bench
