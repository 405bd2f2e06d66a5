// Loads a plug-in as the program does, and asks it for one step.

#include <dlfcn.h>

#include <cstdio>
#include <cstring>

#include "tautline/plugin.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::printf("usage: load_plugin FILE\n");
    return 2;
  }
  void* const module = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) {
    std::printf("%s\n", dlerror());
    return 1;
  }
  const auto interface =
      reinterpret_cast<const char* (*)()>(dlsym(module, "tautline_plugin_interface"));
  const auto create =
      reinterpret_cast<tautline::Engine* (*)()>(dlsym(module, "tautline_plugin_create"));
  const auto destroy =
      reinterpret_cast<void (*)(tautline::Engine*)>(dlsym(module, "tautline_plugin_destroy"));
  if (interface == nullptr || create == nullptr || destroy == nullptr) {
    std::printf("a function of the plug-in is missing\n");
    return 1;
  }
  if (std::strcmp(interface(), TAUTLINE_INTERFACE) != 0) {
    std::printf("interface is %s, expected %s\n", interface(), TAUTLINE_INTERFACE);
    return 1;
  }

  tautline::Engine* const engine = create();
  const auto info = engine->info();
  tautline::Case the_case;
  the_case.cables.resize(2);
  bool fits = false;
  {
    const auto simulation = engine->start(the_case, info.models.front().name, 0.01);
    simulation->step(0.01);
    fits = simulation->impulses().size() == the_case.cables.size();
  }
  destroy(engine);
  std::printf("engine %s: %s\n", info.name.c_str(), fits ? "fits" : "one impulse per cable wanted");
  return fits ? 0 : 1;
}
