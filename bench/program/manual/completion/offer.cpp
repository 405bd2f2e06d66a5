#include "bench/program/manual/completion/offer.hpp"

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
  std::string result;
  for (const std::string& word : words) {
    result += (result.empty() ? "" : " ") + word;
  }
  return result;
}

std::string case_names() {
  const std::vector<std::string> names = listed(shipped_cases(), &Case::name);
  return spaced(names);
}

std::string command_names(const Outline& outline) {
  const std::vector<std::string> names = listed(outline.commands, &Command::name);
  return spaced(names);
}

std::string option_names(const std::vector<Argument>& options) {
  std::vector<std::string> names;
  for (const Argument& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return spaced(names);
}

std::string in_quotes(std::string text) {
  for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at)) {
    text.replace(at, 1, "\u2019");
  }
  return "'" + text + "'";
}

}  // namespace tautline::bench
