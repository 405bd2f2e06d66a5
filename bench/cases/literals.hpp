#pragma once

#include <map>
#include <string>
#include <string_view>

namespace tautline::bench {

/// The numbers of a file as they are written, with all their digits, by their place in it:
/// "body.mass", "cables[1].anchor[0]".
using Literals = std::map<std::string, std::string>;

/// Those of the text of a TOML file that are decimals; none where it is not TOML.
[[nodiscard]] Literals literals(std::string_view text);

/// Those of the case file that a command line names; none where it names no file.
[[nodiscard]] Literals literals_of(const std::string& argument);

}  // namespace tautline::bench
