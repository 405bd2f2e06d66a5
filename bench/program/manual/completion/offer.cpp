#include "bench/program/manual/completion/offer.hpp"

#include <fmt/ranges.h>

#include "bench/base/listed.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {

Offer offer_of(const Argument& argument) {
  const std::string& kind = argument.is_word() ? argument.names.front() : argument.value;
  if (!argument.choices.empty()) {
    return Offer::choices;
  }
  if (kind == "FILE" || kind == "LIMITS" || kind == "REPORTS") {
    return Offer::file;
  }
  if (kind == "FOLDER") {
    return Offer::folder;
  }
  if (kind == "CASE" || kind == "CASES") {
    return Offer::one_case;
  }
  if (kind == "ENGINE" || kind == "ENGINES" || kind == "PLUGIN") {
    return Offer::engine;
  }
  if (kind == "COMMAND") {
    return Offer::command;
  }
  return kind == "MODEL" || kind == "MODELS" ? Offer::model : Offer::nothing;
}

std::string spaced(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::string case_names() { return spaced(listed(shipped_cases(), &Case::name)); }

std::string command_names(const Outline& outline) {
  return spaced(listed(outline.commands, &Command::name));
}

std::string in_quotes(std::string text) {
  for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at)) {
    text.replace(at, 1, "\u2019");
  }
  return "'" + text + "'";
}

}  // namespace tautline::bench
