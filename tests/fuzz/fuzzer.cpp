// Makes a target a program of libFuzzer, which brings main() and calls it with one input after the
// other. An exception of the target ends the program, and libFuzzer keeps the input.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // libFuzzer has bytes, the targets read text
  tautline::fuzz::TAUTLINE_TARGET({reinterpret_cast<const char*>(data), size});  // NOLINT
  return 0;
}
