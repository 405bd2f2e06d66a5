// What the terminal that the program prints to can show.

#include "bench/base/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>

namespace tautline::bench {
namespace {

/// A table is not squeezed below this: a narrower terminal wraps its lines [columns].
constexpr std::size_t narrowest = 60;

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// The number that is all of `text`; none of what is no number.
std::optional<std::size_t> number_in(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                  : std::nullopt;
}

}  // namespace

TerminalStyle output_style() {
  TerminalStyle style;
  if (::isatty(STDOUT_FILENO) != 1) {
    if (const auto columns = number_in(variable("COLUMNS"))) {
      style.width = style.text = std::max(narrowest, *columns);
    }
    return style;
  }
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    style.width = style.text = std::max<std::size_t>(narrowest, size.ws_col);
  }
  const std::string_view kind = variable("TERM");
  style.colour = variable("NO_COLOR").empty() && !kind.empty() && kind != "dumb";
  return style;
}

std::string coloured(const std::string& text, Colour colour, const TerminalStyle& style) {
  if (!style.colour || text.empty() || colour == Colour::plain) {
    return text;
  }
  const char* code = "2";
  switch (colour) {
    case Colour::red:
      code = "31";
      break;
    case Colour::yellow:
      code = "33";
      break;
    case Colour::green:
      code = "32";
      break;
    case Colour::plain:
    case Colour::grey:
      break;
  }
  return "\033[" + std::string(code) + "m" + text + "\033[0m";
}

}  // namespace tautline::bench
