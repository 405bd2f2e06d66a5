#pragma once

#include <charconv>

// What the C++ library for WASI leaves out and sources of the module name. This header comes before
// all of them.

// toml++ has a function that reads a file. Nobody calls it.
#undef _LIBCPP_HAS_NO_FILESYSTEM
#include <fstream>
#define _LIBCPP_HAS_NO_FILESYSTEM

namespace std {

/// Reads the whole of a decimal number.
from_chars_result from_chars(const char* first, const char* last, double& value,
                             chars_format format = chars_format::general);

}  // namespace std

// Nothing is thrown for a case without problems. The module is compiled without exceptions, of
// which nobody would catch one. This comes after the headers of the C++ library that have functions
// of this form.
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#define throw __builtin_trap(),
