#include "engines/interface/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "bench/base/input_file.hpp"
#include "bench/base/text.hpp"
#include "bench/base/toml/strict_table.hpp"
#include "bench/base/toml/value.hpp"
#include "bench/check/claims.hpp"

namespace tautline::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_contract = 1U << 20U;  // [bytes]
constexpr std::size_t most_exceptions = 1000;

std::vector<std::string> claim_names() {
  std::vector<std::string> names;
  for (const bench::Claim& claim : bench::claims()) {
    names.emplace_back(claim.name);
  }
  names.emplace_back(accuracy_claim);
  return names;
}

/// "unknown claim x; did you mean y?"
std::string unknown(const std::string& what, const std::string& name,
                    std::span<const std::string> known) {
  const std::string near = bench::suggestion(name, known);
  return "unknown " + what + " " + name +
         (near.empty() ? ", must be " + bench::joined(known, "or") : near);
}

/// One [[exception]] that starts at `line`.
void read_exception(bench::StrictTable& table, std::size_t line,
                    std::span<const std::string> models, bench::FileProblems& wrong,
                    std::vector<Exception>& exceptions) {
  const std::string engine = table.optional_text("engine").value_or("");
  const std::string model = table.text("model");
  const std::string reason = table.text("reason");
  if (!models.empty() && std::find(models.begin(), models.end(), model) == models.end()) {
    wrong.add(line, unknown("model", model, models));
  }
  for (const std::string& name : table.texts("claims", "must be an array of claims")) {
    if (bench::find_claim(name) != nullptr || name == accuracy_claim) {
      exceptions.push_back({engine, model, name, reason});
    } else {
      wrong.add(line, unknown("claim", name, claim_names()));
    }
  }
  table.refuse_unknown_keys();
}

}  // namespace

ContractFile read_contract(std::string_view text, const std::string& source_name,
                           std::span<const std::string> models) {
  bench::FileProblems wrong(source_name);
  ContractFile result;
  if (const std::optional<toml::table> file = bench::parse_toml(text, wrong)) {
    bench::StrictTable root(&*file, "", wrong);
    std::size_t index = 0;
    for (bench::StrictTable& table : root.tables("exception", most_exceptions,
                                                 "must be tables with model, claims and reason")) {
      const std::size_t line = bench::line_of((*file)["exception"][index++].node());
      read_exception(table, line, models, wrong, result.exceptions);
    }
    root.refuse_unknown_keys();
  }
  result.problems = wrong.sentences();
  return result;
}

fs::path folder_of(const std::string& engine) {
  const fs::path own = fs::path(TAUTLINE_ENGINE_SOURCES) / engine;
  return fs::exists(own) ? own
                         : own.parent_path() / engine.substr(0, engine.find_first_of("0123456789"));
}

ContractFile contract_of(const std::string& engine, std::span<const std::string> models) {
  const fs::path path = folder_of(engine) / "contract.toml";
  if (!fs::exists(path)) {
    return {};
  }
  const bench::InputFile file = bench::read_input_file(path, longest_contract);
  if (file.problem) {
    return {{}, {path.string() + ": " + *file.problem}};
  }
  ContractFile contract = read_contract(file.content, path.string(), models);
  std::erase_if(contract.exceptions,
                [&](const Exception& row) { return !row.engine.empty() && row.engine != engine; });
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
  const ContractFile contract = contract_of(engine, {});
  ASSERT_TRUE(contract.problems.empty()) << contract.problems.front();
  const auto exception =
      std::find_if(contract.exceptions.begin(), contract.exceptions.end(),
                   [&](const Exception& row) { return row.model == model && row.claim == claim; });
  if (exception == contract.exceptions.end()) {
    EXPECT_LE(reached, allowed) << claim;
  } else {
    EXPECT_GT(reached, allowed) << claim << " holds now, although: " << exception->reason
                                << "; take it out of "
                                << (folder_of(engine) / "contract.toml").string();
  }
}

}  // namespace tautline::test
