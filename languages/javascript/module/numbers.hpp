#pragma once

#include <charconv>

// What the C++ library for WASI leaves out and sources of the module name. This header comes before all of them.

// toml++ has a function that reads a file. Nobody calls it.
#undef _LIBCPP_HAS_NO_FILESYSTEM
#include <fstream>
#define _LIBCPP_HAS_NO_FILESYSTEM

namespace std {

/// Reads the whole of a decimal number.
from_chars_result from_chars(const char* first, const char* last, double& value,
                             chars_format format = chars_format::general);

}  // namespace std
