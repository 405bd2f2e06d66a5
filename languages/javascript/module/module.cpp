// What differs in the module. JavaScript writes and reads decimals for it, since the C++ library
// would bring tables as large as a quarter of the module. Nothing is printed or thrown.
#include "module.hpp"

#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include "tautline/solve_batch.hpp"

#define TAUTLINE_FROM_JAVASCRIPT(name) __attribute__((import_module("tautline"), import_name(name)))

extern "C" {
/// Writes `value` as std::to_chars does: to as many significant digits as asked, or for 0 to as
/// many as tell it from other doubles. Returns the length of the text, at most 32.
TAUTLINE_FROM_JAVASCRIPT("write_number")
std::int32_t tautline_write_number(double value, std::int32_t digits, char* to);
/// The double that is nearest to a decimal; NaN if the text is none.
TAUTLINE_FROM_JAVASCRIPT("read_number")
double tautline_read_number(const char* from, std::size_t length);
}

namespace {

std::to_chars_result write(char* first, char* last, double value, int digits) {
  constexpr std::ptrdiff_t longest = 32;
  char text[longest];
  const std::ptrdiff_t length = tautline_write_number(value, digits, text);
  if (length > last - first) {
    return {last, std::errc::value_too_large};
  }
  std::memcpy(first, text, static_cast<std::size_t>(length));
  return {first + length, std::errc()};
}

/// True for text such as 1e-400: it has a digit that is not 0 before its exponent.
bool is_above_zero(const char* first, const char* last) {
  for (; first != last && *first != 'e' && *first != 'E'; ++first) {
    if (*first >= '1' && *first <= '9') {
      return true;
    }
  }
  return false;
}

}  // namespace

_LIBCPP_BEGIN_NAMESPACE_STD

to_chars_result to_chars(char* first, char* last, double value) {
  return write(first, last, value, 0);
}

/// `chars_format::general` alone.
to_chars_result to_chars(char* first, char* last, double value, chars_format /*format*/,
                         int digits) {
  return write(first, last, value, digits);
}

/// Nobody would see the sentence.
void __libcpp_verbose_abort(const char* /*format*/, ...) { __builtin_trap(); }

_LIBCPP_END_NAMESPACE_STD

namespace std {

from_chars_result from_chars(const char* first, const char* last, double& value,
                             chars_format /*format*/) {
  const double read = tautline_read_number(first, static_cast<size_t>(last - first));
  if (std::isnan(read)) {
    return {first, errc::invalid_argument};
  }
  if (std::isinf(read) || (read == 0.0 && is_above_zero(first, last))) {
    return {last, errc::result_out_of_range};
  }
  value = read;
  return {last, errc()};
}

}  // namespace std

/// One after the other, to the same bits: the module has no vectors that could solve several at
/// once.
void tautline::solve_batch(std::span<const Case> cases, const SolveOptions& options,
                           const TakeSolution& take) {
  for (std::size_t index = 0; index < cases.size(); ++index) {
    take(index, solve(cases[index], options));
  }
}

extern "C" {

/// nlohmann's JSON asks for the number of a whole text.
double strtod(const char* text, char** end) {
  const std::size_t length = std::strlen(text);
  if (end != nullptr) {
    *end = const_cast<char*>(text) + length;
  }
  return tautline_read_number(text, length);
}
// The C library has these in one object with its own strtod. Nobody calls them.
float strtof(const char* /*text*/, char** /*end*/) { __builtin_trap(); }
long double strtold(const char* /*text*/, char** /*end*/) { __builtin_trap(); }

/// nlohmann's JSON quotes a control character by "<U+%.4X>", and nobody else calls this.
int snprintf(char* to, std::size_t room, const char* /*format*/, ...) {
  std::va_list words;
  va_start(words, room);
  const auto character = va_arg(words, unsigned);
  va_end(words);
  constexpr char hexadecimal[] = "0123456789ABCDEF";
  char text[] = "<U+0000>";
  text[5] = hexadecimal[character / 16 % 16];
  text[6] = hexadecimal[character % 16];
  std::memcpy(to, text, room < sizeof text ? 0 : sizeof text);
  return static_cast<int>(sizeof text) - 1;
}

// Sentences of libc++abi before it ends the program: nobody would see them.
void abort_message(const char* /*format*/, ...) { __builtin_trap(); }

}  // extern "C"

/// The program ends where memory is missing: a module of WebAssembly may have 4 GB.
void* operator new(std::size_t size) {
  void* const room = std::malloc(size > 0 ? size : 1);
  if (room == nullptr) {
    __builtin_trap();
  }
  return room;
}
void operator delete(void* room) noexcept { std::free(room); }
void operator delete(void* room, std::size_t /*size*/) noexcept { std::free(room); }
