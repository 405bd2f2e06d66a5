// A plug-in of an interface that is not ours, with nothing in it that can be called.

#include <cstdlib>

extern "C" {

__attribute__((visibility("default"))) const char* tautline_plugin_interface() {
  return "tautline-engine 0, C++ ABI 1";
}

__attribute__((visibility("default"))) void* tautline_plugin_create() { std::abort(); }

__attribute__((visibility("default"))) void tautline_plugin_destroy(void*) { std::abort(); }

}  // extern "C"
