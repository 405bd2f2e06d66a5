#pragma once

#include <string>
#include <vector>

namespace tautline::bench {

// The names of the files that `tautline solve` writes.

/// A file that an option names.
struct OutputFile {
  std::string option;  // "--csv"
  std::string file;    // or "-"
  bool takes_all;      // one file may hold all cases
};

/// What "{case}" in the name of a file means: the name of the case.
inline constexpr const char* case_mark = "{case}";

/// True if the name of `file` has it.
[[nodiscard]] bool names_case(const std::string& file);

/// The file of the case of this name, which "{case}" means, with "-" for "/".
[[nodiscard]] std::string file_for(const std::string& file, const std::string& case_name);

/// What is wrong with `files` for the cases of these names: several cases would write one file, or
/// two options the same.
[[nodiscard]] std::vector<std::string> file_problems(const std::vector<OutputFile>& files,
                                                     const std::vector<std::string>& cases);

/// True if `file` is to be a PNG picture, by its name; else it is SVG.
[[nodiscard]] bool is_png(const std::string& file);

/// A picture that --plot asks for.
struct Picture {
  bool motion = false;  // over time; else the paths
  std::string file;     // or "-"
};

/// `asked` is "KIND=FILE", "KIND" for standard output, or "FILE" for a path.
[[nodiscard]] Picture picture_of(const std::string& asked);

/// What is wrong with it.
[[nodiscard]] std::vector<std::string> picture_problems(const std::string& asked);

}  // namespace tautline::bench
