#include "tautline/case_file.hpp"

#include "bench/base/atomic_file.hpp"
#include "bench/base/input_file.hpp"
#include "bench/base/problems.hpp"

namespace tautline {
namespace {

/// Calls `read` with the text of the file; or says what is wrong with the file itself.
template <class Read>
auto of_file(const std::filesystem::path& path, const Read& read) {
  const bench::InputFile file = bench::read_input_file(path, longest_case_file);
  decltype(read(file.content)) result;
  if (file.problem) {
    bench::FileProblems wrong(path.native());
    wrong.add(0, *file.problem);
    result.problems = wrong.sentences();
  } else {
    result = read(file.content);
  }
  return result;
}

/// Writes `text`, unless it has `problems`; returns what is wrong.
std::vector<std::string> written(const std::filesystem::path& path, const std::string& text,
                                 std::vector<std::string> problems) {
  if (!problems.empty()) {
    return problems;
  }
  try {
    bench::write_file(path, text);
  } catch (const bench::FileError& error) {
    return {error.what()};
  }
  return {};
}

}  // namespace

CaseReading read_case(const std::filesystem::path& path, CableSet taut) {
  return of_file(
      path, [&](const std::string& text) { return read_case_text(text, path.native(), taut); });
}

SystemReading read_system(const std::filesystem::path& path, CableSet taut) {
  return of_file(
      path, [&](const std::string& text) { return read_system_text(text, path.native(), taut); });
}

std::vector<std::string> write_case(const Case& the_case, const std::filesystem::path& path) {
  const std::string text = write_case(the_case);
  return written(path, text, read_case_text(text, path.native()).problems);
}

std::vector<std::string> write_system(const System& system, const std::filesystem::path& path) {
  std::vector<std::string> wrong = problems(system);  // a text needs a sound one
  if (!wrong.empty()) {
    return wrong;
  }
  const std::string text = write_system(system);
  return written(path, text, read_system_text(text, path.native()).problems);
}

}  // namespace tautline
