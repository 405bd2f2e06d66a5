#pragma once

#include <cstdio>
#include <ios>
#include <streambuf>

namespace tautline::simbody {

/// While one of these lives, what this process prints through `std::cout` and C's `stdout` is
/// dropped. The file descriptor stays as it is: only the two streams, which Simbody's library
/// shares with the program, are pointed elsewhere. For the time of a step; not for several threads
/// that print.
class Quiet {
 public:
  Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  ~Quiet();

 private:
  std::streambuf* buffer_;
  std::ios_base::iostate condition_;
  std::FILE* output_;
};

}  // namespace tautline::simbody
