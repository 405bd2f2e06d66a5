#include "bench/run/protocol/keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <limits>

#include "bench/base/process.hpp"

namespace tautline::bench {
namespace {

constexpr int look_again = 10;  // [ms]: memory is filled at some gigabytes a second

/// Each so many looks the processes are counted anew, which costs more than to look at them.
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

}  // namespace

void keep(const KeptCommand& command, int input, int output, int life) {
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

}  // namespace tautline::bench
