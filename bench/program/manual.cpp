// The help of the program and of its commands, on a terminal and as manual pages.

#include "bench/program/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/table.hpp"

namespace tautline::bench {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

/// A longer name has a line of its own before its meaning [columns].
constexpr std::size_t longest_name = 24;

/// Names with their meanings next to them, which begin in one column.
std::string beside(const Rows& rows, std::size_t width) {
  std::size_t longest = 0;
  for (const auto& [name, meaning] : rows) {
    longest = std::max(longest, name.size() <= longest_name ? name.size() : 0);
  }
  const std::size_t start = 2 + std::max<std::size_t>(longest, 8) + 2;
  std::string result;
  for (const auto& [name, meaning] : rows) {
    std::istringstream lines(wrapped(meaning, width - start));
    result += "  " + name;
    std::size_t column = 2 + name.size();
    for (std::string line; std::getline(lines, line);) {
      const bool fits = column + 2 <= start;
      result += (fits ? std::string(start - column, ' ') : "\n" + std::string(start, ' ')) + line;
      column = width;
    }
    result += "\n";
  }
  return result;
}

std::string section(const std::string& title, const Rows& rows, std::size_t width) {
  return rows.empty() ? "" : "\n" + title + ":\n" + beside(rows, width);
}

Rows rows_of(const std::vector<Argument>& arguments) {
  Rows rows;
  for (const Argument& argument : arguments) {
    rows.emplace_back(spelling(argument), whole_meaning(argument));
  }
  return rows;
}

std::string example_lines(const std::string& examples, std::size_t width) {
  std::string result;
  std::istringstream lines(examples);
  for (std::string line; std::getline(lines, line);) {
    result += wrapped_lines("  " + line, width, 4);
  }
  return result.empty() ? "" : "\nexamples:\n" + result;
}

// Manual pages: roff with the macros of man(7).

/// What every page ends with, but for the names of the others.
constexpr const char* page_ending = R"(.SH EXIT STATUS
.TP
0
All is done.
.TP
1
A run failed, a claim does not hold, a gate was broken, something got worse, or a file could not be written.
.TP
2
The usage or the input is wrong; nothing was done.
.SH ENVIRONMENT
.TP
\fBTAUTLINE_ENGINE_PATH\fR
Folders in which plug\-ins are looked for, with a colon between them, instead of the program\(aqs own.
.TP
\fBNO_COLOR\fR
Where it is not empty, there are no colours on a terminal.
.TP
\fBCOLUMNS\fR
How wide the text is where it goes to no terminal: if it does not say, 80 columns, and of tables 100.
)";

/// Text in which roff reads nothing as its own. What stands between backquotes is bold.
std::string roff(const std::string& text) {
  static const std::map<char, std::string_view> escapes = {
      {'\\', "\\e"}, {'-', "\\-"}, {'\'', "\\(aq"}};
  std::string result = text.starts_with('.') ? "\\&" : "";  // a dot first would be a request
  bool bold = false;
  for (const char letter : text) {
    if (letter == '`') {
      bold = !bold;
      result += bold ? "\\fB" : "\\fR";
    } else if (const auto escape = escapes.find(letter); escape != escapes.end()) {
      result += escape->second;
    } else {
      result += letter;
    }
  }
  return result;
}

/// An indented paragraph below its name.
std::string item(const std::string& name, const std::string& meaning) {
  return ".TP\n" + name + "\n" + roff(meaning) + "\n";
}

/// The names of an argument in bold, its value in italics.
std::string roff_spelling(const Argument& argument) {
  const std::string font = argument.is_word() ? "\\fI" : "\\fB";
  const auto names =
      listed(argument.names, [&](const std::string& name) { return font + roff(name) + "\\fR"; });
  return fmt::format("{}{}", fmt::join(names, ", "),
                     argument.value.empty() ? "" : " \\fI" + argument.value + "\\fR");
}

std::string items(const std::string& heading, const std::vector<Argument>& arguments) {
  std::string result = ".SH " + heading + "\n";
  for (const Argument& argument : arguments) {
    result += item(roff_spelling(argument), whole_meaning(argument));
  }
  return result;
}

std::string page_name(const Command& command) { return "tautline-" + command.name; }

/// The page `name`, whose own part is `body`.
std::string page(const Outline& outline, const std::string& name, const std::string& summary,
                 const std::string& body, const std::string& examples) {
  std::string upper = name;
  std::transform(name.begin(), name.end(), upper.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  std::string lines;
  std::istringstream rest(examples);
  for (std::string line; std::getline(rest, line);) {
    lines += roff(line) + "\n";
  }
  std::vector<std::string> others = {"tautline"};
  for (const Command& command : outline.commands) {
    others.push_back(page_name(command));
  }
  std::erase(others, name);
  const auto also = listed(others, [](const auto& other) { return ".BR " + roff(other) + " (1)"; });
  return fmt::format(".TH {} 1 \"\" \"tautline " TAUTLINE_VERSION
                     "\" \"tautline\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}{}{}.SH SEE ALSO\n{}\n",
                     roff(upper), roff(name), roff(summary), body,
                     lines.empty() ? "" : ".SH EXAMPLES\n.nf\n" + lines + ".fi\n", page_ending,
                     fmt::join(also, ",\n"));
}

}  // namespace

std::string help_text(const Outline& outline, std::size_t width) {
  Rows commands;
  for (const Command& command : outline.commands) {
    commands.emplace_back(command.name, command.summary);
  }
  return wrapped(outline.summary, width) +
         "usage: tautline COMMAND [OPTIONS]\n"
         "       tautline --version | COMMAND --help\n" +
         section("commands", commands, width) + example_lines(outline.examples, width);
}

std::string help_text(const Command& command, std::size_t width) {
  const std::string words = words_of(command);
  return wrapped(command.summary + ".", width) + "\nusage: tautline " + command.name +
         (words.empty() ? "" : " " + words) + " [OPTIONS]\n" +
         (command.words.empty() ? "" : "\n" + beside(rows_of(command.words), width)) +
         section("options", rows_of(command.options), width) +
         example_lines(command.examples, width);
}

std::string man_page(const Outline& outline) {
  std::string body = "\\fBtautline\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH COMMANDS\n";
  for (const Command& command : outline.commands) {
    body += item("\\fB" + roff(page_name(command)) + "\\fR(1)", command.summary + ".");
  }
  return page(outline, "tautline", outline.summary, body + items("OPTIONS", outline.options),
              outline.examples);
}

std::string man_page(const Outline& outline, const Command& command) {
  std::string body = "\\fBtautline " + roff(command.name) + "\\fR ";
  for (const Argument& word : command.words) {
    const std::string name = roff_spelling(word) + (word.repeats ? "..." : "");
    body += word.required ? name + " " : "[" + name + "] ";
  }
  body += "[\\fIOPTIONS\\fR]\n" + (command.words.empty() ? "" : items("ARGUMENTS", command.words)) +
          items("OPTIONS", command.options);
  return page(outline, page_name(command), command.summary, body, command.examples);
}

}  // namespace tautline::bench
