#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// JSON as the protocol has it: for the sources that write its requests and read its answers.

namespace tautline::bench {

using Json = nlohmann::json;

/// A number, or the word for what JSON has no number for: "NaN", "Infinity", "-Infinity".
[[nodiscard]] Json number_json(double value);

/// What a child wrote is quoted up to this length in a sentence [bytes]: a report cuts long ones.
inline constexpr std::size_t excerpt_length = 40;

/// A part of an answer, with its place in it. Whatever is not as asked is a ProtocolError that
/// says where, what is there, and what would be right.
class Part {
 public:
  Part(const Json& value, std::string name, std::string_view method);

  [[nodiscard]] Part at(const char* key) const;
  [[nodiscard]] std::optional<Part> find(const char* key) const;
  /// Refuses every other key: a slip in the name of an optional one would pass unseen.
  void has_only(std::initializer_list<const char*> keys) const;

  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string name() const;  // of an engine or a model
  [[nodiscard]] std::string one_of(const std::vector<std::string>& words) const;
  [[nodiscard]] bool flag() const;
  [[nodiscard]] double number() const;
  /// Appends the numbers of an array that has so many of them.
  void append_numbers(std::vector<double>& to, std::size_t count, std::string_view right) const;

  [[nodiscard]] std::size_t size() const;  // of an array
  [[nodiscard]] Part operator[](std::size_t index) const;

  /// It is no such thing as it must be.
  [[noreturn]] void refuse(std::string_view right) const;

 private:
  [[nodiscard]] std::string inside(std::string_view key) const;

  const Json* value_;
  std::string place_;
  std::string_view method_;
};

}  // namespace tautline::bench
