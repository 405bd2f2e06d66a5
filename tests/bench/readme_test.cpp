#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "program.hpp"

namespace tautline::test {
namespace {

/// A block of README.md that shows what a command prints.
struct Excerpt {
  std::string command;             // after "tautline "
  std::vector<std::string> lines;  // the block
};

std::vector<Excerpt> excerpts() {
  std::ifstream file(TAUTLINE_README);
  std::vector<Excerpt> found;
  const std::string mark = "<!-- output of: tautline ";
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(mark)) {
      continue;
    }
    Excerpt excerpt{line.substr(mark.size(), line.find(" -->") - mark.size()), {}};
    std::getline(file, line);  // the fence
    while (std::getline(file, line) && line != "```") {
      excerpt.lines.push_back(line);
    }
    found.push_back(std::move(excerpt));
  }
  return found;
}

TEST(Readme, ShowsWhatTheProgramPrints) {
  const std::vector<Excerpt> all = excerpts();
  ASSERT_GE(all.size(), 3U);
  for (const Excerpt& excerpt : all) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments;
    std::istringstream words(excerpt.command);
    for (std::string word; words >> word;) {
      arguments.push_back(word);
    }
    if (arguments.front() == "bench") {
      arguments.insert(arguments.end(), {"--out", (folder.path() / "r").string()});
    }
    std::istringstream printed(program(arguments).output);
    ASSERT_GE(excerpt.lines.size(), 3U) << excerpt.command;
    for (const std::string& shown : excerpt.lines) {
      std::string line;
      std::getline(printed, line);
      EXPECT_EQ(shown, line) << "tautline " << excerpt.command
                             << "; scripts/update-readme writes it anew";
    }
  }
}

}  // namespace
}  // namespace tautline::test
