#include "bench/base/process.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace tautline::bench {
namespace {

constexpr std::size_t tail_length = 2000;  // [bytes] of a child's output that are kept

[[noreturn]] void fail_with(const std::string& what, int error) {
  throw std::system_error(error, std::generic_category(), what);
}

/// What a spawned process is given; released with it.
class SpawnSetup {
 public:
  SpawnSetup(int input, int output, int result, int turn) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, 1);
    posix_spawn_file_actions_adddup2(&actions_, output, 2);
    posix_spawn_file_actions_adddup2(&actions_, result, 3);
    posix_spawn_file_actions_adddup2(&actions_, turn, 4);
    posix_spawnattr_init(&attributes_);
    // a group of its own: Ctrl-C reaches this program alone, and a kill reaches all it started
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGINT);
    sigaddset(&defaults, SIGTERM);
    sigaddset(&defaults, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes_, &defaults);
    posix_spawnattr_setflags(&attributes_,
                             static_cast<short>(POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF));
  }
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;

  [[nodiscard]] pid_t spawn(const std::vector<std::string>& arguments) {
    const std::vector<char*> words = exec_words(arguments);
    pid_t child = -1;
    const int error =
        posix_spawn(&child, words.front(), &actions_, &attributes_, words.data(), environ);
    if (error != 0) {
      fail_with("cannot start " + arguments.front(), error);
    }
    return child;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// Keeps the last of what is appended.
void append_tail(ProcessEnd& end, const char* data, std::size_t size) {
  end.printed += size;
  end.output_tail.append(data, size);
  if (end.output_tail.size() > 2 * tail_length) {
    end.output_tail.erase(0, end.output_tail.size() - tail_length);
  }
}

/// The beginning of /proc/`process`/`name`; empty if it is gone.
std::string proc_file(pid_t process, const char* name) {
  std::array<char, 4096> text{};  // a stat and a statm are far shorter, a status is not longer
  (void)std::snprintf(text.data(), text.size(), "/proc/%d/%s", static_cast<int>(process), name);
  const Descriptor file(::open(text.data(), O_RDONLY | O_CLOEXEC));
  const ssize_t size = file.get() < 0 ? 0 : ::read(file.get(), text.data(), text.size());
  return {text.data(), static_cast<std::size_t>(size > 0 ? size : 0)};
}

/// The parent of a process; 0 if it is gone.
pid_t parent_of(pid_t process) {
  const std::string stat = proc_file(process, "stat");  // 42 (any name) S 1 ...
  const std::size_t name_end = stat.rfind(") ");
  return name_end == stat.npos || name_end + 4 >= stat.size()
             ? 0
             : static_cast<pid_t>(std::strtol(stat.c_str() + name_end + 4, nullptr, 10));
}

/// Every process with its parent.
std::vector<std::pair<pid_t, pid_t>> all_processes() {
  std::vector<std::pair<pid_t, pid_t>> result;
  DIR* const folder = ::opendir("/proc");
  if (folder == nullptr) {
    return result;
  }
  while (const dirent* const entry = ::readdir(folder)) {
    if (std::isdigit(static_cast<unsigned char>(entry->d_name[0])) != 0) {
      const auto process = static_cast<pid_t>(std::strtol(entry->d_name, nullptr, 10));
      result.emplace_back(process, parent_of(process));
    }
  }
  ::closedir(folder);
  return result;
}

}  // namespace

std::pair<Descriptor, Descriptor> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    fail_with("cannot make a pipe", errno);
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::pair<Descriptor, Descriptor> make_socket(int type) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    fail_with("cannot make a socket", errno);
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Descriptor memory_file() {
  Descriptor file(::memfd_create("tautline", MFD_CLOEXEC));
  if (file.get() < 0) {
    fail_with("cannot make a file in memory", errno);
  }
  return file;
}

void fill(const Descriptor& file, std::string_view content) {
  if (::ftruncate(file.get(), 0) != 0) {
    fail_with("cannot empty a file in memory", errno);
  }
  for (off_t done = 0; !content.empty();) {
    const ssize_t size = ::pwrite(file.get(), content.data(), content.size(), done);
    if (size < 0) {
      fail_with("cannot write a file in memory", errno);
    }
    content.remove_prefix(static_cast<std::size_t>(size));
    done += size;
  }
}

std::string content_of(const Descriptor& file) {
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) {
    fail_with("cannot read a file in memory", errno);
  }
  std::string content(static_cast<std::size_t>(info.st_size), '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t size =
        ::pread(file.get(), content.data() + done, content.size() - done, static_cast<off_t>(done));
    if (size <= 0) {
      fail_with("cannot read a file in memory", errno);
    }
    done += static_cast<std::size_t>(size);
  }
  return content;
}

std::atomic<bool>& interruption() {
  static std::atomic<bool> flag{false};
  return flag;
}

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int most = 32 << 20;  // [bytes], the most that either takes
  mallopt(M_TRIM_THRESHOLD, most);
  mallopt(M_MMAP_THRESHOLD, most);
#endif
}

void catch_interruption() {
  const auto handler = [](int signal) {
    if (interruption().exchange(true)) {
      std::signal(signal, SIG_DFL);
      std::raise(signal);
    }
  };
  static_cast<void>(interruption().load());  // made before a handler could be the first to ask
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
}

Process::Process(const std::vector<std::string>& arguments, const Descriptor& input,
                 const Descriptor& result, const Descriptor& turn) {
  auto [reading, writing] = make_pipe();
  output_ = std::move(reading);
  ::fcntl(output_.get(), F_SETFL, O_NONBLOCK);
  process_ = SpawnSetup(input.get(), writing.get(), result.get(), turn.get()).spawn(arguments);
}

Process::~Process() {
  if (process_ > 0) {
    end();
  }
}

int Process::end() {
  ::kill(-process_, SIGKILL);  // the group outlives its leader if that started others
  int status = 0;
  ::waitpid(std::exchange(process_, -1), &status, 0);
  return status;
}

void Process::drain(ProcessEnd& end) {
  std::array<char, 1 << 16> buffer{};  // as much as a pipe holds
  const ssize_t size = ::read(output_.get(), buffer.data(), buffer.size());
  if (size > 0) {
    append_tail(end, buffer.data(), static_cast<std::size_t>(size));
  } else if (size == 0) {
    output_.close();
  }
}

ProcessEnd::Kind Process::watch(int turn, double time_limit, ProcessEnd& end) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(time_limit);
  while (!interruption()) {
    // looks again after so many [ms]: notices a limit, an interruption, or a closed pipe
    const int look_again = output_.get() >= 0 ? 20 : 1;
    std::array<pollfd, 2> watched{{{output_.get(), POLLIN, 0}, {turn, POLLIN, 0}}};
    ::poll(watched.data(), watched.size(), look_again);
    drain(end);
    char byte = 0;
    const ssize_t size = turn < 0 ? -1 : ::recv(turn, &byte, 1, MSG_DONTWAIT);
    if (size > 0) {
      return ProcessEnd::Kind::answered;
    }
    if (size == 0) {
      turn = -1;  // it is at its end, or has closed what it should not have
    }
    siginfo_t gone{};
    if (::waitid(P_PID, static_cast<id_t>(process_), &gone, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        gone.si_pid == process_) {
      return ProcessEnd::Kind::exited;
    }
    if (Clock::now() > deadline) {
      return ProcessEnd::Kind::timed_out;
    }
  }
  return ProcessEnd::Kind::interrupted;
}

ProcessEnd Process::wait(const Descriptor& turn, double time_limit) {
  ProcessEnd end;
  end.kind = watch(turn.get(), time_limit, end);
  drain(end);  // what is left in the pipe; a grandchild that holds it open is not waited for
  if (end.output_tail.size() > tail_length) {
    end.output_tail.erase(0, end.output_tail.size() - tail_length);
  }
  if (end.kind == ProcessEnd::Kind::answered) {
    return end;
  }
  const int status = this->end();
  if (end.kind == ProcessEnd::Kind::exited) {
    end.kind = WIFSIGNALED(status) ? ProcessEnd::Kind::signalled : ProcessEnd::Kind::exited;
    end.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  }
  return end;
}

std::vector<char*> exec_words(const std::vector<std::string>& words) {
  std::vector<char*> raw;
  raw.reserve(words.size() + 1);
  for (const std::string& word : words) {
    raw.push_back(const_cast<char*>(word.c_str()));  // POSIX takes char* but does not write
  }
  raw.push_back(nullptr);
  return raw;
}

void limit_address_space(std::size_t memory) {
  rlimit space{};
  ::getrlimit(RLIMIT_AS, &space);
  space.rlim_cur = std::min<rlim_t>(memory, space.rlim_max);
  ::setrlimit(RLIMIT_AS, &space);
}

std::vector<pid_t> descendants_of(pid_t root) {
  const auto all = all_processes();
  std::vector<pid_t> found = {root};
  for (std::size_t next = 0; next < found.size(); ++next) {
    for (const auto& [process, parent] : all) {
      if (parent == found[next]) {
        found.push_back(process);
      }
    }
  }
  found.erase(found.begin());
  return found;
}

double resident_memory(const std::vector<pid_t>& processes) {
  double pages = 0.0;
  for (const pid_t process : processes) {
    const std::string statm = proc_file(process, "statm");  // pages: in all, resident, ...
    const std::size_t space = statm.find(' ');
    pages += space == statm.npos ? 0.0 : std::strtod(statm.c_str() + space, nullptr);
  }
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

double peak_memory_of(pid_t process) {
  constexpr const char* label = "VmHWM:";
  const std::string status = proc_file(process, "status");
  const std::size_t place = status.find(label);
  return place == status.npos
             ? 0.0
             : 1024.0 * std::strtod(status.c_str() + place + std::strlen(label), nullptr);  // kB
}

double peak_memory() { return peak_memory_of(::getpid()); }

void forget_peak_memory_of(pid_t process) {
  std::ofstream("/proc/" + std::to_string(process) + "/clear_refs") << "5";  // see man 5 proc
}

double clock_time(clockid_t clock) {
  timespec now{};
  return ::clock_gettime(clock, &now) == 0
             ? static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec)
             : 0.0;
}

double processor_time_of(pid_t process) {
  clockid_t clock{};
  return ::clock_getcpuclockid(process, &clock) == 0 ? clock_time(clock) : 0.0;
}

void end_descendants() {
  constexpr int most_passes = 2000;        // of a millisecond
  constexpr timespec pause{0, 1'000'000};  // [ns]
  for (int pass = 0; pass < most_passes; ++pass) {
    // a process that is about to start another is stopped before one is missed
    const std::vector<pid_t> found = descendants_of(::getpid());
    for (const int signal : {SIGSTOP, SIGKILL}) {
      for (const pid_t process : found) {
        ::kill(process, signal);
      }
    }
    while (::waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    if (::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) {
      return;
    }
    ::nanosleep(&pause, nullptr);
  }
}

std::string signal_name(int signal) {
  const char* abbreviation = ::sigabbrev_np(signal);
  return abbreviation != nullptr ? "SIG" + std::string(abbreviation)
                                 : "signal " + std::to_string(signal);
}

}  // namespace tautline::bench
