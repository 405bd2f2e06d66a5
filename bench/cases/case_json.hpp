#pragma once

#include <optional>
#include <string_view>

#include "bench/base/problems.hpp"
#include "bench/base/toml.hpp"

namespace tautline::bench {

/// True for text that begins with {, as no TOML does.
[[nodiscard]] bool is_json(std::string_view text);

/// The table that a JSON object holds; none, and a finding, if it is not JSON or has no like in
/// TOML: a key given twice, a null. The values know no line.
[[nodiscard]] std::optional<toml::table> parse_json(std::string_view text, FileProblems& wrong);

}  // namespace tautline::bench
