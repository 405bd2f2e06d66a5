#include "bench/store/tree.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <system_error>

#include "bench/base/atomic_file.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

/// A file that only `open_tree` makes: a folder with it is ours to clear.
constexpr const char* marker = "tautline-results.txt";

}  // namespace

Descriptor open_tree(const fs::path& out, bool clear) {
  std::error_code error;
  fs::create_directories(out, error);
  Descriptor folder(::open(out.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) {
    const std::error_code reason(errno, std::generic_category());
    throw FileError("cannot make the folder " + printable(out.string()) + ": " + reason.message());
  }
  if (::flock(folder.get(), LOCK_EX | LOCK_NB) != 0) {
    throw FileError("another `tautline` is writing to " + printable(out.string()) +
                    "; wait for it, or give another --out");
  }
  if (clear) {
    fs::remove_all(out / "runs", error);
    fs::remove_all(out / "motions", error);
    fs::remove_all(out / "draws", error);  // of an ensemble, and its pictures
    fs::remove_all(out / "cells", error);
    fs::remove_all(out / "ensemble", error);  // of a suite, with its draws
    for (const char* file : {"suite.json", "report.json", "report.md", "index.html", "summary.md",
                             "ensemble.json", "ensemble.md"}) {
      fs::remove(out / file, error);
    }
    for (const fs::directory_entry& file : fs::directory_iterator(out, error)) {
      const std::string name = file.path().filename().string();
      if (name.starts_with("card-") && name.ends_with(".svg")) {
        fs::remove(file.path(), error);
      }
    }
  }
  write_file(out / marker,
             "A result tree of `tautline`, which may clear and rewrite this folder.\n");
  return folder;
}

std::optional<std::string> tree_problem(const fs::path& out) {
  std::error_code error;
  if (!fs::exists(out, error)) {
    return std::nullopt;
  }
  const std::string name = printable(out.string());
  if (!fs::is_directory(out, error)) {
    return fmt::format("--out {}: is not a folder; give a folder to write the results to", name);
  }
  if (fs::is_empty(out, error) || fs::exists(out / marker, error)) {
    return std::nullopt;
  }
  return fmt::format(
      "--out {}: holds files that `tautline` did not write; give an empty or new "
      "folder",
      name);
}

}  // namespace tautline::bench
