// Indented to its leaves, a report is mostly blanks: its columns have a number a line.

#include "bench/report/compact_json.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// Objects this deep have a line for every key, tables one deeper a line for every row.
constexpr std::size_t deepest_object = 1;

bool has_lines(const ordered_json& value, std::size_t depth) {
  if (value.empty()) {
    return false;
  }
  if (value.is_object()) {
    return depth <= deepest_object;
  }
  return value.is_array() && value.front().is_object() && depth <= deepest_object + 1;
}

std::string on_one_line(const ordered_json& value) {
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void write(const ordered_json& value, std::size_t depth, std::string& out) {
  if (!has_lines(value, depth)) {
    out += on_one_line(value);
    return;
  }
  out += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, member] : value.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    out.append(depth + 1, ' ');
    if (value.is_object()) {
      out += on_one_line(key) + ": ";
    }
    write(member, depth + 1, out);
  }
  out += '\n';
  out.append(depth, ' ');
  out += value.is_object() ? '}' : ']';
}

}  // namespace

std::string compact_json(const ordered_json& report) {
  std::string out;
  write(report, 0, out);
  return out + "\n";
}

}  // namespace tautline::bench
