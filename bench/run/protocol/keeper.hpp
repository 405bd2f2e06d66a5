#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tautline::bench {

/// What a keeper starts.
struct KeptCommand {
  std::vector<std::string> command;  // the first word is looked up on PATH
  std::string folder;                // in which it runs
  std::size_t memory = 0;            // [bytes], the most that it and all it starts may hold
};

/// What a keeper says of its command, as bytes in a socket: that it runs, and how it ended. One
/// that says nothing is silent.
struct KeeperReport {
  enum class Kind { silent, started, not_started, exited, signalled, ate_memory };
  Kind kind = Kind::silent;
  int number = 0;      // process id, errno, exit code or signal
  double bytes = 0.0;  // that were held, where these were too many
};

/// A keeper stands between a worker and an engine's own process. It lives until that process or
/// `life` ends, and with it ends everything that the engine started, also what has made itself a
/// session or lost its parent. A worker could not do that: it may be killed at any time.
/// Memory is what all of them hold, looked at again and again: a limit on address space would
/// forbid WebAssembly, which reserves gigabytes that it does not use, and the limits that the
/// system has count for each process by itself.
///
/// To be called in a forked process: `input` and `output` become the command's standard input and
/// output, its standard error is that of the caller. `life` is one end of a socket; reports go into
/// it, and when the other end closes, nobody needs the command any more.
[[noreturn]] void keep(const KeptCommand& command, int input, int output, int life);

}  // namespace tautline::bench
