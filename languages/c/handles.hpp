#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"
#include "tautline/tautline.h"
#include "tautline/uncertainty.hpp"

// The two opaque types of the C interface, and what all its functions share: how they meet memory
// that is missing, structs of other versions, and counts.

/// A case, or what is wrong with it.
struct tautline_case {
  tautline::Case the_case;  // without problems exactly when `problems` is empty
  std::string problems;     // sentences, one a line
  std::string notes;        // sentences, one a line
};

/// A motion, and the bounds of its errors as soon as somebody has asked for them.
struct tautline_motion {
  tautline::Case the_case;
  tautline::SolveOptions options;
  tautline::Solution solution;
  mutable std::atomic<const tautline::Uncertainty*> bounds{nullptr};  // refer to the three above

  tautline_motion(const tautline::Case& which, const tautline::SolveOptions& how)
      : the_case(which), options(how), solution(tautline::solve(the_case, options)) {}
  tautline_motion(const tautline_motion&) = delete;
  tautline_motion& operator=(const tautline_motion&) = delete;
  ~tautline_motion() { delete bounds.load(); }

  /// Computes the bounds in the first call. Several threads at a time may compute the same ones;
  /// one of them is kept.
  [[nodiscard]] const tautline::Uncertainty& errors() const {
    const tautline::Uncertainty* known = bounds.load(std::memory_order_acquire);
    if (known == nullptr) {
      auto made = std::make_unique<const tautline::Uncertainty>(the_case, solution, options);
      if (bounds.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel)) {
        known = made.release();
      }
    }
    return *known;
  }
};

namespace tautline::c {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();
inline constexpr std::size_t coordinate_count = 6;  // of the only kind of case

/// The status of what `act` returns or throws. A program without exceptions ends where memory is
/// missing.
template <class Act>
std::int32_t guarded(const Act& act) noexcept {
#ifndef __cpp_exceptions
  return act();
#else
  try {
    return act();
  } catch (const std::bad_alloc&) {
    return TAUTLINE_OUT_OF_MEMORY;
  } catch (const std::length_error&) {  // larger than any memory
    return TAUTLINE_OUT_OF_MEMORY;
  } catch (...) {
    return TAUTLINE_BROKEN;
  }
#endif
}

/// The size of a struct in the first version of the library that had it [bytes]. A struct that has
/// grown gets a specialisation.
template <class Struct>
inline constexpr std::size_t first_size = sizeof(Struct);

/// No struct will ever be larger [bytes]: a larger `size` was never set.
inline constexpr std::size_t largest_size = 4096;

/// The `size` that a struct of the caller says it has [bytes]; 0 if it cannot be.
template <class Struct>
std::size_t size_of(const Struct* of_caller) {
  static_assert(std::is_trivially_copyable_v<Struct> && alignof(Struct) <= 8 &&
                sizeof(Struct) % 8 == 0);
  std::int32_t size = 0;
  std::memcpy(&size, of_caller, sizeof size);
  const auto bytes = static_cast<std::size_t>(std::max(size, 0));
  return bytes >= first_size<Struct> && bytes <= largest_size && bytes % 8 == 0 ? bytes : 0;
}

/// Copies a struct of `size` bytes that the caller has filled. False if it holds something that
/// this version does not know.
template <class Struct>
bool take(const void* from, std::size_t size, Struct& to) {
  const auto* bytes = static_cast<const unsigned char*>(from);
  const std::size_t known = std::min(size, sizeof(Struct));
  to = Struct{};
  std::memcpy(&to, from, known);
  return std::all_of(bytes + known, bytes + size, [](unsigned char byte) { return byte == 0; });
}

/// Fills a struct of `size` bytes that belongs to the caller.
template <class Struct>
void give(Struct value, void* to, std::size_t size) {
  value.size = static_cast<std::int32_t>(size);
  std::memset(to, 0, size);
  std::memcpy(to, &value, std::min(size, sizeof(Struct)));
}

/// The address of a struct in the caller's array that steps by `size` bytes.
template <class Struct>
auto* at(Struct* array, std::size_t index, std::size_t size) {
  using Bytes = std::conditional_t<std::is_const_v<Struct>, const unsigned char, unsigned char>;
  return reinterpret_cast<Bytes*>(array) + index * size;
}

/// True if an array of `count` rows of `width` doubles fits a memory.
inline bool fits_memory(std::size_t count, std::size_t width) {
  constexpr std::size_t most = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(double);
  return width == 0 || count <= most / width;
}

/// Writes `whole` to the caller's room, and returns its length.
inline std::size_t give_text(std::string_view whole, char* text, std::size_t room) {
  if (text != nullptr && room > 0) {
    const std::size_t length = std::min(whole.size(), room - 1);
    std::memcpy(text, whole.data(), length);
    text[length] = '\0';
  }
  return whole.size();
}

/// Writes a number to an output of the caller, unless that is null.
template <class Number>
void give_number(Number* to, std::type_identity_t<Number> value) {
  if (to != nullptr) {
    *to = value;
  }
}

/// A set of cables as bits.
inline std::int32_t bits(CableSet cables) {
  std::uint32_t result = 0;
  for (const std::size_t index : cables) {
    result |= std::uint32_t{1} << index;
  }
  return static_cast<std::int32_t>(result);
}

/// The numbers of a state in a row of the caller.
void give_state(const State& state, double* row);
/// A row of NaN.
void give_no_state(double* row);

/// The options of the caller, null for the defaults; returns a status.
std::int32_t take_options(const tautline_options* from, SolveOptions& to);

/// TAUTLINE_OK if each of `times` is in [0, end]; otherwise a status, and `wrong` gets its index.
std::int32_t check_times(const double* times, std::size_t count, double end, std::size_t* wrong);

/// A motion in short, and how it settles; `size` is left to `give`.
tautline_summary summary_of(const Case& the_case, const Solution& solution);
tautline_settling settling_of(const Case& the_case, const Solution& solution);

/// Sets several quantities of a case, the same for many cases.
class Variation {
 public:
  /// Returns a status; `wrong` gets the index of a name that is refused.
  std::int32_t read(const Case& base, const char* const* names, std::size_t count,
                    std::size_t* wrong);
  /// `the_case` is a copy of the base; `values` has one for each name.
  void apply(Case& the_case, const double* values) const;

 private:
  std::vector<std::string> names_;  // as bench::set_quantity knows them
};

/// What is wrong with a struct of the caller whose `size` is not right; `known` is its size here.
std::string wrong_size(const char* type, std::size_t known, const void* given);

/// Sentences, one a line.
std::string lines_of(const std::vector<std::string>& sentences);

}  // namespace tautline::c
