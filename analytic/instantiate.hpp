#pragma once

// The sources of this folder are compiled once for each scalar: for double here, and for numbers of
// any length in multiprecision/. Each ends with explicit instantiations for `Instance`, or for the
// cases of it.

#ifdef TAUTLINE_MULTIPRECISION
#include "tautline/multiprecision.hpp"
namespace tautline {
using Instance = Multi;
}
#else
namespace tautline {
using Instance = double;
}
#endif

namespace tautline {
template <class Real>
struct BasicCase;
using InstanceCase = BasicCase<Instance>;
}  // namespace tautline
