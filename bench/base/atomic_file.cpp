#include "bench/base/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

#include "bench/base/descriptor.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::error_code& reason) {
  throw FileError("cannot write " + printable(path.native()) + ": " + reason.message());
}

[[noreturn]] void fail(const fs::path& path, int reason) {
  fail(path, std::error_code(reason, std::generic_category()));
}

/// A new file under a name that nobody else uses, removed when left unless it got its own name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& folder)
      : path_(unused_name(folder)), file_(open_new(path_)) {
    while (file_.get() < 0 && errno == EEXIST) {
      path_ = unused_name(folder);
      file_ = Descriptor(open_new(path_));
    }
    created_ = file_.get() >= 0;
  }
  ~TemporaryFile() {
    if (created_) {
      ::unlink(path_.c_str());
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] bool created() const { return created_; }
  [[nodiscard]] Descriptor& file() { return file_; }

  /// 0, or the reason why it still has its temporary name.
  int rename_to(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) {
      return errno;
    }
    created_ = false;
    return 0;
  }

 private:
  static fs::path unused_name(const fs::path& folder) {
    static std::atomic<unsigned> count = 0;
    const std::string number = std::to_string(count++);
    return folder / (".tautline-" + std::to_string(::getpid()) + "-" + number + ".tmp");
  }

  static int open_new(const fs::path& path) {
    constexpr mode_t mode = 0666;  // less what the umask takes, as for any new file
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  }

  fs::path path_;
  Descriptor file_;
  bool created_ = false;
};

/// True for names of what this process has open already: the file behind must stay the one it is.
bool is_open_already(const fs::path& path) {
  const std::string& name = path.native();
  return name.starts_with("/dev/std") || name.starts_with("/dev/fd/") || name.starts_with("/proc/");
}

/// For what is not a file of its own: a device, a pipe, a terminal, the standard output.
void write_in_place(const fs::path& path, std::string_view content) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY));
  if (file.get() < 0) {
    fail(path, errno);
  }
  if (const int reason = write_all(file.get(), content)) {
    fail(path, reason);
  }
}

/// When a file has its name.
enum class Naming {
  on_the_disk,  // once its content is there, so that a power cut does not leave an empty file
  at_once,
};

void replace(const fs::path& path, const fs::path& target, std::string_view content,
             Naming naming) {
  TemporaryFile temporary(target.parent_path());
  if (!temporary.created()) {
    fail(path, errno);
  }
  Descriptor& file = temporary.file();
  if (const int reason = write_all(file.get(), content)) {
    fail(path, reason);
  }
  if (naming == Naming::on_the_disk && ::fsync(file.get()) != 0) {
    fail(path, errno);
  }
  if (const int reason = file.close()) {
    fail(path, reason);
  }
  if (const int reason = temporary.rename_to(target)) {
    fail(path, reason);
  }
}

void write_as(const fs::path& path, std::string_view content, Naming naming) {
  std::error_code error;
  if (path.has_parent_path()) {
    fs::create_directories(path.parent_path(), error);
    if (error) {
      fail(path, error);
    }
  }
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) {
    fail(path, EISDIR);
  }
  if (fs::is_other(status) || is_open_already(path)) {
    return write_in_place(path, content);
  }
  fs::path target = path;
  if (fs::exists(status)) {
    target = fs::canonical(path, error);
    if (error) {
      fail(path, error);
    }
  }
  replace(path, target, content, naming);
}

}  // namespace

void write_file(const fs::path& path, std::string_view content) {
  write_as(path, content, Naming::on_the_disk);
}

void write_file_soon(const fs::path& path, std::string_view content) {
  write_as(path, content, Naming::at_once);
}

}  // namespace tautline::bench
