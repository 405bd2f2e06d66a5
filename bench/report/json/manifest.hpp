#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bench/report/manifest.hpp"

namespace tautline::bench {

/// A line for every row.
[[nodiscard]] std::string manifest_json(const Manifest& manifest);

/// None if `text` is no manifest of this form.
[[nodiscard]] std::optional<Manifest> manifest_from(std::string_view text);

}  // namespace tautline::bench
