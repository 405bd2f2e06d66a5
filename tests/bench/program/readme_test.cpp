#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

/// A block of a page that shows what a command prints.
struct Excerpt {
  std::string command;             // after "tautline "
  std::vector<std::string> lines;  // the block
};

std::vector<Excerpt> excerpts(const std::string& page) {
  std::ifstream file(page);
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

/// Rounding that the motion has amplified: it differs between compilers, its size does not matter.
constexpr double rounding = 1e-6;

/// What a simulated second costs: it is another one every time.
std::string without_cost(const std::string& line) {
  static const std::regex cost("[-+.0-9e]+ ms a second");
  return std::regex_replace(line, cost, "");
}

/// The same words, and the same numbers where they are more than rounding.
bool same(const std::string& shown, const std::string& printed) {
  std::istringstream one(without_cost(shown));
  std::istringstream two(without_cost(printed));
  std::string a;
  std::string b;
  while (true) {
    const bool more_a = static_cast<bool>(one >> a);
    const bool more_b = static_cast<bool>(two >> b);
    if (!more_a || !more_b) {
      return more_a == more_b;
    }
    const bool tiny =
        a.find("e-") != std::string::npos && std::strtod(a.c_str(), nullptr) < rounding;
    const double other = std::strtod(b.c_str(), nullptr);
    if (a != b && !(tiny && other < rounding) && !(a == "0.0e+00" && other < rounding)) {
      return false;
    }
  }
}

/// The first engine of the command's `--engines` that is not built, or nothing.
std::string missing_engine(const std::string& command) {
  std::smatch engines;
  if (std::regex_search(command, engines, std::regex("--engines ([^ ]+)"))) {
    const std::set<std::string> built = built_engines();
    std::istringstream names(engines[1]);
    for (std::string name; std::getline(names, name, ',');) {
      if (!built.contains(name)) {
        return name;
      }
    }
  }
  return "";
}

/// Holds at least `least` blocks of `page` to what the program prints now, those left out that need
/// an engine that is not built. Paths in the commands are relative to docs/guides/.
void expect_true_blocks(const std::string& page, std::size_t least) {
  const std::vector<Excerpt> all = excerpts(page);
  ASSERT_GE(all.size(), least);
  for (const Excerpt& excerpt : all) {
    if (const std::string engine = missing_engine(excerpt.command); !engine.empty()) {
      std::cout << page << ": a block is left out, as " << engine << " is not built\n";
      continue;
    }
    const TemporaryFolder folder;
    std::vector<std::string> arguments;
    std::istringstream words(excerpt.command);
    for (std::string word; words >> word;) {
      const std::string file = std::string(TAUTLINE_DOCS) + "/guides/" + word;
      arguments.push_back(std::filesystem::is_regular_file(file) ? file : word);
    }
    if (arguments.front() == "bench") {
      arguments.insert(arguments.end(), {"--out", (folder.path() / "r").string()});
    }
    std::istringstream printed(program(arguments).output);
    ASSERT_GE(excerpt.lines.size(), 3U) << excerpt.command;
    for (const std::string& shown : excerpt.lines) {
      std::string line;
      std::getline(printed, line);
      EXPECT_TRUE(same(shown, line)) << "page: " << shown << "\nnow:  " << line << "\ntautline "
                                     << excerpt.command << "; scripts/update-readme writes it anew";
    }
  }
}

TEST(Readme, ShowsWhatTheProgramPrints) { expect_true_blocks(TAUTLINE_README, 1); }

TEST(Readme, IsShort) {
  std::ifstream file(TAUTLINE_README);
  std::size_t lines = 0;
  for (std::string line; std::getline(file, line);) {
    ++lines;
  }
  EXPECT_LE(lines, 150U) << "a page of docs/ has room for more";
}

TEST(Pages, ShowWhatTheProgramPrints) {
  for (const std::string page : {"guides/bench", "guides/check", "reference/case-file", "snap"}) {
    expect_true_blocks(TAUTLINE_DOCS "/" + page + ".md", 1);
  }
}

TEST(Recipes, ShowWhatTheProgramPrints) {
  expect_true_blocks(TAUTLINE_DOCS "/guides/recipes.md", 9);
}

TEST(Crane, IsShownAsItsFileSaysAndMovesAsThePageShows) {
  std::string file = content_of(TAUTLINE_DOCS "/guides/crane/crane.toml");
  file.erase(0, file.find('\n') + 1);  // the schema, for editors
  EXPECT_NE(content_of(TAUTLINE_DOCS "/guides/crane.md").find("```toml\n" + file + "```"),
            std::string::npos);
  expect_true_blocks(TAUTLINE_DOCS "/guides/crane.md", 2);
}

}  // namespace
}  // namespace tautline::test
