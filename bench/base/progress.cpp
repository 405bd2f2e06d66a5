#include "bench/base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace tautline::bench {

Progress::Progress(std::size_t total, std::string what)
    : total_(total), what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) == 1) {
  show(0);
}

void Progress::show(std::size_t done) {
  const int percent = total_ == 0 ? 100 : static_cast<int>(100 * done / total_);
  if (!terminal_ || percent == shown_) {
    return;
  }
  shown_ = percent;
  constexpr int width = 40;  // [characters]
  const auto filled = static_cast<std::size_t>(percent * width / 100);
  fmt::print(stderr, "\r[{}{}] {:3d} %, {} of {} {}", std::string(filled, '#'),
             std::string(width - filled, '.'), percent, done, total_, what_);
  std::fflush(stderr);
}

void Progress::finish() {
  if (terminal_) {
    fmt::print(stderr, "\r\033[K");  // back to the start of the line and clear it
    std::fflush(stderr);
  }
}

}  // namespace tautline::bench
