// Manual pages: roff with the macros of man(7).

#include "bench/program/manual/manual.hpp"

#include <cstddef>
#include <sstream>
#include <vector>

namespace tautline::bench {
namespace {

/// Text in which roff reads nothing as its own. What stands between backquotes is bold.
std::string roff(const std::string& text) {
  std::string result;
  bool bold = false;
  for (const char letter : text) {
    switch (letter) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '`':
        bold = !bold;
        result += bold ? "\\fB" : "\\fR";
        break;
      default:
        result += letter;
    }
  }
  // a line that begins with a dot would be a request
  return result.starts_with('.') ? "\\&" + result : result;
}

std::string heading(const std::string& name) {
  std::string upper = name;
  for (char& letter : upper) {
    letter = letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  }
  return ".TH " + roff(upper) + " 1 \"\" \"tautline " TAUTLINE_VERSION "\" \"tautline\"\n";
}

std::string name_section(const std::string& name, const std::string& summary) {
  return ".SH NAME\n" + roff(name) + " \\- " + roff(summary) + "\n";
}

/// An indented paragraph below its name.
std::string item(const std::string& name, const std::string& meaning) {
  return ".TP\n" + name + "\n" + roff(meaning) + "\n";
}

/// The names of an argument in bold, its value in italics.
std::string roff_spelling(const Argument& argument) {
  std::string result;
  for (const std::string& name : argument.names) {
    result += (result.empty() ? "" : ", ") +
              (argument.is_word() ? "\\fI" + roff(name) + "\\fR" : "\\fB" + roff(name) + "\\fR");
  }
  return result + (argument.value.empty() ? "" : " \\fI" + argument.value + "\\fR");
}

std::string items(const std::vector<Argument>& arguments) {
  std::string result;
  for (const Argument& argument : arguments) {
    result += item(roff_spelling(argument), whole_meaning(argument));
  }
  return result;
}

std::string examples_part(const std::string& examples) {
  if (examples.empty()) {
    return "";
  }
  std::string result = ".SH EXAMPLES\n.nf\n";
  std::istringstream lines(examples);
  for (std::string line; std::getline(lines, line);) {
    result += roff(line) + "\n";
  }
  return result + ".fi\n";
}

std::string exit_section() {
  return ".SH EXIT STATUS\n" + item("0", "All is done.") +
         item("1",
              "A run failed, a claim does not hold, a gate was broken, something got worse, or a "
              "file could not be written.") +
         item("2", "The usage or the input is wrong; nothing was done.");
}

std::string environment_section() {
  return ".SH ENVIRONMENT\n" +
         item("\\fBTAUTLINE_ENGINE_PATH\\fR",
              "Folders in which plug-ins are looked for, with a colon between them, instead of the "
              "program's own.") +
         item("\\fBNO_COLOR\\fR", "Where it is not empty, there are no colours on a terminal.") +
         item("\\fBCOLUMNS\\fR",
              "How wide the text is where it goes to no terminal: if it does not say, 80 columns, "
              "and of "
              "tables 100.");
}

std::string page_name(const Command& command) { return "tautline-" + command.name; }

/// All pages but `own`.
std::string see_also(const Outline& outline, const std::string& own) {
  std::vector<std::string> pages = {"tautline"};
  for (const Command& command : outline.commands) {
    pages.push_back(page_name(command));
  }
  std::erase(pages, own);
  std::string result = ".SH SEE ALSO\n";
  for (std::size_t place = 0; place < pages.size(); ++place) {
    const bool last = place + 1 == pages.size();
    result += ".BR " + roff(pages[place]) + (last ? " (1)\n" : " (1),\n");
  }
  return result;
}

}  // namespace

std::string man_page(const Outline& outline) {
  std::string page = heading("tautline") + name_section("tautline", outline.summary) +
                     ".SH SYNOPSIS\n\\fBtautline\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n"
                     ".SH COMMANDS\n";
  for (const Command& command : outline.commands) {
    page += item("\\fB" + roff(page_name(command)) + "\\fR(1)", command.summary + ".");
  }
  return page + ".SH OPTIONS\n" + items(outline.options) + examples_part(outline.examples) +
         exit_section() + environment_section() + see_also(outline, "tautline");
}

std::string man_page(const Outline& outline, const Command& command) {
  std::string page = heading(page_name(command)) +
                     name_section(page_name(command), command.summary) +
                     ".SH SYNOPSIS\n\\fBtautline " + roff(command.name) + "\\fR ";
  for (const Argument& word : command.words) {
    const std::string name = roff_spelling(word) + (word.repeats ? "..." : "");
    page += word.required ? name + " " : "[" + name + "] ";
  }
  page += "[\\fIOPTIONS\\fR]\n";
  if (!command.words.empty()) {
    page += ".SH ARGUMENTS\n" + items(command.words);
  }
  page += ".SH OPTIONS\n" + items(command.options) + examples_part(command.examples) +
          exit_section() + environment_section() + see_also(outline, page_name(command));
  return page;
}

}  // namespace tautline::bench
