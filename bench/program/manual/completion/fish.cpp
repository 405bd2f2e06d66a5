#include <fmt/format.h>

#include "bench/program/manual/completion/offer.hpp"
#include "bench/program/manual/manual.hpp"

namespace tautline::bench {
namespace {

std::string fish_offer(const Argument& argument) {
  switch (offer_of(argument)) {
    case Offer::file:
      return " -r -F";
    case Offer::folder:
      return " -x -a '(__fish_complete_directories)'";
    case Offer::one_case:
      return " -r -F -a " + in_quotes(case_names());
    case Offer::engine:
      return " -r -F -a '(_tautline_engines)'";
    case Offer::model:
      return " -x -a '(_tautline_models)'";
    case Offer::command:
      return " -x -a \"$commands\"";
    case Offer::choices:
      return " -x -a " + in_quotes(spaced(argument.choices));
    case Offer::nothing:
      break;
  }
  return " -x";
}

std::string fish_command(const Command& command) {
  const std::string when =
      fmt::format("complete -c tautline -n '__fish_seen_subcommand_from {}'", command.name);
  std::string lines;
  for (const Argument& option : command.options) {
    std::string names;
    for (const std::string& name : option.names) {
      names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    lines += when + names + (option.value.empty() ? "" : fish_offer(option)) + " -d " +
             in_quotes(option.meaning) + "\n";
  }
  return command.words.empty() ? lines : lines + when + fish_offer(command.words.front()) + "\n";
}

}  // namespace

std::string fish_completion(const Outline& outline) {
  std::string commands;
  std::string rest;
  for (const Command& command : outline.commands) {
    commands += fmt::format(
        "complete -c tautline -n \"not __fish_seen_subcommand_from $commands\" -a {} -d {}\n",
        command.name, in_quotes(command.summary));
    rest += fish_command(command);
  }
  return fmt::format(
      R"(# fish completion of tautline, made by `tautline help --completion fish`
set -l commands {}
function _tautline_engines
  tautline engines 2>/dev/null | sed -n 's/^\([^ ][^ ]*\)  version.*/\1/p'
end
function _tautline_models
  tautline engines 2>/dev/null | sed -n 's/^  \([^ ][^ ]*\)  .*/\1/p' | sort -u
end
complete -c tautline -f
{}{})",
      command_names(outline), commands, rest);
}

}  // namespace tautline::bench
