#include "bench/run/protocol/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/run/protocol/messages.hpp"

namespace tautline::bench {
namespace {

struct NumberWord {
  std::string_view word;
  double value;
};
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr NumberWord number_words[] = {{"NaN", std::numeric_limits<double>::quiet_NaN()},
                                       {"Infinity", infinite},
                                       {"-Infinity", -infinite},
                                       {"-0", -0.0}};

std::optional<double> number_from(const Json& value) {
  if (value.is_number()) {
    return value.get<double>();
  }
  if (const auto* const text = value.get_ptr<const std::string*>()) {
    for (const NumberWord& special : number_words) {
      if (*text == special.word) {
        return special.value;
      }
    }
  }
  return std::nullopt;
}

/// What stands there, for a sentence; of what holds more than plain values only its kind, since a
/// child may nest them as deep as its line is long.
std::string excerpt(const Json& value) {
  const bool nested = std::any_of(value.begin(), value.end(),
                                  [](const Json& inner) { return inner.is_structured(); });
  if (value.is_structured() && nested) {
    return value.is_object() ? "an object" : fmt::format("an array of {}", value.size());
  }
  return printable(value.dump(), excerpt_length);
}

}  // namespace

Json number_json(double value) {
  if (std::isnan(value)) {
    return "NaN";
  }
  if (std::isinf(value)) {
    return value > 0.0 ? "Infinity" : "-Infinity";
  }
  return value;  // a negative zero is written as -0.0
}

Part::Part(const Json& value, std::string name, std::string_view method)
    : value_(&value), place_(std::move(name)), method_(method) {}

Part Part::at(const char* key) const {
  if (auto part = find(key)) {
    return *std::move(part);
  }
  throw ProtocolError(fmt::format("the engine's answer to {} lacks {}", method_, inside(key)));
}

std::optional<Part> Part::find(const char* key) const {
  if (!value_->is_object()) {
    refuse("an object");
  }
  const auto member = value_->find(key);
  if (member == value_->end()) {
    return std::nullopt;
  }
  return Part(*member, inside(key), method_);
}

void Part::has_only(std::initializer_list<const char*> keys) const {
  if (!value_->is_object()) {
    refuse("an object");
  }
  for (const auto& [key, value] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      const std::vector<std::string> known(keys.begin(), keys.end());
      const std::string word = printable(key, excerpt_length);
      throw ProtocolError(fmt::format("the engine's answer to {} has an unknown key {}{}", method_,
                                      inside(word), suggestion(word, known)));
    }
  }
}

std::string Part::text() const {
  const auto* const text = value_->get_ptr<const std::string*>();
  if (text == nullptr) {
    refuse("a string");
  }
  return *text;
}

std::string Part::name() const {
  std::string name = text();
  if (name.empty() ||
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos) {
    refuse("a name of small letters, digits and hyphens");
  }
  return name;
}

std::string Part::one_of(const std::vector<std::string>& words) const {
  std::string word = text();
  if (std::find(words.begin(), words.end(), word) == words.end()) {
    refuse(joined(words, "or"));
  }
  return word;
}

bool Part::flag() const {
  if (!value_->is_boolean()) {
    refuse("true or false");
  }
  return value_->get<bool>();
}

double Part::number() const {
  const auto number = number_from(*value_);
  if (!number) {
    refuse("a number, or \"NaN\", \"Infinity\", \"-Infinity\" or \"-0\"");
  }
  return *number;
}

void Part::append_numbers(std::vector<double>& to, std::size_t count,
                          std::string_view right) const {
  if (!value_->is_array() || value_->size() != count) {
    refuse(fmt::format("{} numbers: {}", count, right));
  }
  for (std::size_t index = 0; index < count; ++index) {
    const auto number = number_from((*value_)[index]);
    to.push_back(number ? *number : (*this)[index].number());
  }
}

std::size_t Part::size() const {
  if (!value_->is_array()) {
    refuse("an array");
  }
  return value_->size();
}

Part Part::operator[](std::size_t index) const {
  return {(*value_)[index], fmt::format("{}[{}]", place_, index), method_};
}

void Part::refuse(std::string_view right) const {
  throw ProtocolError(fmt::format("the engine's answer to {}: {} is {}, must be {}", method_,
                                  place_.empty() ? "the result" : place_, excerpt(*value_), right));
}

std::string Part::inside(std::string_view key) const {
  return place_.empty() ? std::string(key) : fmt::format("{}.{}", place_, key);
}

}  // namespace tautline::bench
