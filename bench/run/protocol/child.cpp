#include "bench/run/protocol/child.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/base/text.hpp"
#include "bench/run/protocol/messages.hpp"

namespace tautline::bench {
namespace {

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
