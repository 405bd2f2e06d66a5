#include "engines/interface/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace tautline::test {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& engine) {
  const fs::path own = fs::path(TAUTLINE_ENGINE_SOURCES) / engine;
  return fs::exists(own) ? own
                         : own.parent_path() / engine.substr(0, engine.find_first_of("0123456789"));
}

bench::Contract contract_of(const std::string& engine, std::span<const std::string> models) {
  const fs::path path = folder_of(engine) / "contract.toml";
  bench::Contract contract = bench::contract_beside(path, "", models);
  std::erase_if(contract.exceptions, [&](const bench::Exception& row) {
    return !row.engine.empty() && row.engine != engine;
  });
  return contract;
}

std::vector<fs::path> contract_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(TAUTLINE_ENGINE_SOURCES)) {
    if (fs::exists(entry.path() / "contract.toml")) {
      files.push_back(entry.path() / "contract.toml");
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void expect_claim(const std::string& engine, const std::string& model, std::string_view claim,
                  double reached, double allowed) {
  std::cout << "  " << claim << ": reached " << reached << ", allowed " << allowed << '\n';
  testing::Test::RecordProperty(std::string(claim), std::to_string(reached));
  const bench::Contract contract = contract_of(engine, {});
  ASSERT_TRUE(contract.problems.empty()) << contract.problems.front();
  const auto exception = std::find_if(
      contract.exceptions.begin(), contract.exceptions.end(),
      [&](const bench::Exception& row) { return row.model == model && row.claim == claim; });
  if (exception == contract.exceptions.end()) {
    EXPECT_LE(reached, allowed) << claim;
  } else {
    EXPECT_GT(reached, allowed) << claim << " holds now, although: " << exception->reason
                                << "; take it out of "
                                << (folder_of(engine) / "contract.toml").string();
  }
}

}  // namespace tautline::test
