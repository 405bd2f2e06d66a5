#include "bench/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

namespace tautline::bench {
namespace {

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before_last(to.size() + 1);
  std::vector<std::size_t> last(to.size() + 1);
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last.back();
}

/// How far `name` is from `candidate`; none where nobody would take the one for the other.
std::optional<std::size_t> plausible_distance(std::string_view name, std::string_view candidate) {
  if (name == candidate) {
    return 0;
  }
  constexpr std::size_t telling = 4;  // a shorter piece of a name says too little
  if (name.size() >= telling && candidate.find(name) != std::string_view::npos) {
    return 1;  // only a part was given, as in `1910121100` for `breakwater/1910121100`
  }
  // a third of the letters may be wrong: `lenght`, not any word of the same length
  const std::size_t allowed = std::max(name.size(), candidate.size()) / 3;
  const auto [shorter, longer] = std::minmax({name.size(), candidate.size()});
  if (longer - shorter > allowed) {
    return std::nullopt;
  }
  const std::size_t distance = edit_distance(name, candidate);
  return distance <= allowed ? std::optional(distance) : std::nullopt;
}

/// One character at the start of `text`, or one byte that starts none.
struct Character {
  std::size_t bytes;
  bool legible;
  bool sound = true;  // UTF-8
};

bool continues(unsigned char byte) { return (byte & 0xC0U) == 0x80U; }

/// Control characters (C0, DEL, C1), line separators and marks that reorder what a reader sees.
bool is_legible(std::uint32_t code) {
  const auto within = [code](std::uint32_t first, std::uint32_t last) {
    return code >= first && code <= last;
  };
  return code >= 0x20 && !within(0x7F, 0x9F) && code != 0x061C && !within(0x200E, 0x200F) &&
         !within(0x2028, 0x202E) && !within(0x2066, 0x2069) && code != 0xFEFF;
}

Character first_character(std::string_view text) {
  const auto byte = [text](std::size_t index) { return static_cast<unsigned char>(text[index]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) {
    return {1, is_legible(lead)};
  }
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) {
    return {1, false, false};
  }
  std::uint32_t code = lead & (0x7FU >> bytes);
  for (std::size_t index = 1; index < bytes; ++index) {
    if (!continues(byte(index))) {
      return {1, false, false};
    }
    code = (code << 6U) | (byte(index) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  const bool sound = code >= least[bytes] && code <= 0x10FFFF && !surrogate;
  return sound ? Character{bytes, is_legible(code)} : Character{1, false, false};
}

std::string escaped(std::string_view bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    result += {'\\', 'x', digits[byte >> 4U], digits[byte & 0xFU]};
  }
  return result;
}

}  // namespace

std::string shortest(double value) {
  std::array<char, 32> buffer{};  // the longest is 24 characters, as in -1.7976931348623157e+308
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

std::string fixed_text(double value, int digits) {
  std::string text(330 + static_cast<std::size_t>(digits), '\0');  // 1e308 has 309 digits
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                          std::chars_format::fixed, digits);
  text.resize(static_cast<std::size_t>(end - text.data()));
  const bool is_zero = text.find_first_of("123456789infa") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::vector<std::string> nearest(std::string_view name, std::span<const std::string> candidates) {
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const std::string& candidate : candidates) {
    if (const auto distance = plausible_distance(name, candidate)) {
      found.emplace_back(*distance, candidate);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& one, const auto& two) { return one.first < two.first; });
  constexpr std::size_t enough = 3;
  std::vector<std::string> result;
  for (const auto& [distance, candidate] : std::span(found).first(std::min(enough, found.size()))) {
    result.push_back(candidate);
  }
  return result;
}

std::string joined(std::span<const std::string> words, std::string_view last_word) {
  std::string result;
  for (std::size_t index = 0; index < words.size(); ++index) {
    if (index > 0) {
      result += index + 1 == words.size() ? " " + std::string(last_word) + " " : ", ";
    }
    result += words[index];
  }
  return result;
}

std::string suggestion(std::string_view name, std::span<const std::string> candidates) {
  std::vector<std::string> found = nearest(name, candidates);
  for (std::string& candidate : found) {
    candidate = printable(candidate);
  }
  return found.empty() ? "" : "; did you mean " + joined(found, "or") + "?";
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::string_view bytes = text.substr(0, character.bytes);
    const std::string next = character.legible ? std::string(bytes) : escaped(bytes);
    if (result.size() + next.size() > longest) {
      return result + "...";
    }
    result += next;
    text.remove_prefix(character.bytes);
  }
  return result;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const Character character = first_character(text);
    if (!character.sound) {
      return false;
    }
    text.remove_prefix(character.bytes);
  }
  return true;
}

std::uint64_t stable_hash(std::string_view text) {
  std::uint64_t result = 0xcbf29ce484222325U;  // Fowler, Noll and Vo, 64 bit
  for (const char letter : text) {
    result = (result ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
  }
  return result;
}

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

}  // namespace tautline::bench
