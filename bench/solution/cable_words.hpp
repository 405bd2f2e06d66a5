#pragma once

#include <cstddef>
#include <string>

#include "tautline/cable_set.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// "0+1"
[[nodiscard]] std::string cable_list(CableSet cables);

/// "cable 0", "cables 0 and 1", "cables 0, 1 and 2"; not empty.
[[nodiscard]] std::string cable_names(CableSet cables);

/// What rounding decides at `time`, in a sentence: which of `cables` is hit first
/// (`EventKind::impact`), or whether they let go (`EventKind::slack`).
[[nodiscard]] std::string tie_sentence(EventKind kind, CableSet cables, const std::string& time);

/// That the body at rest hangs with the tensions of `list`, which statics may not `determine`.
[[nodiscard]] std::string rest_tension_sentence(const std::string& list, bool determine);

/// That the `impulses` of an impact at `time` are one split of several among `cables`, in a
/// sentence, and so are those of `more` later impacts.
[[nodiscard]] std::string split_sentence(CableSet cables, const std::string& time,
                                         const std::string& impulses, std::size_t more);

}  // namespace tautline::bench
