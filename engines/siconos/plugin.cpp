// Siconos: nonsmooth dynamics, with the theory of impacts in its classes.

#include "tautline/plugin.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <system_error>

#include <NumericsVerbose.h>

#include "models.hpp"

namespace tautline::siconos_engine {
namespace {

/// No function of the library tells a release. The file it was loaded from ends in its number, as
/// in libsiconos_numerics.so.7.0.0.
std::string library_version() {
  const std::string before_number = ".so.";
  Dl_info found{};
  if (::dladdr(reinterpret_cast<const void*>(&numerics_set_verbose), &found) != 0) {
    std::error_code error;
    const std::string name = std::filesystem::canonical(found.dli_fname, error).filename();
    if (const auto position = name.find(before_number); position != std::string::npos) {
      return "library " + name.substr(position + before_number.size());
    }
  }
  return "unknown";
}

EngineTable table() {
  return {.name = "siconos",
          .version = library_version(),
          .precision = precision_of<double>,
          .families = {moreau_jean_models(), event_driven_models()},
          .dimensions = 3};
}

}  // namespace
}  // namespace tautline::siconos_engine

TAUTLINE_PLUGIN(tautline::EngineOf<tautline::siconos_engine::table>)
