// Completion in a shell: the script of each shell hands the command line to the program, which
// prints what may stand at its end.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/title.hpp"
#include "bench/program/manual.hpp"
#include "bench/run/registry.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// A word for a shell to offer, and what it means. The words ":files", with a pattern, and
/// ":folders" ask the shell for those it finds there.
using Offers = std::vector<std::pair<std::string, std::string>>;

Offers names_of(const std::vector<Argument>& options) {
  Offers offers;
  for (const Argument& option : options) {
    for (const std::string& name : option.names) {
      offers.emplace_back(name, option.meaning);
    }
  }
  return offers;
}

Offers commands_of(const Outline& outline) {
  return listed<Offers::value_type>(outline.commands, [](const Command& command) {
    return std::pair(command.name, command.summary);
  });
}

Offers cases_and_files(bool systems) {
  Offers offers = {{":files", "*.toml"}};
  for (const Case& the_case : shipped_cases()) {
    offers.emplace_back(the_case.name, title_of(the_case));
  }
  if (systems) {
    each_shipped_system(
        [&](const auto& one) { offers.emplace_back(one.system.name, title_of(one)); });
  }
  return offers;
}

/// None of them is asked what it is, which takes longer than a shell may wait.
Offers engines_and_files() {
  Offers offers = {{":files", "*.(so|toml)"}};
  for (const RegisteredEngine& engine : registered_engines(Asked::none)) {
    if (engine.missing.empty() && engine.failure.empty()) {
      offers.emplace_back(engine.name, "");
    }
  }
  return offers;
}

/// The models of the engines that the command line names, or of all plug-ins.
Offers models_of(std::vector<std::string> engines) {
  const auto known = registered_engines(Asked::none);
  for (std::string& engine : engines) {  // those of a path are asked alone
    const auto* const here = find_by(known, &RegisteredEngine::name, engine);
    engine = here != nullptr && here->missing.empty() ? here->plugin.string() : engine;
  }
  std::map<std::string, std::string> models;
  for (const RegisteredEngine& engine : choose_engines(engines).engines) {
    for (const Model& model : engine.info ? engine.info->models : std::vector<Model>()) {
      models.emplace(model.name, printable(model.sentence, 1000));
    }
  }
  return {models.begin(), models.end()};
}

std::string kind_of(const Argument& argument) {
  return argument.is_word() ? argument.names.front() : argument.value;
}

bool is_engine(const Argument& argument) {
  const std::string kind = kind_of(argument);
  return kind == "ENGINE" || kind == "ENGINES" || kind == "PLUGIN";
}

/// A command line but for its last word, as far as that word's meaning depends on it.
struct TypedLine {
  const Argument* asked = nullptr;   // the option whose value comes next
  bool has_word = false;             // one that is known by its place
  std::vector<std::string> engines;  // that are named
  bool takes_systems = false;        // where it takes a case
};

TypedLine read_line(const Command& command, const std::vector<std::string>& words) {
  TypedLine line;
  line.takes_systems =
      command.name == "solve" || command.name == "cases" || command.name == "ensemble";
  for (const std::string& word : words) {
    const Argument* argument = std::exchange(line.asked, nullptr);
    if (argument == nullptr && word.starts_with('-')) {
      const auto option =
          std::find_if(command.options.begin(), command.options.end(), [&](const Argument& one) {
            return std::count(one.names.begin(), one.names.end(), word) > 0;
          });
      const bool takes_value = option != command.options.end() && !option->value.empty();
      line.asked = takes_value ? &*option : nullptr;
      continue;
    }
    if (argument == nullptr && !command.words.empty()) {
      argument = &command.words.front();
      line.has_word = true;
    }
    if (argument != nullptr && is_engine(*argument)) {
      const auto names = CLI::detail::split(word, ',');
      line.engines.insert(line.engines.end(), names.begin(), names.end());
    }
  }
  return line;
}

Offers values_of(const Argument& argument, const TypedLine& line, const Outline& outline) {
  const std::string kind = kind_of(argument);
  if (!argument.choices.empty()) {
    return listed<Offers::value_type>(argument.choices,
                                      [](const std::string& one) { return std::pair(one, ""); });
  }
  if (kind == "FILE" || kind == "LIMITS" || kind == "REPORTS") {
    return {{":files", "*"}};
  }
  if (kind == "FOLDER") {
    return {{":folders", ""}};
  }
  if (kind == "CASE" || kind == "CASES") {
    return cases_and_files(line.takes_systems);
  }
  if (kind == "COMMAND") {
    return commands_of(outline);
  }
  return is_engine(argument)                   ? engines_and_files()
         : kind == "MODEL" || kind == "MODELS" ? models_of(line.engines)
                                               : Offers();
}

/// The words as a shell sees them, but "--engine=exact" in two; bash hands it over in three.
std::vector<std::string> apart(const std::vector<std::string>& words) {
  std::vector<std::string> result;
  for (const std::string& word : words) {
    const std::size_t sign = word.starts_with("--") ? word.find('=') : std::string::npos;
    if (word != "=") {
      result.push_back(word.substr(0, sign));
    }
    if (sign != std::string::npos) {
      result.push_back(word.substr(sign + 1));
    }
  }
  if (words.empty() || words.back() == "=") {
    result.emplace_back();
  }
  return result;
}

constexpr const char* bash_script = R"(# bash completion of tautline
_tautline() {
  local line cur="${COMP_WORDS[COMP_CWORD]#=}"
  COMPREPLY=()
  while IFS= read -r line; do
    case "$line" in
      :files*) mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$cur") ;;&
      :folders*) mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$cur") ;;&
      :*) compopt -o filenames 2>/dev/null ;;
      "$cur"*) COMPREPLY+=("${line%%$'\t'*}") ;;
    esac
  done < <("${COMP_WORDS[0]/#\~/$HOME}" --complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -F _tautline tautline
)";

constexpr const char* fish_script = R"(# fish completion of tautline
function __tautline_offers
  set -l words (commandline -opc)
  set -l last (commandline -ct)
  set -l option (string match -r -- '^--[a-z-]+=' $last)
  set -l value (string replace -r -- '^--[a-z-]+=' '' $last)
  set -l program (string replace -r '^~' ~ -- $words[1])
  for line in ($program --complete $words[2..] "$last" 2>/dev/null)
    switch $line
      case ':files*'
        __fish_complete_path "$value"
      case ':folders*'
        __fish_complete_directories "$value" ''
      case '*'
        echo $line
    end
  end | string replace -r '^' -- "$option"
end
complete -c tautline -f -a '(__tautline_offers)'
)";

constexpr const char* zsh_script = R"(#compdef tautline
_tautline() {
  local line
  local -a offers patterns
  for line in "${(@f)$(${~words[1]} --complete "${(@)words[2,CURRENT-1]}" "$PREFIX" 2>/dev/null)}"; do
    case $line in
      :files*) patterns=(-g "${line#*$'\t'}") ;;
      :folders*) patterns=(-/) ;;
      ?*)
        line="${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}"
        offers+=("${line%:}") ;;
    esac
  done
  compset -P '--*='
  _describe -t words word offers -S ' ' -r ', '
  (( $#patterns )) && _files $patterns
}
_tautline "$@"
)";

}  // namespace

std::string completions(const Outline& outline, const std::vector<std::string>& typed) {
  std::vector<std::string> words = apart(typed);
  const std::string last = words.back();
  words.pop_back();
  const auto name = std::find_if(words.begin(), words.end(),
                                 [](const std::string& word) { return !word.starts_with('-'); });
  Offers offers;
  std::string before;  // of a list with commas, all but its last item
  if (name == words.end()) {
    offers = last.starts_with('-') ? names_of(outline.options) : commands_of(outline);
  } else if (const auto* command = find_by(outline.commands, &Command::name, *name)) {
    const TypedLine line = read_line(*command, {name + 1, words.end()});
    const Argument* asked = line.asked;
    if (asked == nullptr && !last.starts_with('-') && !command->words.empty() &&
        (command->words.front().repeats || !line.has_word)) {
      asked = &command->words.front();
    }
    offers = asked != nullptr ? values_of(*asked, line, outline) : names_of(command->options);
    if (asked != nullptr && asked->repeats && !asked->is_word()) {
      before = last.substr(0, last.rfind(',') + 1);
    }
  }
  std::string result;
  for (const auto& [word, meaning] : offers) {
    result += fmt::format("{}{}\t{}\n", word.starts_with(':') ? "" : before, word, meaning);
  }
  return result;
}

const std::map<std::string, std::string>& completion_scripts() {
  static const std::map<std::string, std::string> scripts = {
      {"bash", bash_script}, {"fish", fish_script}, {"zsh", zsh_script}};
  return scripts;
}

}  // namespace tautline::bench
