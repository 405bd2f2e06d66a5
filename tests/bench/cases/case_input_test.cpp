// What a path may name instead of a case file.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>

#include "bench/cases/case_file.hpp"
#include "bench/cases/case_writer.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// The one sentence about the file, without the path it starts with.
std::string sentence(const fs::path& path) {
  const CaseReading reading = read_case_file(path);
  EXPECT_EQ(reading.problems.size(), 1U);
  EXPECT_FALSE(reading.the_case);
  const std::string start = path.native() + ": ";
  EXPECT_TRUE(reading.problems.front().starts_with(start)) << reading.problems.front();
  return reading.problems.front().substr(start.size());
}

TEST(CaseInput, FileIsRead) {
  const TemporaryFolder folder;
  const CaseReading reading = read_case_file(folder.file("x.toml", write_case(bouncing_ball())));
  ASSERT_TRUE(reading.the_case) << reading.problems.front();
  EXPECT_EQ(test::bits(*reading.the_case), test::bits(bouncing_ball()));
}

TEST(CaseInput, SentencesStartWithThePath) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("x.toml", "name = 3");
  EXPECT_EQ(read_case_file(path).problems.back(),
            path.native() + ":1: name = 3: is an integer, must be a string that is not empty");
}

TEST(CaseInput, HugeSparseFileIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("huge.toml", "");
  fs::resize_file(path, 1U << 30U);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(sentence(path), "is 1073741824 bytes long, must be at most 1048576");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST(CaseInput, LongestFileIsReadAndOneByteMoreIsNot) {
  const TemporaryFolder folder;
  std::string text = write_case(bouncing_ball());
  while (text.size() < longest_case_file) {
    text += text.size() % 1000 == 0 ? "\n" : "#";
  }
  EXPECT_TRUE(read_case_file(folder.file("fits.toml", text)).the_case);
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
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(sentence(endless).empty());
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
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
  EXPECT_EQ(read_case_file("").problems, std::vector<std::string>{"\"\": no such file"});
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
  EXPECT_EQ(read_case_file("\x1b[2J.toml").problems.front(), "\\x1b[2J.toml: no such file");
}

}  // namespace
}  // namespace tautline::bench
