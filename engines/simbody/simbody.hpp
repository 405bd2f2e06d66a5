#pragma once

// Simbody 3.7 with its headers made fit for C++20. Include this, never Simbody.h.

namespace SimTK {

/// Simbody's index types compare with every integer type and convert to int. C++20 also tries each
/// comparison in reverse, so that comparing two of them is ambiguous; this one is a better match.
template <class Index>
requires requires(const Index& index) {
  index.isValidExtended();
  static_cast<int>(index);
}
constexpr bool operator==(const Index& a, const Index& b) {
  return static_cast<int>(a) == static_cast<int>(b);
}

}  // namespace SimTK

// Its header needs the size of a type that it only declares, where vector is constexpr. Nothing
// here needs it.
#define SimTK_SIMMATH_MULTIBODY_GRAPH_MAKER_H_
#include <Simbody.h>
