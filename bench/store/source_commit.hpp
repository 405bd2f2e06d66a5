#pragma once

#include <string_view>

namespace tautline::bench {

/// The commit of the source that this program was built from, followed by "-dirty" if it was
/// changed since; "unknown" outside git. Written by cmake/SourceCommit.cmake when the program is
/// built.
[[nodiscard]] std::string_view source_commit();

}  // namespace tautline::bench
