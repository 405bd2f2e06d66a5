#include "bench/base/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

namespace tautline::bench {
namespace {

constexpr double between_frames = 0.1;   // [s], of a terminal: more often no one can read
constexpr double between_lines = 15.0;   // [s], of a pipe: a log of an hour has 240
constexpr double before_estimate = 2.0;  // [s]: earlier the first pieces say little
constexpr std::size_t least_bar = 10;    // [columns]: a narrower terminal gets no bar
constexpr std::size_t longest_bar = 40;  // [columns]

constexpr double minute = 60.0;       // [s]
constexpr double hour = 60 * minute;  // [s]

/// Of a terminal at standard error [columns].
std::size_t error_width() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : ProgressScreen().width;
}

}  // namespace

ProgressScreen error_screen() {
  ProgressScreen screen;
  screen.terminal = ::isatty(STDERR_FILENO) == 1;
  screen.width = error_width();
  screen.write = [](std::string_view text) {
    // without exceptions: what is computed counts more than what is shown of it
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
    static_cast<void>(std::fflush(stderr));
  };
  screen.clock = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  return screen;
}

Progress::Progress(double work, std::size_t count, std::string what, ProgressScreen screen)
    : work_(work),
      count_(count),
      what_(std::move(what)),
      screen_(std::move(screen)),
      started_(screen_.clock()),
      shown_(started_) {
  if (screen_.terminal) {
    show(started_);
  }
}

void Progress::ended(double work, bool kept) {
  done_ += work;
  kept_ += kept ? work : 0.0;
  kept_count_ += kept ? 1U : 0U;
  ++ended_;
  const double now = screen_.clock();
  const bool last = ended_ == count_;
  if (screen_.terminal ? now - shown_ >= between_frames || last
                       : now - shown_ >= between_lines && !last) {
    show(now);
  }
}

void Progress::finish() {
  if (screen_.terminal) {
    screen_.write("\r\033[K");  // back to the start of the line and clear it
  }
}

std::string Progress::pace(double now) const {
  const double elapsed = now - started_;
  const double paced = done_ - kept_;  // the work that took `elapsed`
  if (elapsed < before_estimate || paced <= 0.0 || ended_ == count_) {
    return "";
  }
  const auto pieces = static_cast<double>(ended_ - kept_count_);
  return (rate_ ? fmt::format(", {:.3g} a second", pieces / elapsed) : "") + ", about " +
         rough_duration((work_ - done_) / paced * elapsed) + " left";
}

std::string Progress::terminal_line(double now) const {
  const double share = work_ > 0.0 ? std::min(1.0, done_ / work_) : 1.0;
  const std::string text = fmt::format("{:3.0f} %, {} of {} {}{}", std::floor(100 * share), ended_,
                                       count_, what_, pace(now));
  constexpr std::size_t around = 4;  // [columns], the brackets, a blank, and the last one
  const std::size_t room = screen_.width - std::min(screen_.width, text.size() + around);
  if (room < least_bar) {
    return text.substr(0, screen_.width - std::min<std::size_t>(screen_.width, 1));
  }
  const std::size_t bar = std::min(room, longest_bar);
  const auto filled = static_cast<std::size_t>(share * static_cast<double>(bar));
  return "[" + std::string(filled, '#') + std::string(bar - filled, '.') + "] " + text;
}

void Progress::show(double now) {
  shown_ = now;
  if (screen_.terminal) {
    screen_.write("\r" + terminal_line(now) + "\033[K");
  } else {
    screen_.write(fmt::format("{} of {} {}{}\n", ended_, count_, what_, pace(now)));
  }
}

std::string rough_duration(double seconds) {
  if (seconds < 1.5 * minute) {
    return fmt::format("{:.0f} s", std::ceil(seconds));
  }
  if (seconds < 1.5 * hour) {
    return fmt::format("{:.0f} min", seconds / minute);
  }
  const double minutes = std::round(seconds / minute);
  return fmt::format("{:.0f} h {:02.0f} min", std::floor(minutes / 60), std::fmod(minutes, 60));
}

}  // namespace tautline::bench
