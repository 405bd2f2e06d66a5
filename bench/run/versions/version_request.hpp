#pragma once

#include <string>
#include <vector>

namespace tautline::bench {

/// Versions of an engine, as a command line asks for them: `planck@1.0..1.4.2`.
struct VersionRequest {
  std::string engine;   // its name, or the path of its engine.toml
  std::string range;    // as npm reads it: ">=1.0 <=1.4.2"; empty: what the engine.toml says
  std::string problem;  // a sentence where `text` is no request
};

/// Reads ENGINE, ENGINE@FROM..TO, ENGINE@FROM.., ENGINE@..TO or ENGINE@RANGE, where RANGE is npm's
/// own.
[[nodiscard]] VersionRequest version_request(const std::string& text);

/// Of `versions`, which rise, the newest of each minor version: 1.4.2 of 1.4.0 and 1.4.2.
[[nodiscard]] std::vector<std::string> newest_of_each_minor(
    const std::vector<std::string>& versions);

/// True where `one` is older. Which versions a range has is npm's to say; it lists them in any
/// order.
[[nodiscard]] bool is_older(const std::string& one, const std::string& other);

}  // namespace tautline::bench
