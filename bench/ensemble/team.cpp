#include "bench/ensemble/team.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* module_name = "tautline-mpi.so";

/// The variable by which a launcher tells a process that it is one of several; none without one.
std::optional<std::string> launched_by() {
  constexpr std::array variables = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
  for (const char* const name : variables) {
    if (std::getenv(name) != nullptr) {  // NOLINT(concurrency-mt-unsafe): no other thread yet
      return name;
    }
  }
  return std::nullopt;
}

/// In the build tree, or where it is installed: both relative to the program.
std::optional<fs::path> find_module() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* const folder : {"../engines", TAUTLINE_INSTALLED_ENGINES "/.."}) {
    const fs::path file = (program / folder / module_name).lexically_normal();
    if (fs::exists(file, error)) {
      return file;
    }
  }
  return std::nullopt;
}

const Ranks* join(const std::string& variable) {
  const auto file = find_module();
  if (!file) {
    throw std::runtime_error(
        fmt::format("{} says that this is one of several processes of MPI, and {} is not here: "
                    "install tautline-mpi, or build with MPI; one process needs neither, started "
                    "without mpirun",
                    variable, module_name));
  }
  // the parts of an MPI look for its functions in what is loaded
  void* const library = ::dlopen(file->c_str(), RTLD_NOW | RTLD_GLOBAL | RTLD_NODELETE);
  void* const symbol = library == nullptr ? nullptr : ::dlsym(library, "tautline_join_ranks");
  if (symbol == nullptr) {
    const char* const reason = ::dlerror();
    throw std::runtime_error(
        fmt::format("{}: cannot be loaded: {}", file->string(), reason == nullptr ? "" : reason));
  }
  const Ranks* const ranks = reinterpret_cast<JoinRanks*>(symbol)();
  if (ranks == nullptr) {
    throw std::runtime_error("MPI cannot be started for threads that take turns");
  }
  if (ranks->version != ranks_version) {
    throw std::runtime_error(
        fmt::format("{}: is of another version of tautline: {} instead of {}; install both of one",
                    file->string(), ranks->version, ranks_version));
  }
  return ranks;
}

}  // namespace

Team::Team() {
  if (const auto variable = launched_by()) {
    ranks_ = join(*variable);
  }
}

Team::~Team() {
  if (ranks_ != nullptr) {
    ranks_->leave();
  }
}

std::size_t Team::next() {
  if (ranks_ == nullptr) {
    return next_++;
  }
  const std::scoped_lock lock(guard_);
  return ranks_->next();
}

bool Team::all(bool yes) {
  if (ranks_ == nullptr) {
    return yes;
  }
  const std::scoped_lock lock(guard_);
  return ranks_->all(yes);
}

void Team::abandon(int code) {
  if (ranks_ != nullptr) {
    ranks_->abort(code);
  }
}

}  // namespace tautline::bench
