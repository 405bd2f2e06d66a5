#include "library.hpp"

#include <ode/ode.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <stdexcept>

namespace tautline::ode {
namespace {

extern "C" {

/// ODE warns of "LCP internal error, s <= 0" for every step in which two cables are satisfied
/// exactly, thousands of times; the results are right.
void drop_message(int /*number*/, const char* /*format*/, va_list /*arguments*/) {}

/// ODE ends the process when an error handler returns, so this one does not.
[[noreturn]] void throw_error(int number, const char* format, va_list arguments) {
  std::array<char, 256> text{};
  (void)std::vsnprintf(text.data(), text.size(), format, arguments);
  throw std::runtime_error("ODE error " + std::to_string(number) + ": " + text.data());
}

}  // extern "C"

/// ODE, from its first use to the end of the process.
class Library {
 public:
  Library() {
    if (dInitODE2(0) == 0) {
      throw std::runtime_error("ODE does not start: dInitODE2 failed");
    }
    dSetMessageHandler(drop_message);
    dSetErrorHandler(throw_error);
    dSetDebugHandler(throw_error);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { dCloseODE(); }
};

}  // namespace

void use_library() {
  static const Library library;
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
}

std::string precision() {
  return dCheckConfiguration("ODE_double_precision") != 0 ? "float64" : "float32";
}

}  // namespace tautline::ode
