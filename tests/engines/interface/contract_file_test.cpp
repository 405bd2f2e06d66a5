// The exceptions in engines/<folder>/contract.toml: that the files are sound, and that an unsound
// one is refused.

#include <gtest/gtest.h>

#include "engines/engine_support.hpp"
#include "engines/interface/claims.hpp"

namespace tautline::test {
namespace {

const std::vector<std::string> models = {"row", "slide-joint"};

/// The problem of a file with this text.
std::string refusal(const std::string& text) {
  const bench::Contract file = bench::read_contract(text, "contract.toml", models);
  return file.problems.empty() ? "accepted" : file.problems.front();
}

TEST(ContractFile, TakesOneExceptionForEachClaim) {
  const bench::Contract file = bench::read_contract(
      "[[exception]]\nmodel = 'row'\nclaims = ['flight', 'convergence']\nreason = 'it is so'\n",
      "contract.toml", models);
  EXPECT_TRUE(file.problems.empty()) << file.problems.front();
  ASSERT_EQ(file.exceptions.size(), 2U);
  EXPECT_EQ(file.exceptions[1].model, "row");
  EXPECT_EQ(file.exceptions[1].claim, "convergence");
  EXPECT_EQ(file.exceptions[1].reason, "it is so");
}

TEST(ContractFile, MayBeOfOneOfTheEnginesThatShareItsFolder) {
  const bench::Contract file = bench::read_contract(
      "[[exception]]\nengine = 'chipmunk32'\nmodel = 'row'\nclaims = ['flight']\nreason = 'so'\n",
      "contract.toml", models);
  EXPECT_TRUE(file.problems.empty()) << file.problems.front();
  ASSERT_EQ(file.exceptions.size(), 1U);
  EXPECT_EQ(file.exceptions[0].engine, "chipmunk32");
  EXPECT_EQ(folder_of("bullet64"), folder_of("bullet32"));
  EXPECT_NE(folder_of("box2d"), folder_of("bullet32"));
}

TEST(ContractFile, RefusesWhatItDoesNotKnow) {
  const std::string row = "[[exception]]\nmodel = 'row'\nclaims = ['flight']\nreason = 'so'\n";
  EXPECT_EQ(refusal(row), "accepted");
  EXPECT_EQ(refusal(row + "since = 'ever'\n").rfind("contract.toml:5: exception[0].since", 0), 0U);
  EXPECT_EQ(refusal("[[exception]]\nmodel = 'row'\nclaims = ['flght']\nreason = 'so'\n"),
            "contract.toml:1: unknown claim flght; did you mean flight?");
  EXPECT_EQ(refusal("[[exception]]\nmodel = 'contact'\nclaims = ['flight']\nreason = 'so'\n"),
            "contract.toml:1: unknown model contact, must be row or slide-joint");
  EXPECT_NE(refusal("[[exception]]\nmodel = 'row'\nclaims = []\nreason = 'so'\n"), "accepted");
  EXPECT_NE(refusal("[[exception]]\nmodel = 'row'\nclaims = 'flight'\nreason = 'so'\n"),
            "accepted");
  EXPECT_NE(refusal("[[exception]]\nmodel = 'row'\nclaims = ['flight']\n"), "accepted");
  EXPECT_NE(refusal("[[exceptions]]\n"), "accepted");
  EXPECT_NE(refusal("exception = 1\n"), "accepted");
}

TEST(ContractFiles, AreSoundAndNameModelsThatThereAre) {
  for (const auto& path : contract_files()) {
    const std::string folder = path.parent_path().filename();
    std::vector<std::string> names;  // none where the engine is not built
    for (const ModelUnderTest& model : models_under_test()) {
      if (folder_of(model.engine) == path.parent_path()) {
        names.push_back(model.model);
      }
    }
    for (const std::string& problem : contract_of(folder, names).problems) {
      ADD_FAILURE() << problem;
    }
  }
}

TEST(EnginesOfTheBuild, AllAnswer) {
  for (const bench::RegisteredEngine& engine : engines_of_the_build()) {
    EXPECT_EQ(engine.failure, "") << engine.name;
    EXPECT_TRUE(engine.info || !engine.missing.empty()) << engine.name;
  }
}

}  // namespace
}  // namespace tautline::test
