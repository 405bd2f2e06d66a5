#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/check/settle.hpp"

namespace tautline::bench {

struct Form;

/// What the contract tests of the engines here ask beyond the claims: how near a model is to the
/// exact motion. A contract file may name it; `tautline check` does not measure it.
inline constexpr std::string_view accuracy_claim = "accuracy";

/// A claim that a model is known not to keep, and why. It is asserted both ways: a model that
/// starts to keep it fails until it is taken out.
struct Exception {
  std::string engine;  // the one that it is of; empty: all of the folder
  std::string model;
  std::string claim;  // one of `claims`, `quiet` or `accuracy_claim`
  std::string reason;
};

/// What the file contract.toml beside an engine says, and what is wrong with it.
struct Contract {
  std::vector<Exception> exceptions;
  std::vector<std::string> problems;
};

/// `models` are those of `engine`; an exception of it that names another is a problem, and one of
/// another engine is left out. With no models all pass, with no engine all are taken.
[[nodiscard]] Contract read_contract(std::string_view text, const std::string& source_name,
                                     std::span<const std::string> models,
                                     std::string_view engine = "");

/// The keys of such a file.
[[nodiscard]] Form contract_form();

/// That of the file contract.toml in the folder of `plugin`; without exceptions where there is
/// none.
[[nodiscard]] Contract contract_beside(const std::filesystem::path& plugin, std::string_view engine,
                                       std::span<const std::string> models);

/// Marks what is known of `model` in `settled`.
void mark_known(const Contract& contract, std::string_view model,
                std::vector<SettledClaim>& settled);

}  // namespace tautline::bench
