#pragma once

#include <sys/types.h>

#include <vector>

namespace tautline::bench {

/// The processes that `root` started, and those that they started, living or not yet reaped. One
/// whose parent died belongs to who took it in: `root`, where that is a subreaper.
[[nodiscard]] std::vector<pid_t> descendants_of(pid_t root);

/// What these processes hold in memory [bytes]; pages that several share count for each.
[[nodiscard]] double resident_memory(const std::vector<pid_t>& processes);

/// The most memory that a process has held at once [bytes]; 0 if it is gone.
[[nodiscard]] double peak_memory_of(pid_t process);

/// From here on `peak_memory_of` is the most that it holds from here on.
void forget_peak_memory_of(pid_t process);

/// Processor time that a process has used [s]; 0 if it is gone.
[[nodiscard]] double processor_time_of(pid_t process);

/// Ends every descendant of this process, which is a subreaper, and reaps those that are its
/// children. What cannot be ended within some seconds is given up.
void end_descendants();

}  // namespace tautline::bench
