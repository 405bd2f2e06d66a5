#pragma once

// The sources of this folder are compiled once for each scalar: for double here, and for numbers of
// any length in multiprecision/. Each ends with explicit instantiations for `Instance`, or for the
// cases of it. Those that serve every kind of case are compiled for systems, too, each apart: what
// a compiler inlines depends on all that a source has.

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

#ifdef TAUTLINE_SYSTEM  // the build includes system/kernel.hpp first
namespace tautline {
template <class Real, int D>
struct BasicSystem;
using InstanceCase = BasicSystem<Instance, 2>;
}  // namespace tautline
#else
namespace tautline {
template <class Real>
struct BasicCase;
using InstanceCase = BasicCase<Instance>;
}  // namespace tautline
#endif
