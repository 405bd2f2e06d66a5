#pragma once

#include <Eigen/Core>

#include "tautline/engine.hpp"

// A plug-in is a shared module that exports three C functions; TAUTLINE_PLUGIN writes them. The
// program compares the interface text before it calls anything else, so a module built against
// another interface, compiler ABI or Eigen is refused with a sentence instead of crashing.

#define TAUTLINE_TEXT_OF(x) #x
#define TAUTLINE_TEXT(x) TAUTLINE_TEXT_OF(x)

/// Raised with every change of engine.hpp, case.hpp, system.hpp or solution.hpp that an older
/// plug-in would not fit. What is only added, such as TensionImpulses, fits.
#define TAUTLINE_INTERFACE_VERSION 7

/// What a plug-in must have been built against, as text.
#define TAUTLINE_INTERFACE \
  "tautline-engine " TAUTLINE_TEXT(TAUTLINE_INTERFACE_VERSION)                        \
  ", C++ ABI " TAUTLINE_TEXT(__GXX_ABI_VERSION) ", std::string ABI " TAUTLINE_TEXT(   \
      _GLIBCXX_USE_CXX11_ABI) ", Eigen " TAUTLINE_TEXT(EIGEN_WORLD_VERSION) "."       \
  TAUTLINE_TEXT(EIGEN_MAJOR_VERSION) ", alignment " TAUTLINE_TEXT(EIGEN_MAX_STATIC_ALIGN_BYTES)

#define TAUTLINE_EXPORT extern "C" __attribute__((visibility("default")))

/// Put once, outside any namespace, in a plug-in: TAUTLINE_PLUGIN(MyEngine). `EngineType` derives
/// from tautline::Engine and has a default constructor.
#define TAUTLINE_PLUGIN(EngineType)                                                       \
  TAUTLINE_EXPORT const char* tautline_plugin_interface() { return TAUTLINE_INTERFACE; }  \
  TAUTLINE_EXPORT tautline::Engine* tautline_plugin_create() { return new EngineType(); } \
  TAUTLINE_EXPORT void tautline_plugin_destroy(tautline::Engine* engine) { delete engine; }
