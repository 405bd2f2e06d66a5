#include "library.hpp"

#include <mujoco/mujoco.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace tautline::mujoco {
namespace {

std::string& latest_warning() {
  thread_local std::string text;
  return text;
}

/// MuJoCo ends the process when an error handler returns, so this one does not.
[[noreturn]] void throw_error(const char* text) {
  throw std::runtime_error(std::string("MuJoCo error: ") + text);
}

void keep_warning(const char* text) { latest_warning() = text; }

}  // namespace

void use_library() {
  mju_user_error = throw_error;
  mju_user_warning = keep_warning;
}

void throw_warning() {
  if (!latest_warning().empty()) {
    throw std::runtime_error("MuJoCo warning: " + std::exchange(latest_warning(), {}));
  }
}

}  // namespace tautline::mujoco
