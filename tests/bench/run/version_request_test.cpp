#include "bench/tools/trend/versions.hpp"

#include <gtest/gtest.h>

namespace tautline::bench::test {
namespace {

using Texts = std::vector<std::string>;

TEST(VersionRequest, DotsAreARangeAsNpmReadsIt) {
  EXPECT_EQ(version_request("planck@1.0..1.4.2").range, ">=1.0 <=1.4.2");
  EXPECT_EQ(version_request("planck@1.0..").range, ">=1.0");
  EXPECT_EQ(version_request("planck@..2").range, "<=2");
  EXPECT_EQ(version_request("planck@^1.2").range, "^1.2") << "npm's own ranges stay as they are";
  EXPECT_EQ(version_request("planck").range, "") << "those of its engine.toml";
  EXPECT_EQ(version_request("./a@b/engine.toml@1").engine, "./a@b/engine.toml");
  for (const char* text : {"", "@1.0", "planck@", "planck@.."}) {
    EXPECT_NE(version_request(text).problem, "") << text;
  }
}

TEST(VersionRequest, VersionsAreInTheOrderOfTheirNumbers) {
  const Texts rising = {"0.9.12", "1.0.0-alpha", "1.0.0", "1.0.2", "1.0.10", "1.10.0", "2.0.0"};
  for (std::size_t index = 1; index < rising.size(); ++index) {
    EXPECT_TRUE(is_older(rising[index - 1], rising[index])) << rising[index];
    EXPECT_FALSE(is_older(rising[index], rising[index - 1])) << rising[index];
  }
}

TEST(VersionRequest, TheNewestOfEachMinorVersionStandsForIt) {
  EXPECT_EQ(newest_of_each_minor({"0.1.0", "0.1.9", "0.1.10", "0.2.0", "1.1.0", "1.1.1"}),
            (Texts{"0.1.10", "0.2.0", "1.1.1"}));
  EXPECT_EQ(newest_of_each_minor({}), Texts());
}

}  // namespace
}  // namespace tautline::bench::test
