// Help, manual pages and completion say what the command line takes: no option is missing.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

/// The manual and the scripts, written once.
const std::filesystem::path& share() {
  static const TemporaryFolder folder;
  static const int code = program({"help", "--write", folder.path().string()}).code;
  static const std::filesystem::path path = code == 0 ? folder.path() : "/no/such";
  return path;
}

/// The long options of each command, as the sources of the program add them.
std::map<std::string, std::set<std::string>> options_in_the_sources() {
  std::map<std::string, std::set<std::string>> result;
  const std::regex adds(R"re(add_subcommand\(\s*"([a-z-]+)"|void add_([a-z]+)_options\()re");
  const std::regex takes(
      R"re(add_(?:option|flag|target)\w*(?:<[^>]*>)?\((?:\*?command, )?\s*"(--[a-z,-]+)")re");
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(TAUTLINE_PROGRAM_SOURCES)) {
    const std::string text = content_of(entry.path().string());
    std::smatch command;
    if (entry.path().extension() != ".cpp" || !std::regex_search(text, command, adds)) {
      continue;
    }
    std::set<std::string>& options = result[command[1].matched ? command[1] : command[2]];
    for (std::sregex_iterator found(text.begin(), text.end(), takes), end; found != end; ++found) {
      std::istringstream names((*found)[1]);
      for (std::string name; std::getline(names, name, ',');) {
        options.insert(name);
      }
    }
    if (text.find("add_law(") != std::string::npos) {
      options.insert("--law");
    }
  }
  return result;
}

/// "--time-limit" as a page has it.
std::string in_roff(const std::string& option) {
  return std::regex_replace(option, std::regex("-"), "\\-");
}

TEST(Manual, HasEveryOptionOfEveryCommand) {
  const auto all = options_in_the_sources();
  ASSERT_GE(all.size(), 9U);
  const std::string overview = content_of((share() / "man/man1/tautline.1").string());
  std::size_t checked = 0;
  for (const auto& [command, options] : all) {
    const std::string page =
        content_of((share() / ("man/man1/tautline-" + command + ".1")).string());
    const std::string help = program({command, "--help"}).output;
    EXPECT_NE(overview.find("tautline\\-" + command), std::string::npos) << command;
    const std::string offers = "\n" + program({"--complete", command, "-"}).output;
    for (const std::string& option : options) {
      ++checked;
      EXPECT_NE(page.find("\\fB" + in_roff(option) + "\\fR"), std::string::npos)
          << command << " " << option;
      EXPECT_NE(help.find(option), std::string::npos) << command << " " << option;
      EXPECT_NE(offers.find("\n" + option + "\t"), std::string::npos) << command << " " << option;
    }
  }
  EXPECT_GE(checked, 40U);
}

bool here(const std::string& program_name) {
  return std::system(("command -v " + program_name + " >/dev/null 2>&1").c_str()) == 0;  // NOLINT
}

/// What a shell command prints, errors with it.
std::string printed_by(const std::string& command) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "out").string();
  static_cast<void>(std::system((command + " >'" + file + "' 2>&1").c_str()));  // NOLINT
  return content_of(file);
}

TEST(Manual, PagesAreReadWithoutAWarning) {
  if (!here("man") || !here("groff")) {
    GTEST_SKIP() << "man and groff are not here";
  }
  std::size_t pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(share() / "man/man1")) {
    const std::string file = entry.path().string();
    const std::string warnings =
        printed_by("{ LC_ALL=C.UTF-8 MANWIDTH=80 man -l --warnings '" + file + "' >/dev/null; }");
    EXPECT_EQ(warnings, "") << file;
    const std::string page = content_of(file);
    for (const char* part : {"NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "SEE ALSO"}) {
      EXPECT_NE(page.find(std::string("\n.SH ") + part + "\n"), std::string::npos) << file;
    }
    ++pages;
  }
  EXPECT_GE(pages, 10U);
}

/// The installed script of each shell.
const std::map<std::string, std::string> scripts = {
    {"bash", "bash-completion/completions/tautline"},
    {"zsh", "zsh/site-functions/_tautline"},
    {"fish", "fish/vendor_completions.d/tautline.fish"}};

/// What `shell` prints that runs `text` after its script, with the program in PATH, in a folder
/// with a few files.
std::string said(const std::string& shell, const std::string& text) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "here");
  for (const char* file : {"a b.json", "case.toml", "it.so"}) {
    std::ofstream(folder.path() / file) << "\n";
  }
  const std::string bin = std::filesystem::path(TAUTLINE_PROGRAM_PATH).parent_path().string();
  const std::string script =
      "cd '" + folder.path().string() + "'\n" +
      (shell == "fish" ? "set -x PATH '" + bin + "' $PATH\n" : "PATH='" + bin + "':$PATH\n") + text;
  const std::string no_start = shell == "bash" ? " --norc '" : shell == "zsh" ? " -f '" : " -N '";
  return printed_by(shell + no_start + folder.file("complete.sh", script).string() + "'");
}

std::string script_of(const std::string& shell) { return (share() / scripts.at(shell)).string(); }

/// What bash offers for a command line, whose last word is the one that is being typed.
std::string offered(const std::vector<std::string>& words) {
  std::string line = "source '" + script_of("bash") + "'; COMP_WORDS=(tautline";
  for (const std::string& word : words) {
    line += " '" + word + "'";
  }
  line += "); COMP_CWORD=" + std::to_string(words.size()) +
          "; _tautline; printf '%s\\n' \"${COMPREPLY[@]}\"";
  return said("bash", line);
}

TEST(Completion, OffersWhatFits) {
  if (!here("bash")) {
    GTEST_SKIP() << "bash is not here";
  }
  EXPECT_EQ(offered({"so"}), "solve\n");
  EXPECT_EQ(offered({"solve", "--pl"}), "--plot\n");
  EXPECT_EQ(offered({"solve", "bouncing"}), "bouncing-ball\n");
  EXPECT_EQ(offered({"solve", "two-b"}), "two-bodies\n");
  EXPECT_EQ(offered({"cases", "two-b"}), "two-bodies\n");
  EXPECT_EQ(offered({"run", "two-b"}), "\n") << "engines run cases alone";
  EXPECT_EQ(offered({"ensemble", "spec.toml", "--case", "bifi"}), "bifilar\n");
  EXPECT_EQ(offered({"run", "bouncing-ball", "--engine", "exa"}), "exact\n");
  EXPECT_EQ(offered({"run", "bouncing-ball", "--engine", "=", "exa"}), "exact\n");
  EXPECT_EQ(offered({"run", "--engine", "exact", "--model", "ev"}), "event\n");
  EXPECT_EQ(offered({"bench", "--models", "row,sampl"}), "row,sampled\n");
  EXPECT_EQ(offered({"bench", "--law", "po"}), "poisson\n");
  EXPECT_EQ(offered({"bench", "--law", "="}), "energetic\npoisson\nsequential\nsimultaneous\n");
  EXPECT_EQ(offered({"help", "rep"}), "reproduce\n");
  EXPECT_EQ(offered({"solve", "bouncing-ball", "--json", "a"}), "a b.json\n");
  EXPECT_EQ(offered({"solve", "case"}), "case.toml\n");
  EXPECT_EQ(offered({"check", "it"}), "it.so\n");
  EXPECT_EQ(offered({"bench", "--out", ""}), "here\n");
  EXPECT_NE(offered({""}).find("compare\n"), std::string::npos);
  EXPECT_EQ(offered({"solve", "--xy"}), "\n") << "nothing fits";
}

TEST(Completion, NeverComplains) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{},
                                             {"no-such", ""},
                                             {"bench", "--engines", "no-such", "--models", ""},
                                             {"run", "--engine", "./no-such.so", "--model", ""},
                                             {"--nope", "="}}) {
    std::vector<std::string> arguments = {"--complete"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = program(arguments);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.errors, "");
  }
}

TEST(Completion, FishOffersWhatFits) {
  if (!here("fish")) {
    GTEST_SKIP() << "fish is not here";
  }
  const auto offers = [](const std::string& line) {
    return said("fish", "source '" + script_of("fish") + "'\ncomplete -C '" + line + "'\n");
  };
  EXPECT_EQ(offers("tautline so").substr(0, 6), "solve\t");
  EXPECT_EQ(offers("tautline solve --pl").substr(0, 7), "--plot\t");
  EXPECT_EQ(offers("tautline solve bouncing-b").substr(0, 14), "bouncing-ball\t");
  EXPECT_EQ(offers("tautline run x --engine=exa"), "--engine=exact\n");
  EXPECT_EQ(offers("tautline bench --law po"), "poisson\n");
  EXPECT_EQ(offers("tautline solve x --json=case"), "--json=case.toml\n");
  EXPECT_EQ(offers("tautline bench --out her"), "here/\n");
}

TEST(Completion, ZshOffersWhatFits) {
  if (!here("zsh")) {
    GTEST_SKIP() << "zsh is not here";
  }
  // its own functions stand here for those of its completion, which want a terminal
  const auto offers = [](const std::string& words) {
    return said("zsh",
                "_describe() { print -l -- $offers }; _files() { print -r -- files $* }\n"
                "compset() { }\nwords=(tautline " +
                    words + "); CURRENT=$#words; PREFIX=$words[-1]\nsource '" + script_of("zsh") +
                    "'\n");
  };
  EXPECT_EQ(offers("run x --engine exact --model ''").substr(0, 6), "event:");
  EXPECT_EQ(offers("bench --law ''"), "energetic\npoisson\nsequential\nsimultaneous\n");
  EXPECT_EQ(offers("solve --json ''"), "\nfiles -g *\n");
  EXPECT_EQ(offers("bench --out ''"), "\nfiles -/\n");
}

TEST(Completion, ScriptsAreRightForTheirShells) {
  for (const auto& [shell, file] : scripts) {
    EXPECT_EQ(program({"help", "--completion", shell}).output,
              content_of((share() / file).string()));
    if (here(shell)) {
      EXPECT_EQ(printed_by(shell + " -n '" + (share() / file).string() + "'"), "") << shell;
    }
  }
}

}  // namespace
}  // namespace tautline::test
