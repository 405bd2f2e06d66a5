#pragma once

#include <string>

namespace tautline::bench {

/// `text` with the signs that it spells in ASCII, for a page: "sqrt(S/g)" as "√(S/g)", "<=" as "≤".
[[nodiscard]] std::string typeset(std::string text);

}  // namespace tautline::bench
