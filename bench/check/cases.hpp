#pragma once

#include <string_view>

#include "tautline/case.hpp"

namespace tautline::bench {

// The cases that several claims are measured on.

/// The case that ships under `name`; it must exist.
[[nodiscard]] Case shipped_case(std::string_view name);

/// The first breakwater of Table 5.1, with this restitution.
[[nodiscard]] Case standard_breakwater(double restitution);

/// One cable through an attachment of a spinning body, slack for the first `slack` metres.
[[nodiscard]] Case spinning_on_one_cable(double slack);

/// `the_case` in a mirror on the y axis, with the cables in reverse order.
[[nodiscard]] Case mirrored(const Case& the_case);
[[nodiscard]] State mirrored(State state);

}  // namespace tautline::bench
