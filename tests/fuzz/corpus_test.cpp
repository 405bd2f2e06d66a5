// Calls each target with the files of its corpus: the fuzzer's seeds and what it has found.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "bench/check/contract.hpp"
#include "bench/ensemble/spec_file.hpp"
#include "bench/gate/listed_problems.hpp"
#include "bench/report/json/json.hpp"
#include "bench/run/wire.hpp"
#include "bench/store/manifest.hpp"
#include "fuzz/targets.hpp"
#include "tautline/case_file.hpp"

namespace tautline::fuzz {
namespace {

const std::filesystem::path corpus = TAUTLINE_CORPUS;

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Target {
  const char* name;  // of its folder
  void (*run)(std::string_view);
};

class Corpus : public ::testing::TestWithParam<Target> {};

TEST_P(Corpus, IsReadAsPromised) {
  const std::filesystem::path folder = corpus / GetParam().name;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  ASSERT_FALSE(files.empty()) << folder;
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& path : files) {
    EXPECT_NO_THROW(GetParam().run(content(path))) << path;
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus,
                         ::testing::Values(Target{"files", fuzz_files},
                                           Target{"protocol", fuzz_protocol},
                                           Target{"reports", fuzz_reports},
                                           Target{"systems", fuzz_systems}),
                         [](const auto& one) { return std::string(one.param.name); });

/// A fuzzer that starts from a text which is refused at once does not get far. Where a form has
/// changed, write the seed again: those of reports come from `tautline bench`.
TEST(FuzzSeeds, AreAccepted) {
  const auto expect_none = [](const std::vector<std::string>& problems) {
    EXPECT_TRUE(problems.empty()) << problems.front();
  };
  const std::filesystem::path files = corpus / "files";
  expect_none(read_case_text(content(files / "case.toml"), "case.toml").problems);
  expect_none(read_system_text(content(files / "system.toml"), "system.toml").problems);
  expect_none(read_system_text(content(files / "elastic.toml"), "elastic.toml").problems);
  expect_none(bench::read_spec_text(content(files / "spec.toml"), "spec.toml").problems);
  expect_none(
      bench::read_problems_text(content(files / "problems.toml"), "problems.toml").problems);
  expect_none(bench::read_contract(content(files / "contract.toml"), "contract.toml", {}).problems);

  const std::filesystem::path reports = corpus / "reports";
  expect_none(bench::report_from(content(reports / "report.json"), "report.json").problems);
  EXPECT_TRUE(bench::manifest_from(content(reports / "suite.json")));
  EXPECT_TRUE(bench::record_from(content(reports / "record.json"), ""));

  std::size_t kind = 1;  // the first is a failure
  for (const char* name : {"info", "run", "check", "digest", "strikes", "system"}) {
    const std::string seed = content(corpus / "protocol" / (std::string("worker-") + name));
    const auto answer = bench::answer_from(std::string_view(seed).substr(1));
    ASSERT_TRUE(answer) << name;
    EXPECT_EQ(answer->index(), kind++) << name;
  }
}

}  // namespace
}  // namespace tautline::fuzz
