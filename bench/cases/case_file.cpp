#include "tautline/case_file.hpp"

#include "bench/base/atomic_file.hpp"
#include "bench/base/input_file.hpp"
#include "bench/base/problems.hpp"

namespace tautline {

CaseReading read_case(const std::filesystem::path& path, CableSet taut) {
  const bench::InputFile file = bench::read_input_file(path, longest_case_file);
  if (file.problem) {
    bench::FileProblems wrong(path.native());
    wrong.add(0, *file.problem);
    return {std::nullopt, wrong.sentences()};
  }
  return read_case_text(file.content, path.native(), taut);
}

std::vector<std::string> write_case(const Case& the_case, const std::filesystem::path& path) {
  const std::string text = write_case(the_case);
  std::vector<std::string> wrong = read_case_text(text, path.native()).problems;
  if (!wrong.empty()) {
    return wrong;
  }
  try {
    bench::write_file(path, text);
  } catch (const bench::FileError& error) {
    return {error.what()};
  }
  return {};
}

}  // namespace tautline
