// What a path may name instead of a case file.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <limits>

#include "tautline/case_file.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// The one sentence about the file, without the path it starts with.
std::string sentence(const fs::path& path) {
  const CaseReading reading = read_case(path);
  EXPECT_EQ(reading.problems.size(), 1U);
  EXPECT_FALSE(reading.the_case);
  const std::string start = path.native() + ": ";
  EXPECT_TRUE(reading.problems.front().starts_with(start)) << reading.problems.front();
  return reading.problems.front().substr(start.size());
}

TEST(CaseInput, FileIsRead) {
  const TemporaryFolder folder;
  const CaseReading reading = read_case(folder.file("x.toml", write_case(bouncing_ball())));
  ASSERT_TRUE(reading.the_case) << reading.problems.front();
  EXPECT_EQ(test::bits(*reading.the_case), test::bits(bouncing_ball()));
}

TEST(CaseInput, SentencesStartWithThePath) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("x.toml", "name = 3");
  EXPECT_EQ(read_case(path).problems.back(),
            path.native() + ":1: name = 3: is an integer, must be a string that is not empty");
}

/// What this process has read by now, from whatever it was [bytes].
std::size_t bytes_read() {
  std::ifstream file("/proc/self/io");
  std::string word;
  std::size_t count = 0;
  file >> word >> count;
  EXPECT_EQ(word, "rchar:");
  return count;
}

TEST(CaseInput, HugeSparseFileIsRefusedUnread) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("huge.toml", "");
  fs::resize_file(path, 1U << 30U);
  const std::size_t before = bytes_read();
  EXPECT_EQ(sentence(path), "is 1073741824 bytes long, must be at most 1048576");
  EXPECT_LT(bytes_read() - before, longest_case_file);
}

TEST(CaseInput, LongestFileIsReadAndOneByteMoreIsNot) {
  const TemporaryFolder folder;
  std::string text = write_case(bouncing_ball());
  while (text.size() < longest_case_file) {
    text += text.size() % 1000 == 0 ? "\n" : "#";
  }
  EXPECT_TRUE(read_case(folder.file("fits.toml", text)).the_case);
  EXPECT_EQ(sentence(folder.file("long.toml", text + "\n")),
            "is 1048577 bytes long, must be at most 1048576");
}

TEST(CaseInput, FolderPipeAndDeviceAreRefused) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe.toml";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(sentence(folder.path()), "is a directory, must be a file");
  EXPECT_EQ(sentence(pipe), "is a pipe, must be a file");
  EXPECT_EQ(sentence("/dev/zero"), "is a device or socket, must be a file");
}

TEST(CaseInput, FileWithoutASizeIsReadNoFurtherThanTheLimit) {
  const fs::path endless = "/proc/self/pagemap";  // regular, of size 0, gigabytes when read
  if (!fs::exists(endless)) {
    GTEST_SKIP() << "no " << endless << " here";
  }
  const std::size_t before = bytes_read();
  EXPECT_FALSE(sentence(endless).empty());
  EXPECT_LT(bytes_read() - before, 2 * longest_case_file);  // the rest is of `bytes_read` itself
}

TEST(CaseInput, MissingFileNamesItsNeighbours) {
  const TemporaryFolder folder;
  const fs::path there = folder.file("bridge.toml", "");
  EXPECT_EQ(sentence(folder.path() / "brigde.toml"),
            "no such file; did you mean " + there.native() + "?");
  EXPECT_EQ(sentence(folder.path() / "bouncing-bal.toml"),
            "no such file; did you mean bouncing-ball (shipped)?");
  EXPECT_EQ(sentence(folder.path() / "qwertz.toml"), "no such file");
  EXPECT_EQ(sentence(folder.path() / "none" / "x.toml"), "no such file");
}

TEST(CaseInput, EmptyPathHasASentenceToo) {
  EXPECT_EQ(read_case("").problems, std::vector<std::string>{"\"\": no such file"});
}

TEST(CaseInput, LinkInACircleIsAProblem) {
  const TemporaryFolder folder;
  const fs::path link = folder.path() / "link.toml";
  fs::create_symlink(link, link);
  EXPECT_EQ(sentence(link), "cannot be read: Too many levels of symbolic links");
}

TEST(CaseInput, FileWithoutReadingRightsIsAProblem) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("secret.toml", "");
  fs::permissions(path, fs::perms::none);
  fs::permissions(folder.path(), fs::perms::all);
  const uid_t user = ::geteuid();
  constexpr uid_t nobody = 65534;
  if (user == 0 && ::seteuid(nobody) != 0) {  // root may read everything
    GTEST_SKIP() << "cannot give up the rights of root";
  }
  EXPECT_EQ(sentence(path), "cannot be read: Permission denied");
  ASSERT_EQ(::seteuid(user), 0);
}

TEST(CaseInput, HostileFileNameIsPrintedHarmlessly) {
  EXPECT_EQ(read_case("\x1b[2J.toml").problems.front(), "\\x1b[2J.toml: no such file");
}

TEST(CaseOutput, FileIsWrittenInANewFolderAndReadsBackBitForBit) {
  const TemporaryFolder folder;
  for (const Case& the_case : shipped_cases()) {
    const fs::path path = folder.path() / "new" / "x.toml";
    EXPECT_EQ(write_case(the_case, path), std::vector<std::string>());
    const CaseReading reading = read_case(path);
    ASSERT_TRUE(reading.the_case) << reading.problems.front();
    EXPECT_EQ(test::bits(*reading.the_case), test::bits(the_case));
  }
}

TEST(CaseOutput, CaseThatCouldNotBeReadIsNotWritten) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("x.toml", "as it was");
  Case wrong = bouncing_ball();
  wrong.body.mass = -1.0;
  wrong.cables.front().restitution = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(write_case(wrong, path).size(), 2U);
  wrong = bouncing_ball();
  wrong.name = "\xff";  // not UTF-8
  EXPECT_EQ(write_case(wrong, path).size(), 1U);
  EXPECT_EQ(test::content_of(path), "as it was");
}

TEST(CaseOutput, PlaceThatCannotBeWrittenIsASentence) {
  const TemporaryFolder folder;
  const std::vector<std::string> wrong = write_case(bouncing_ball(), folder.path());
  ASSERT_EQ(wrong.size(), 1U);
  EXPECT_EQ(wrong.front(), "cannot write " + folder.path().native() + ": Is a directory");
}

TEST(CaseInput, DeepNestingIsAnAnswerNotAStackOverflow) {
  std::string dots;
  while (dots.size() < 4000) {
    dots += "a.";
  }
  const std::string nested_tables = "[" + dots + "a]\n" + dots + "a = 1\n";
  const std::string nested_arrays = "a = " + std::string(4000, '[');
  for (const std::string& text : {nested_tables, nested_arrays, dots}) {
    EXPECT_FALSE(read_case_text(text, "deep.toml").problems.empty());
  }
}

}  // namespace
}  // namespace tautline::bench
