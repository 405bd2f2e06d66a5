#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <ctime>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/base/descriptor.hpp"

namespace tautline::bench {

/// Two ends: to read, and to write. Throws std::system_error.
[[nodiscard]] std::pair<Descriptor, Descriptor> make_pipe();

/// Two ends of a socket, of such a `type` as SOCK_STREAM: what is said at one is heard at the
/// other. Throws std::system_error.
[[nodiscard]] std::pair<Descriptor, Descriptor> make_socket(int type);

/// A nameless and empty file in memory, so that a full disk cannot stop a run. Throws
/// std::system_error.
[[nodiscard]] Descriptor memory_file();

/// Puts `content` into such a file in place of what is there. Throws std::system_error.
void fill(const Descriptor& file, std::string_view content);

/// Everything in such a file. Throws std::system_error.
[[nodiscard]] std::string content_of(const Descriptor& file);

/// How a child process ended, or came to an answer.
struct ProcessEnd {
  enum class Kind { exited, signalled, timed_out, interrupted, answered };
  Kind kind = Kind::exited;
  int code = 0;             // exit code, or signal number
  std::string output_tail;  // the last of what it printed on stdout and stderr
  std::size_t printed = 0;  // [bytes], all it printed
};

/// From here on the C library, where it can, gives freed memory back to the system in pieces of
/// 32 MiB alone: what a chunk of work needs the next one needs too, and new pages cost a part of
/// it.
void keep_freed_memory();

/// From here on Ctrl-C and a polite kill set `interruption` instead of ending the program; a second
/// one ends it at once.
void catch_interruption();

/// Set by a signal handler to make every `Process::wait` end its child and return.
[[nodiscard]] std::atomic<bool>& interruption();

/// A child process in a group of its own, its output captured. It and its group are gone when this
/// is.
class Process {
 public:
  /// Starts `arguments` (the first is the program) with `input` as its descriptor 0, `result` as 3
  /// and `turn`, one end of a socket, as 4. Throws std::system_error if it cannot be started.
  Process(const std::vector<std::string>& arguments, const Descriptor& input,
          const Descriptor& result, const Descriptor& turn);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  /// Captures output until it ends, or until a byte comes from `turn`, the other end of the socket;
  /// it then goes on. Killed after `time_limit` [s], or when the program is interrupted.
  [[nodiscard]] ProcessEnd wait(const Descriptor& turn, double time_limit);

 private:
  [[nodiscard]] ProcessEnd::Kind watch(int turn, double time_limit, ProcessEnd& end);
  void drain(ProcessEnd& end);  // what it has printed by now
  int end();                    // of all; the status with which it ended

  Descriptor output_;   // closed at its end
  pid_t process_ = -1;  // -1 once it is reaped
};

/// The words of a command as exec takes them; good as long as `words`.
[[nodiscard]] std::vector<char*> exec_words(const std::vector<std::string>& words);

/// From here on this process may take so much address space [bytes], or the most that it may ask
/// for if that is less. That most stays.
void limit_address_space(std::size_t memory);

/// The processes that `root` started, and those that they started, living or not yet reaped. One
/// whose parent died belongs to who took it in: `root`, where that is a subreaper.
[[nodiscard]] std::vector<pid_t> descendants_of(pid_t root);

/// What these processes hold in memory [bytes]; pages that several share count for each.
[[nodiscard]] double resident_memory(const std::vector<pid_t>& processes);

/// The most memory that a process has held at once [bytes], what it was before an exec apart; 0 if
/// it is gone.
[[nodiscard]] double peak_memory_of(pid_t process);
[[nodiscard]] double peak_memory();  // of this one

/// From here on `peak_memory_of` is the most that it holds from here on.
void forget_peak_memory_of(pid_t process);

/// What a clock shows [s]; 0 if it is gone.
[[nodiscard]] double clock_time(clockid_t clock);

/// Processor time that a process has used [s]; 0 if it is gone.
[[nodiscard]] double processor_time_of(pid_t process);

/// Ends every descendant of this process, which is a subreaper, and reaps those that are its
/// children. What cannot be ended within some seconds is given up.
void end_descendants();

/// "SIGSEGV" and its like; "signal 42" for one without a name.
[[nodiscard]] std::string signal_name(int signal);

}  // namespace tautline::bench
