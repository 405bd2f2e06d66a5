#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace tautline::bench {

/// A file could not be written; what() is a sentence with its path and the reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes `content` the content of the file `path`, whose parent folders are created as needed.
/// A reader sees the old content or the new, never a part of it; on failure the old stays, nothing
/// is left behind and FileError is thrown. Through a symbolic link the file it names is written.
/// A device, a pipe or what is open already (`/dev/stdout`) is written to as it is.
void write_file(const std::filesystem::path& path, std::string_view content);

/// The same, but does not wait for the disk: after a power cut the file may have lost its content,
/// or a part of it. For what its reader can tell from a whole one, and make again.
void write_file_soon(const std::filesystem::path& path, std::string_view content);

}  // namespace tautline::bench
