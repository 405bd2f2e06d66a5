#include "bench/base/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::names_in;
using test::TemporaryFolder;
using Strings = std::vector<std::string>;

/// The sentence write_file fails with; "" if it does not fail.
std::string failure(const fs::path& path, std::string_view content) {
  try {
    write_file(path, content);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

/// Lets no file grow beyond `bytes`, as on a disk that fills up in the middle of a write.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST(WriteFile, CreatesParentFoldersAndLeavesNothingElse) {
  const TemporaryFolder folder;
  write_file(folder.path() / "a" / "b" / "c.txt", "content\n");
  EXPECT_EQ(content_of(folder.path() / "a" / "b" / "c.txt"), "content\n");
  EXPECT_EQ(names_in(folder.path() / "a" / "b"), Strings{"c.txt"});
}

TEST(WriteFile, WritesTheSameWithoutWaitingForTheDisk) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a" / "old.txt";
  write_file_soon(path, "content\n");
  EXPECT_EQ(content_of(path), "content\n");
  write_file_soon(path, "new");
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(names_in(folder.path() / "a"), Strings{"old.txt"});
}

TEST(WriteFile, ReplacesWhatIsThere) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("old.txt", "a longer content than the new one");
  write_file(path, "new");
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(names_in(folder.path()), Strings{"old.txt"});
}

TEST(WriteFile, GivesANewFileTheUsualRights) {
  const TemporaryFolder folder;
  const mode_t mask = ::umask(027);
  write_file(folder.path() / "x", "");
  ::umask(mask);
  EXPECT_EQ(fs::status(folder.path() / "x").permissions(), static_cast<fs::perms>(0640));
}

TEST(WriteFile, TakesARelativePathWithoutAFolder) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  write_file("x", "content");
  fs::current_path(before);
  EXPECT_EQ(content_of(folder.path() / "x"), "content");
}

TEST(WriteFile, WritesThroughALink) {
  const TemporaryFolder folder;
  const fs::path target = folder.file("target", "old");
  fs::create_symlink(target, folder.path() / "link");
  write_file(folder.path() / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(content_of(target), "new");
}

TEST(WriteFile, NeverReplacesADevice) {
  write_file("/dev/null", "content");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteFile, NamesThePathAndTheReason) {
  const TemporaryFolder folder;
  const std::string name = folder.path().native();
  EXPECT_EQ(failure(folder.path(), "x"), "cannot write " + name + ": Is a directory");
  const fs::path file = folder.file("file", "");
  EXPECT_EQ(failure(file / "x", "x"), "cannot write " + name + "/file/x: Not a directory");
  EXPECT_EQ(failure(folder.path() / std::string(300, 'x'), "x").substr(0, 13), "cannot write ");
  EXPECT_EQ(names_in(folder.path()), Strings{"file"});
}

TEST(WriteFile, SaysThatADeviceIsFull) {
  if (!fs::exists("/dev/full")) {
    GTEST_SKIP() << "no /dev/full here";
  }
  EXPECT_EQ(failure("/dev/full", "x"), "cannot write /dev/full: No space left on device");
}

TEST(WriteFile, KeepsTheOldFileWhenTheDiskFillsUp) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("kept", "old");
  std::string sentence;
  {
    const FileSizeLimit limit(1000);
    sentence = failure(path, std::string(100'000, 'x'));
  }
  EXPECT_EQ(sentence, "cannot write " + path.native() + ": File too large");
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(names_in(folder.path()), Strings{"kept"});
}

TEST(WriteFile, NeverShowsAReaderHalfAFile) {
  const TemporaryFolder folder;
  const std::string one(200'000, '1');
  const std::string two(300'000, '2');
  const fs::path path = folder.file("shared", one);
  std::atomic<bool> done = false;
  std::thread writer([&] {
    for (int round = 0; round < 40; ++round) {
      write_file(path, round % 2 == 0 ? two : one);
    }
    done = true;
  });
  int torn = 0;
  while (!done) {
    const std::string content = content_of(path);
    torn += content == one || content == two ? 0 : 1;
  }
  writer.join();
  EXPECT_EQ(torn, 0);
}

TEST(WriteFile, LetsSeveralThreadsWriteIntoOneFolder) {
  const TemporaryFolder folder;
  std::vector<std::thread> writers;
  writers.reserve(8);
  for (int index = 0; index < 8; ++index) {
    writers.emplace_back([&folder, index] {
      write_file(folder.path() / std::to_string(index), std::string(1000, 'x'));
    });
  }
  for (std::thread& writer : writers) {
    writer.join();
  }
  EXPECT_EQ(names_in(folder.path()).size(), 8U);
}

}  // namespace
}  // namespace tautline::bench
