#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace tautline::bench {

/// The content of a file, or why there is none.
struct InputFile {
  std::string content;
  std::optional<std::string> problem;  // what is wrong, without the path: "is a directory, ..."
};

/// Reads a regular file of at most `longest` bytes. Whatever else the path names is refused at
/// once, without reading it or waiting for it.
[[nodiscard]] InputFile read_input_file(const std::filesystem::path& path, std::size_t longest);

}  // namespace tautline::bench
