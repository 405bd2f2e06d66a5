#pragma once

#include <string>

#include "bench/base/terminal.hpp"
#include "bench/ensemble/output/words.hpp"

namespace tautline::bench {

/// For a terminal: the tables, and what they say.
[[nodiscard]] std::string ensemble_text(const EnsembleReport& report, const TerminalStyle& style);

/// The same as Markdown.
[[nodiscard]] std::string ensemble_markdown(const EnsembleReport& report);

/// As bench/ensemble/ensemble.schema.json describes it, indented, with a line break at its end.
[[nodiscard]] std::string ensemble_json(const EnsembleReport& report);

}  // namespace tautline::bench
