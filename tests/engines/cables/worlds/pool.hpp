// Runs many things in processes of their own: an engine that aborts takes one of them with it.

#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace tautline::test {

namespace detail {

constexpr unsigned time_limit = 600;  // [s] for one of them

/// Works off `left`, each on its turn, in `workers` processes; what ends in an abort stays empty,
/// and so does what its process had before it. Returns the numbers that were begun and not ended.
template <typename Result, typename Function>
std::vector<int> work_off(const std::vector<int>& left, int workers, const Function& function,
                          std::vector<std::optional<Result>>& results) {
  struct Message {
    int number;
    int is_done;
    Result result;
  };
  // so short that processes write to one pipe without mixing theirs up (PIPE_BUF of POSIX)
  static_assert(sizeof(Message) <= 512);
  static_assert(std::is_trivially_copyable_v<Result>);
  int ends[2];
  if (pipe(ends) != 0) {
    throw std::runtime_error("no pipe");
  }
  std::vector<pid_t> children;
  for (int worker = 0; worker < workers; ++worker) {
    const pid_t child = fork();
    if (child < 0) {
      throw std::runtime_error("no process");
    }
    if (child == 0) {
      close(ends[0]);
      for (std::size_t turn = static_cast<std::size_t>(worker); turn < left.size();
           turn += static_cast<std::size_t>(workers)) {
        Message message{left[turn], 0, {}};
        bool sent = write(ends[1], &message, sizeof message) == sizeof message;
        alarm(time_limit);  // ends the process
        message.result = function(left[turn]);
        message.is_done = 1;
        sent = sent && write(ends[1], &message, sizeof message) == sizeof message;
        if (!sent) {
          _exit(1);
        }
      }
      _exit(0);
    }
    children.push_back(child);
  }
  close(ends[1]);
  std::vector<int> begun;
  Message message;
  while (read(ends[0], &message, sizeof message) == sizeof message) {
    if (message.is_done == 0) {
      begun.push_back(message.number);
    } else {
      results[static_cast<std::size_t>(message.number)] = message.result;
      begun.erase(std::find(begun.begin(), begun.end(), message.number));
    }
  }
  close(ends[0]);
  for (const pid_t child : children) {
    waitpid(child, nullptr, 0);
  }
  return begun;
}

}  // namespace detail

/// function(number) for 0 <= number < count, in `workers` processes; none where a process aborted.
template <typename Result, typename Function>
std::vector<std::optional<Result>> in_processes(int count, int workers, const Function& function) {
  std::vector<std::optional<Result>> results(static_cast<std::size_t>(count));
  std::vector<int> left(results.size());
  std::iota(left.begin(), left.end(), 0);
  while (!left.empty()) {
    const std::vector<int> aborted = detail::work_off(left, workers, function, results);
    std::erase_if(left, [&](int number) {
      return results[static_cast<std::size_t>(number)].has_value() ||
             std::find(aborted.begin(), aborted.end(), number) != aborted.end();
    });
  }
  return results;
}

}  // namespace tautline::test
