#include "quiet.hpp"

#include <iostream>

namespace tautline::simbody {
namespace {

/// Opened once and never closed: there is nothing in it to lose. Null where it cannot be opened.
std::FILE* nowhere() {
  static std::FILE* const file = std::fopen("/dev/null", "we");
  return file;
}

}  // namespace

// Without a buffer std::cout is bad, and a bad stream formats nothing, which is most of the time a
// print takes. glibc lets a program assign to stdout ("Standard Streams" in its manual).
Quiet::Quiet() : buffer_(std::cout.rdbuf()), condition_(std::cout.rdstate()), output_(stdout) {
  std::cout.rdbuf(nullptr);
#ifdef __GLIBC__
  if (nowhere() != nullptr) {
    stdout = nowhere();
  }
#endif
}

Quiet::~Quiet() {
#ifdef __GLIBC__
  stdout = output_;
#endif
  std::cout.rdbuf(buffer_);
  std::cout.clear(condition_);
}

}  // namespace tautline::simbody
