#include "bench/run/protocol/process_tree.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <utility>

#include "bench/base/descriptor.hpp"

namespace tautline::bench {
namespace {

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

void forget_peak_memory_of(pid_t process) {
  std::ofstream("/proc/" + std::to_string(process) + "/clear_refs") << "5";  // see man 5 proc
}

double processor_time_of(pid_t process) {
  clockid_t clock{};
  timespec now{};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &now) != 0) {
    return 0.0;
  }
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
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

}  // namespace tautline::bench
