#include "bench/run/protocol/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <limits>
#include <system_error>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/base/text.hpp"
#include "bench/run/protocol/messages.hpp"

namespace tautline::bench {
namespace {

constexpr int look_again = 10;  // [ms]: memory is filled at some gigabytes a second

/// Each so many looks the processes are counted again, which costs more than to look at them.
constexpr int looks_per_count = 10;

void report(int life, const KeeperReport& what) {
  (void)::send(life, &what, sizeof(what), MSG_NOSIGNAL);
}

/// Turns this process into the command; returns the reason, an errno, where that fails.
int become(const KeptCommand& command, int input, int output, pid_t keeper) {
  ::setsid();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != keeper) {
    ::_exit(1);  // it died before it was asked to say so
  }
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGXFSZ}) {
    std::signal(signal, SIG_DFL);
  }
  if (::chdir(command.folder.c_str()) != 0) {
    return errno;
  }
  const std::vector<char*> arguments = exec_words(command.command);
  ::execvp(arguments.front(), arguments.data());
  return errno;
}

/// Starts the command; its process, or -1 once the reason is reported.
pid_t start(const KeptCommand& command, int input, int output, int life) {
  const pid_t keeper = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) {
    // nothing but 0, 1 and 2 outlives an exec
    report(life, {KeeperReport::Kind::not_started, become(command, input, output, keeper)});
    ::_exit(127);
  }
  if (child < 0) {
    report(life, {KeeperReport::Kind::not_started, errno});
  }
  return child;
}

KeeperReport end_report(int status) {
  if (WIFSIGNALED(status)) {
    return {KeeperReport::Kind::signalled, WTERMSIG(status)};
  }
  return {KeeperReport::Kind::exited, WEXITSTATUS(status)};
}

/// True if nobody holds the other end any more.
bool is_over(int life, int milliseconds) {
  pollfd watched{life, POLLIN, 0};
  return ::poll(&watched, 1, milliseconds) > 0;
}

/// Until the command or `life` ends, or memory is short.
void watch(pid_t child, std::size_t memory, int life) {
  std::vector<pid_t> processes;
  for (int look = 0; !is_over(life, look_again); ++look) {
    int status = 0;
    while (const pid_t ended = ::waitpid(-1, &status, WNOHANG)) {
      if (ended == child) {
        return report(life, end_report(status));
      }  // else one whose parent died
    }
    if (look % looks_per_count == 0) {
      processes = descendants_of(::getpid());
    }
    if (const double held = resident_memory(processes); held > static_cast<double>(memory)) {
      return report(life, {KeeperReport::Kind::ate_memory, 0, held});
    }
  }
}

/// Closes all descriptors but these: what the worker holds of another command must not be held
/// here.
void keep_open(std::array<int, 4> descriptors) {
  std::sort(descriptors.begin(), descriptors.end());
  unsigned first = 0;
  for (const int descriptor : descriptors) {
    const auto number = static_cast<unsigned>(descriptor);
    if (number > first) {
      ::close_range(first, number - 1, 0);
    }
    first = number + 1;
  }
  ::close_range(first, ~0U, 0);
}

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
[[noreturn]] void keep(const KeptCommand& command, int input, int output, int life) {
  keep_open({STDERR_FILENO, input, output, life});
  ::setpgid(0, 0);  // a kill of the worker's group must leave it
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  limit_address_space(std::numeric_limits<std::size_t>::max());  // which the worker may not have
  const pid_t child = start(command, input, output, life);
  if (child > 0) {
    report(life, {KeeperReport::Kind::started, static_cast<int>(child)});
    ::close(input);
    ::close(output);
    watch(child, command.memory, life);
  }
  end_descendants();
  ::_exit(0);
}

/// The longest line that a child may write [bytes]. A hundred steps of the largest case take an
/// eighth of it.
constexpr std::size_t longest_line = std::size_t{1} << 20U;

/// A child whose standard input has ended may take this long to end [ms]; then it is killed.
constexpr int grace = 500;

/// A keeper says within this time how its command ended, also on a busy machine [ms].
constexpr int report_delay = 10'000;
constexpr int forever = -1;  // until the keeper says something, or is gone

constexpr std::size_t written_excerpt = 40;  // [bytes] of what a child wrote, in a sentence

}  // namespace

Child::Child(const KeptCommand& command)
    : memory_(command.memory), command_(command.command.front()) {
  std::signal(SIGPIPE, SIG_IGN);  // a child that has ended is a failed write, not the end
  auto [its_input, our_output] = make_pipe();
  auto [our_input, its_output] = make_pipe();
  auto [our_life, its_life] = make_socket(SOCK_SEQPACKET);
  keeper_ = ::fork();
  if (keeper_ == 0) {
    keep(command, its_input.get(), its_output.get(), its_life.get());
  }
  if (keeper_ < 0) {
    throw std::system_error(errno, std::generic_category(), "cannot start a process");
  }
  input_ = std::move(our_output);
  output_ = std::move(our_input);
  life_ = std::move(our_life);
  its_life.close();  // so that a keeper's end is seen
  first_ = next_report(forever);
  process_ = first_.kind == KeeperReport::Kind::started ? first_.number : 0;
}

Child::~Child() {
  input_.close();
  static_cast<void>(next_report(grace));
  life_.close();
  ::waitpid(keeper_, nullptr, 0);
}

void Child::send(std::string_view line, std::string_view method) {
  std::string bytes(line);
  bytes += '\n';
  if (write_all(input_.get(), bytes) != 0) {
    fail(method);
  }
}

std::string_view Child::ask(std::string_view line, std::string_view method) {
  send(line, method);
  text_.erase(0, std::exchange(used_, 0));
  std::array<char, 1 << 16> buffer{};
  for (std::size_t seen = 0;;) {
    if (const std::size_t end = text_.find('\n', seen); end != std::string::npos) {
      used_ = end + 1;
      return std::string_view(text_).substr(0, end);
    }
    seen = text_.size();
    if (seen > longest_line) {
      throw ProtocolError(fmt::format(
          "the engine wrote a line of more than {} bytes where an answer to {} was due: {}",
          longest_line, method, printable(text_, written_excerpt)));
    }
    const ssize_t size = ::read(output_.get(), buffer.data(), buffer.size());
    if (size > 0) {
      text_.append(buffer.data(), static_cast<std::size_t>(size));
    } else if (size == 0 || errno != EINTR) {
      fail(method);
    }
  }
}

void Child::fail(std::string_view method) {
  const std::string half = text_.empty() ? ""
                                         : fmt::format(" in the middle of a line: {}",
                                                       printable(text_, written_excerpt));
  throw EngineEnded(fmt::format("{} before it answered {}{}", how_it_ended(), method, half));
}

KeeperReport Child::next_report(int milliseconds) {
  KeeperReport report;
  pollfd watched{life_.get(), POLLIN, 0};
  const bool whole = ::poll(&watched, 1, milliseconds) > 0 &&
                     ::recv(life_.get(), &report, sizeof(report), 0) == sizeof(report);
  return whole ? report : KeeperReport{KeeperReport::Kind::silent};
}

std::string Child::how_it_ended() {
  using Kind = KeeperReport::Kind;
  constexpr double mebi = 1024.0 * 1024.0;
  for (KeeperReport report = first_;; report = next_report(report_delay)) {
    switch (report.kind) {
      case Kind::started:
        continue;
      case Kind::not_started:
        return fmt::format("the engine could not be started ({}: {})", printable(command_),
                           std::strerror(report.number));
      case Kind::exited:
        return fmt::format("the engine ended by itself with exit code {}", report.number);
      case Kind::signalled:
        return "the engine crashed: " + signal_name(report.number);
      case Kind::ate_memory:
        return fmt::format("ran out of memory: the engine held {:.0f} MiB, {:.0f} MiB at most",
                           report.bytes / mebi, static_cast<double>(memory_) / mebi);
      case Kind::silent:
        return "the engine closed its standard output";
    }
  }
}

}  // namespace tautline::bench
