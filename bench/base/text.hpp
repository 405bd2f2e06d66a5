#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::bench {

/// The shortest decimal that reads back as the same double: "0.1", "-0", "1e+20", "nan".
[[nodiscard]] std::string shortest(double value);

/// `value` with so many digits after the point: "0.9000". What rounds to zero has no sign.
[[nodiscard]] std::string fixed_text(double value, int digits);

/// Of `candidates`, at most three that `name` is likely to be a slip of, the likeliest first.
/// Equally likely ones keep their order.
[[nodiscard]] std::vector<std::string> nearest(std::string_view name,
                                               std::span<const std::string> candidates);

/// "a, b or c" for the last word "or"; "" for nothing.
[[nodiscard]] std::string joined(std::span<const std::string> words, std::string_view last_word);

/// "; did you mean a or b?" with the names nearest to `name`; "" where none is near.
[[nodiscard]] std::string suggestion(std::string_view name,
                                     std::span<const std::string> candidates);

/// Longer text than this is cut where it is quoted in a sentence [bytes].
inline constexpr std::size_t quotable_length = 160;

/// `text` in a form that is safe and legible in one line of a terminal: control characters, marks
/// that turn the direction of writing and bytes that are not UTF-8 become "\x1b"; what is longer
/// than `longest` bytes is cut and ends in "...".
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest = quotable_length);

/// True for text in UTF-8, also if it is empty.
[[nodiscard]] bool is_utf8(std::string_view text);

/// `text` with what XML and HTML read as their own made harmless.
[[nodiscard]] std::string xml_text(std::string_view text);

/// A number for a text that is the same on every machine and in every release (FNV-1a). Not for
/// secrets.
[[nodiscard]] std::uint64_t stable_hash(std::string_view text);

}  // namespace tautline::bench
