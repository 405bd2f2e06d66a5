#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/base/descriptor.hpp"

namespace tautline::bench {

/// A nameless file in memory, so that a full disk cannot stop a run. Throws std::system_error.
[[nodiscard]] Descriptor memory_file(std::string_view content);

/// Everything in such a file. Throws std::system_error.
[[nodiscard]] std::string content_of(const Descriptor& file);

/// How a child process ended.
struct ProcessEnd {
  enum class Kind { exited, signalled, timed_out, interrupted };
  Kind kind = Kind::exited;
  int code = 0;             // exit code, or signal number
  std::string output_tail;  // the last of what it printed on stdout and stderr
  std::size_t printed = 0;  // [bytes], all it printed
};

/// From here on Ctrl-C and a polite kill set `interruption` instead of ending the program; a second
/// one ends it at once.
void catch_interruption();

/// Set by a signal handler to make every `run_process` end its child and return.
[[nodiscard]] std::atomic<bool>& interruption();

/// Runs `arguments` (the first is the program) with `input` as its descriptor 0, `result` as its
/// descriptor 3 and its output captured; kills it and its children after `time_limit` [s].
/// Throws std::system_error if it cannot be started.
[[nodiscard]] ProcessEnd run_process(const std::vector<std::string>& arguments,
                                     const Descriptor& input, const Descriptor& result,
                                     double time_limit);

/// The most memory this process has held at once [bytes]; what it was before an exec does not
/// count.
[[nodiscard]] double peak_memory();

/// "SIGSEGV" and its like; "signal 42" for one without a name.
[[nodiscard]] std::string signal_name(int signal);

}  // namespace tautline::bench
