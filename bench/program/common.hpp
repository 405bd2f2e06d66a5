#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/cases/bench_case.hpp"
#include "bench/cases/catalogue.hpp"
#include "tautline/case.hpp"
#include "tautline/impact.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tautline::bench {

/// Exit codes of the program.
inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;  // a run failed or diverged, or a result could not be written
inline constexpr int exit_usage = 2;   // wrong usage or input

/// The cases that engines run of a selection: a system in the plane runs in the plane z = 0 of
/// space. Adds a sentence for each that `law` cannot solve.
[[nodiscard]] std::vector<BenchCase> bench_cases(CaseSelection selection, ImpactLaw law,
                                                 std::vector<std::string>& problems);

/// The one case that `argument` means; none, after complaining, if that is not one.
[[nodiscard]] std::optional<Case> one_case(const std::string& argument, CableSet taut = {});

/// Prints each sentence to standard error as "tautline: ...". True if there is one.
bool complain(const std::vector<std::string>& sentences);

/// Adds `more` to `sentences`.
void append(std::vector<std::string>& sentences, const std::vector<std::string>& more);

/// What is wrong with a file that `option` names, before anything is done for it: its folder is not
/// there. Nothing is wrong with "-", with none (""), or where the folder is `made`, which the
/// command makes.
[[nodiscard]] std::vector<std::string> missing_folder(const std::string& option,
                                                      const std::string& file,
                                                      const std::filesystem::path& made = {});

/// Writes `text` to the file `target`, or to standard output for "-". Makes no folder.
void write_output(const std::string& target, const std::string& text);

/// Both ends of "0.05..2"; none if it is no range above zero.
[[nodiscard]] std::optional<std::pair<double, double>> positive_range(const std::string& text);

/// What a CASE may be.
inline constexpr const char* case_help =
    "a case file (TOML), the name of a shipped case, or a pattern of such names in quotes: "
    "'breakwater/19*'; `tautline cases` lists them";

/// What --law is for where an engine runs.
inline constexpr const char* law_help =
    "the law for impacts on several cables, for the exact motion and for models that have a choice";

/// Adds --law to `command`, with what it is for. `law` must outlive it.
void add_law(CLI::App& command, ImpactLaw& law, const std::string& help);

/// Adds to `command` the option that says where to write: `help` is "write the list as JSON", or
/// what else. An empty name, as of an unset variable of a shell, is refused: it would write
/// nothing. `file` must outlive the command. Returns the option.
CLI::Option* add_target(CLI::App& command, const std::string& option, std::string& file,
                        const std::string& help);

/// The option --schema, which prints the JSON schema of what the command writes.
void add_schema(CLI::App& command, std::string (*schema)());

}  // namespace tautline::bench
