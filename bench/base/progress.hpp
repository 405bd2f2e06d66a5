#pragma once

#include <cstddef>
#include <string>

namespace tautline::bench {

/// A bar on standard error, drawn only if that is a terminal.
class Progress {
 public:
  Progress(std::size_t total, std::string what);

  /// `done` of the total are done.
  void show(std::size_t done);

  /// Removes the bar.
  void finish();

 private:
  std::size_t total_;
  std::string what_;
  bool terminal_;
  int shown_ = -1;  // the last percentage drawn
};

}  // namespace tautline::bench
