#pragma once

#include <string>

#include "bench/program/manual/outline.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace tautline::bench {

/// What is wrong with a command line that `app` could not parse, in one sentence: with the name
/// that was likely meant, or with where the right ones stand.
[[nodiscard]] std::string mistake(const CLI::App& app, const CLI::ParseError& error);

/// That `word` is no command, likewise.
[[nodiscard]] std::string unknown_command(const std::string& word, const Outline& outline);

}  // namespace tautline::bench
