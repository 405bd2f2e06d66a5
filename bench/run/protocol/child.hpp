#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bench/base/descriptor.hpp"

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

/// An engine's own process, which reads lines and answers with lines. Gone when this is.
class Child {
 public:
  /// Starts it. Throws std::system_error where there are no more processes or pipes; that the
  /// command cannot be started is seen by the first answer.
  explicit Child(const KeptCommand& command);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// Sends a line and waits for the one that answers it; the text is good until the next call.
  /// `method` is what is asked. Throws EngineEnded where it ends before, ProtocolError where no
  /// line ends.
  [[nodiscard]] std::string_view ask(std::string_view line, std::string_view method);

  [[nodiscard]] pid_t process() const { return process_; }  // 0 if it could not be started

 private:
  void send(std::string_view line, std::string_view method);
  [[noreturn]] void fail(std::string_view method);
  [[nodiscard]] KeeperReport next_report(int milliseconds);
  [[nodiscard]] std::string how_it_ended();

  std::size_t memory_;   // [bytes], that it may hold
  std::string command_;  // its first word
  Descriptor input_;     // of the child
  Descriptor output_;
  Descriptor life_;  // of its keeper
  pid_t keeper_ = -1;
  KeeperReport first_;
  pid_t process_ = 0;
  std::string text_;      // what the child wrote, from the latest line on
  std::size_t used_ = 0;  // of it, by the latest line
};

}  // namespace tautline::bench
