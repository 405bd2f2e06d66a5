#pragma once

#include <cstddef>
#include <string>

namespace tautline::bench {

/// How to write to where standard output goes.
struct TerminalStyle {
  std::size_t width = 100;  // [columns], of tables
  bool colour = false;
  std::size_t text = 80;  // [columns], of sentences
};

/// For text that is as wide as it must be, without colours.
inline const TerminalStyle unlimited = {static_cast<std::size_t>(-1), false,
                                        static_cast<std::size_t>(-1)};

/// The style of standard output: the width of the terminal, and colours if it is one that has them
/// and the user has not said no (https://no-color.org). Without a terminal the width that the
/// environment variable COLUMNS says, or else the defaults.
[[nodiscard]] TerminalStyle output_style();

enum class Colour { plain, red, yellow, green, grey };

/// `text` in a colour, or as it is.
[[nodiscard]] std::string coloured(const std::string& text, Colour colour,
                                   const TerminalStyle& style);

}  // namespace tautline::bench
