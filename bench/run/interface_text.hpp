#pragma once

#include <string>
#include <string_view>

namespace tautline::bench {

/// Why a plug-in whose interface text is `theirs` cannot be loaded by a program whose text is
/// `ours` (TAUTLINE_INTERFACE of plugin.hpp), and how to build one that can; empty if it can be.
[[nodiscard]] std::string misfit(std::string_view theirs, std::string_view ours);

}  // namespace tautline::bench
