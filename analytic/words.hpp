#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace tautline {

// How sentences about a case name its things and numbers.

/// The shortest decimal that reads back equal.
[[nodiscard]] inline std::string text(double value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

[[nodiscard]] inline std::string cable_name(std::size_t index) {
  return "cable " + std::to_string(index);
}

[[nodiscard]] inline std::string body_name(std::size_t index) {
  return "body " + std::to_string(index);
}

}  // namespace tautline
