#pragma once

#include <string>

#include "tautline/impact.hpp"

namespace CLI {
class App;
}

namespace tautline::bench {

/// What a CASE may be.
inline constexpr const char* case_help =
    "a case file (TOML), the name of a shipped case, or a pattern of such names in quotes: "
    "'breakwater/19*'; `tautline cases` lists them";

/// What --law is for where an engine runs.
inline constexpr const char* law_help =
    "the law for impacts on several cables: of the exact motion, and of the models that can choose";

/// Adds --law to `command`, with what it is for. `law` must outlive it.
void add_law(CLI::App& command, ImpactLaw& law, const std::string& help);

/// Adds to `command` the option that says where to write: `help` is "write the list as JSON", or
/// what else. An empty name, as of an unset variable of a shell, is refused: it would write
/// nothing. `file` must outlive the command.
void add_target(CLI::App& command, const std::string& option, std::string& file,
                const std::string& help);

}  // namespace tautline::bench
