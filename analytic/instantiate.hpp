#pragma once

// The sources of this folder are compiled once for each scalar: for double here, and for numbers of
// any length in multiprecision/. Each ends with explicit instantiations for `Instance`, or for the
// cases of it. Those that serve every kind of case are compiled for systems, too, in the plane and
// in space, each apart: what a compiler inlines depends on all that a source has.

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

#if !defined(TAUTLINE_MULTIPRECISION) && !defined(TAUTLINE_SYSTEM)
#define TAUTLINE_FIRST  // of all: what is no template is compiled then
#endif

#ifdef TAUTLINE_SYSTEM  // 2 or 3, its dimension; the build includes system/kernel.hpp first
namespace tautline {
template <class Real, int D>
struct BasicSystem;
inline constexpr int instance_dimension = TAUTLINE_SYSTEM;
using InstanceCase = BasicSystem<Instance, instance_dimension>;
}  // namespace tautline
#else
namespace tautline {
template <class Real>
struct BasicCase;
using InstanceCase = BasicCase<Instance>;
}  // namespace tautline
#endif
