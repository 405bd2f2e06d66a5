#include "bench/base/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <span>
#include <system_error>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

std::string reason(int number) {
  return std::error_code(number, std::generic_category()).message();
}

/// What the path names, if that is no regular file.
std::optional<std::string> other_kind(const struct stat& status) {
  if (S_ISREG(status.st_mode)) {
    return std::nullopt;
  }
  if (S_ISDIR(status.st_mode)) {
    return "is a directory, must be a file";
  }
  if (S_ISFIFO(status.st_mode)) {
    return "is a pipe, must be a file";
  }
  return "is a device or socket, must be a file";
}

/// The other case files in the folder of `path`, by name without extension.
std::vector<std::string> case_files_beside(const fs::path& path) {
  constexpr int enough = 10'000;  // in a folder with more, a guess is not worth the wait
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<std::string> names;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (int count = 0; !error && entry != fs::directory_iterator() && count < enough; ++count) {
    if (entry->path().extension() == ".toml") {
      names.push_back(entry->path().stem());
    }
    entry.increment(error);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// "; did you mean a or b?" with files beside the missing one and cases that ship.
std::string near_misses(const fs::path& path) {
  const std::vector<std::string> shipped = listed(shipped_cases(), &Case::name);
  const fs::path stem = path.extension() == ".toml" ? path.stem() : path.filename();
  std::vector<std::string> found;
  for (const std::string& name : nearest(stem.native(), case_files_beside(path))) {
    found.push_back(printable((path.parent_path() / (name + ".toml")).native()));
  }
  for (const std::string& name : nearest(stem.native(), shipped)) {
    found.push_back(name + " (shipped)");
  }
  return found.empty() ? "" : "; did you mean " + joined(found, "or") + "?";
}

InputFile refused(std::string problem) { return {"", std::move(problem)}; }

/// Reads until the end or `longest` + 1 bytes. As long as it `seems`, no more room is taken.
InputFile read_to_end(int descriptor, std::size_t seems, std::size_t longest) {
  InputFile result;
  result.content.resize(std::min(seems, longest) + 1);
  std::size_t length = 0;
  while (length <= longest) {
    if (length == result.content.size()) {
      result.content.resize(std::min(2 * length, longest + 1));
    }
    const std::span<char> rest = std::span(result.content).subspan(length);
    const ssize_t count = ::read(descriptor, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0) {
      return refused("cannot be read: " + reason(errno));
    }
    if (count == 0) {
      break;
    }
    length += static_cast<std::size_t>(count);
  }
  result.content.resize(length);
  return result;
}

std::string too_long(const std::string& length, std::size_t longest) {
  return "is " + length + " bytes long, must be at most " + std::to_string(longest);
}

}  // namespace

InputFile read_input_file(const fs::path& path, std::size_t longest) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    const int number = errno;
    return refused(number == ENOENT ? "no such file" + near_misses(path)
                                    : "cannot be read: " + reason(number));
  }
  if (auto kind = other_kind(status)) {
    return refused(std::move(*kind));
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > longest) {
    return refused(too_long(std::to_string(size), longest));
  }
  // should a pipe have taken the file's place since, O_NONBLOCK does not wait for its writer
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    return refused("cannot be read: " + reason(errno));
  }
  InputFile result = read_to_end(descriptor, size, longest);
  ::close(descriptor);
  if (result.content.size() > longest) {  // it grew, or it is one of the files without a size
    return refused(too_long("over " + std::to_string(longest), longest));
  }
  return result;
}

}  // namespace tautline::bench
