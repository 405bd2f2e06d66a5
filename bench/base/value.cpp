#include "bench/base/value.hpp"

#include <algorithm>
#include <cstdlib>

#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// No line of a file needs to be longer [bytes]. The limit also bounds how deep `a.a.a = 1` can
/// nest: the parser takes such a table apart by recursion.
constexpr std::size_t longest_line = 4096;

/// Adds a finding for text that the parser need not see.
void check_lines(std::string_view text, FileProblems& wrong) {
  std::size_t line = 1;
  while (!text.empty() && wrong.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    if (text.substr(0, length).find('\0') != std::string_view::npos) {
      wrong.add(line, "holds a zero byte: must be a text file (TOML)");
    } else if (length > longest_line) {
      wrong.add(line, "is " + std::to_string(length) + " bytes long, a line has at most " +
                          std::to_string(longest_line));
    }
    text.remove_prefix(std::min(length + 1, text.size()));
    ++line;
  }
}

// No streams: in the module of JavaScript they would be a sixth of it.

/// At least `width` digits.
std::string digits(unsigned value, std::size_t width) {
  const std::string text = std::to_string(value);
  return std::string(width - std::min(width, text.size()), '0') + text;
}

std::string date_text(const toml::date& date) {
  return digits(date.year, 4) + "-" + digits(date.month, 2) + "-" + digits(date.day, 2);
}

std::string time_text(const toml::time& time) {
  std::string fraction = "." + digits(time.nanosecond, 9);
  fraction.resize(fraction.find_last_not_of("0.") + 1);
  return digits(time.hour, 2) + ":" + digits(time.minute, 2) + ":" + digits(time.second, 2) +
         fraction;
}

/// Of local time from UTC, in minutes.
std::string offset_text(int minutes) {
  const auto size = static_cast<unsigned>(std::abs(minutes));
  return minutes == 0
             ? "Z"
             : (minutes < 0 ? "-" : "+") + digits(size / 60, 2) + ":" + digits(size % 60, 2);
}

/// The value as the file has it: 1.2 or "text"; nothing for a table, which has lines of its own.
std::string value_text(const toml::node& node) {
  if (const auto* text = node.as_string()) {
    return "\"" + printable(text->get()) + "\"";
  }
  if (const auto* number = node.as_floating_point()) {
    return shortest(number->get());
  }
  if (const auto* number = node.as_integer()) {
    return std::to_string(number->get());
  }
  if (const auto* flag = node.as_boolean()) {
    return flag->get() ? "true" : "false";
  }
  if (const auto* date = node.as_date()) {
    return date_text(date->get());
  }
  if (const auto* time = node.as_time()) {
    return time_text(time->get());
  }
  if (const auto* both = node.as_date_time()) {
    const toml::date_time& instant = both->get();
    return date_text(instant.date) + "T" + time_text(instant.time) +
           (instant.offset ? offset_text(instant.offset->minutes) : "");
  }
  return "";
}

}  // namespace

std::optional<toml::table> parse_toml(std::string_view text, FileProblems& wrong) {
  check_lines(text, wrong);
  if (!wrong.empty()) {
    return std::nullopt;
  }
  const auto refuse = [&](const toml::parse_error& error) {
    wrong.add(error.source().begin.line, "column " + std::to_string(error.source().begin.column) +
                                             ": not TOML: " + printable(error.description()));
    return std::nullopt;
  };
#if TOML_EXCEPTIONS
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    return refuse(error);
  }
#else  // WebAssembly
  toml::parse_result result = toml::parse(text);
  if (!result) {
    return refuse(result.error());
  }
  return std::move(result).table();
#endif
}

std::size_t line_of(const toml::node* node) {
  return node != nullptr ? node->source().begin.line : 0;
}

std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

std::string quoted_value(const toml::node& node) {
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    return node.is_table() ? "" : " = " + value_text(node);
  }
  constexpr std::size_t quotable_entries = 6;
  if (array->size() > quotable_entries) {
    return "";
  }
  std::string entries;
  for (const toml::node& entry : *array) {
    if (!entry.is_value()) {
      return "";
    }
    entries += (entries.empty() ? "" : ", ") + value_text(entry);
  }
  return " = [" + entries + "]";
}

std::optional<double> as_number(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) {
    return number->get();
  }
  if (const auto* integer = node.as_integer()) {
    return static_cast<double>(integer->get());
  }
  return std::nullopt;
}

std::string toml_string(const std::string& text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      result += "\\u00";
      result += {digits[byte >> 4U], digits[byte & 0xFU]};
    } else {
      result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    }
  }
  return result + "\"";
}

}  // namespace tautline::bench
