#pragma once

#include <string>

namespace tautline::ode {

/// Starts ODE for this thread, and for the process the first time. ODE's errors become exceptions,
/// its messages are dropped.
void use_library();

/// "float64" or "float32", asked from the library.
[[nodiscard]] std::string precision();

}  // namespace tautline::ode
