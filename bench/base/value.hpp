#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "bench/base/problems.hpp"
#include "bench/base/toml.hpp"

namespace tautline::bench {

/// The table that the text holds; none, and a finding, where it is not TOML.
[[nodiscard]] std::optional<toml::table> parse_toml(std::string_view text, FileProblems& wrong);

/// The line of a node, from 1; 0 for null.
[[nodiscard]] std::size_t line_of(const toml::node* node);

/// "a string", "an integer", and so on.
[[nodiscard]] std::string type_name(const toml::node& node);

/// " = 1.2" or " = [0, 1, 2]"; "" for what is too long to quote.
[[nodiscard]] std::string quoted_value(const toml::node& node);

/// `text` as a string of a TOML file, in its quotes.
[[nodiscard]] std::string toml_string(const std::string& text);

/// The value of a number, with or without a decimal point; none for other types.
[[nodiscard]] std::optional<double> as_number(const toml::node& node);

}  // namespace tautline::bench
