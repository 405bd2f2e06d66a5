#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace tautline::bench {

/// Where progress is shown, and by which clock.
struct ProgressScreen {
  bool terminal = false;   // one line that is drawn again and again; else a line now and then
  std::size_t width = 80;  // [columns], of a terminal
  std::function<void(std::string_view)> write;
  std::function<double()> clock;  // [s], never back
};

/// Standard error, and a clock that runs.
[[nodiscard]] ProgressScreen error_screen();

/// How much of some work is done and how long the rest will take, judged by what the work that is
/// done took.
class Progress {
 public:
  /// `count` pieces, "runs", that make `work` together, in any unit.
  Progress(double work, std::size_t count, std::string what,
           ProgressScreen screen = error_screen());

  /// Says from now on how many pieces end in a second, too: for work in which they are many.
  void show_rate() { rate_ = true; }

  /// One piece, of so much work, has ended. A `kept` one was done before, and says nothing of how
  /// long the others take.
  void ended(double work, bool kept = false);

  /// Removes the line from a terminal.
  void finish();

 private:
  void show(double now);
  [[nodiscard]] std::string pace(double now) const;
  [[nodiscard]] std::string terminal_line(double now) const;

  double work_;
  std::size_t count_;
  std::string what_;
  ProgressScreen screen_;
  double started_;     // [s]
  double shown_;       // [s], when a line was last written
  double done_ = 0.0;  // of `work_`
  double kept_ = 0.0;  // of `done_`
  std::size_t ended_ = 0;
  std::size_t kept_count_ = 0;  // of `ended_`
  bool rate_ = false;
};

/// "40 s", "12 min", "3 h 20 min": as exact as an estimate is.
[[nodiscard]] std::string rough_duration(double seconds);

}  // namespace tautline::bench
