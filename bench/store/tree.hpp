#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bench/base/descriptor.hpp"

namespace tautline::bench {

/// Makes `out` a result tree, or opens it if it is one; with `clear` an earlier tree's runs and
/// report are removed. The tree is this program's alone until the descriptor is gone. Throws
/// FileError if it cannot be made, or if another program is writing to it.
[[nodiscard]] Descriptor open_tree(const std::filesystem::path& out, bool clear);

/// Why `out` cannot be made a result tree, or none: it holds files that are not one.
[[nodiscard]] std::optional<std::string> tree_problem(const std::filesystem::path& out);

}  // namespace tautline::bench
