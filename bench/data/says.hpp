#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace tautline::bench {

/// What is written as the word that its `to_string` gives.
template <class Value>
concept Enumeration = std::is_enum_v<Value>;

/// `all` enumerators of such an enumeration.
template <Enumeration Enum>
struct Words;

/// Values that are an object in JSON, with a key for each.
template <class Value>
struct ByName {
  std::vector<std::pair<std::string, Value>> rows;
};

/// What the schema of a report says of a member beside its name and type.
struct Says {
  // implicit: most members have a meaning alone
  Says(const char* text = "") : meaning(text) {}  // NOLINT(google-explicit-constructor)

  /// Of a list: that it has an entry.
  [[nodiscard]] Says not_empty() && {
    some = true;
    return *this;
  }

  /// Of a list: how many entries it has.
  Says of(int entries) && {
    count = entries;
    return *this;
  }

  const char* meaning;
  std::vector<std::string_view> words;  // the only ones that it may be; none: any
  std::optional<int> least;             // of a number, or of each of a list
  std::optional<int> most;
  bool exclusive = false;  // of `least`: it is larger
  bool or_null = false;    // a number that may be missing, or each of a list
  bool some = false;
  std::optional<int> count;  // of the entries of a list
};

inline Says one_of(std::vector<std::string_view> words, const char* meaning = "") {
  Says says(meaning);
  says.words = std::move(words);
  return says;
}

inline Says at_least(int least, const char* meaning = "") {
  Says says(meaning);
  says.least = least;
  return says;
}

inline Says above(int least, const char* meaning = "") {
  Says says = at_least(least, meaning);
  says.exclusive = true;
  return says;
}

inline Says in_range(int least, int most, const char* meaning = "") {
  Says says = at_least(least, meaning);
  says.most = most;
  return says;
}

inline Says or_null(Says says = {}) {
  says.or_null = true;
  return says;
}

/// The number of a form of JSON: no other version of it.
template <class Visitor>
void schema_field(Visitor& visit, std::int32_t number) {
  visit("schema", number, in_range(number, number));
}

}  // namespace tautline::bench
