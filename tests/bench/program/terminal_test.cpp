// What the program prints for a reader: short, in the width there is, the answer first.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "bench/base/table.hpp"
#include "bench/report/output.hpp"
#include "tests/bench/gate/made_report.hpp"
#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// A line of one word, such as the path of a folder, cannot be broken.
bool is_one_word(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first != std::string::npos && line.find(' ', first) == std::string::npos;
}

/// The longest line of `text` [columns] that could be broken.
std::string longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::string longest;
  for (std::string line; std::getline(lines, line);) {
    if (!is_one_word(line) && bench::terminal_width(line) > bench::terminal_width(longest)) {
      longest = line;
    }
  }
  return longest;
}

TEST(Terminal, WithoutACommandThereIsAShortHelpWithAllCommands) {
  const Outcome bare = program({});
  EXPECT_EQ(bare.code, 0) << "to ask for nothing is no mistake";
  EXPECT_EQ(bare.errors, "");
  for (const char* command :
       {"solve", "vector", "run", "bench", "compare", "trend", "ensemble", "bridge", "check",
        "calibrate", "reproduce", "engines", "cases", "help"}) {
    EXPECT_NE(bare.output.find(std::string("\n  ") + command + " "), std::string::npos) << command;
  }
  EXPECT_LE(lines_in(bare.output), 24U) << "a screen\n" << bare.output;
  EXPECT_EQ(program({"--help"}).output, bare.output);
  EXPECT_EQ(program({"help"}).output, bare.output);
  EXPECT_EQ(program({"help", "solve"}).output, program({"solve", "--help"}).output);
}

TEST(Terminal, TextFitsTheWidthThereIs) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "r").string();
  const std::vector<std::vector<std::string>> commands = {
      {},
      {"solve", "--help"},
      {"run", "--help"},
      {"bench", "--help"},
      {"compare", "--help"},
      {"trend", "--help"},
      {"ensemble", "--help"},
      {"help", "--help"},
      {"engines"},
      {"cases"},
      {"solve", "breakwater/1910121100"},
      {"solve", "breakwater/1910121100", "--at", "1,2", "--certify", "--digits", "30"},
      {"run", "bouncing-ball", "--engine", "exact", "--model", "event", "--all"},
      {"bench", "bouncing-ball", "--engines", "exact", "--steps", "1e-2", "--out", out}};
  for (const auto& [shell, width] :
       {std::pair<const char*, std::size_t>{"COLUMNS=80", 80}, {"", 100}, {"COLUMNS=60", 60}}) {
    for (const std::vector<std::string>& command : commands) {
      const bool is_long = command.size() > 5 && command[0] != "run";
      if (width != 80 && is_long) {
        continue;
      }
      const std::string longest = longest_line(program(command, shell).output);
      const bool is_a_path = longest.find(out) != std::string::npos;
      EXPECT_TRUE(bench::terminal_width(longest) <= width || is_a_path)
          << width << " columns: " << longest;
    }
  }
}

TEST(Terminal, SentencesHave80ColumnsWhereThereIsNoTerminal) {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{}, {"bench", "--help"}, {"compare", "--help"}}) {
    EXPECT_LE(bench::terminal_width(longest_line(program(command).output)), 80U);
  }
  const std::string solved = program({"solve", "breakwater/1910121100"}).output;
  const std::string summary = solved.substr(0, solved.find("event at"));
  const std::string last = longest_line(summary.substr(0, summary.rfind('\n')));
  EXPECT_LE(bench::terminal_width(last), 80U) << last;
}

TEST(Terminal, SolveSaysTheSummaryFirstAndFewEvents) {
  for (const bool plot : {false, true}) {
    const TemporaryFolder folder;
    std::vector<std::string> words = {"solve", "breakwater/1910121100"};
    if (plot) {
      words.insert(words.end(), {"--plot", (folder.path() / "p.svg").string()});
    }
    const std::string text = program(words).output;
    EXPECT_LT(text.find("The run reached its duration"), text.find("event at")) << text;
    EXPECT_LE(lines_in(text), 40U) << plot;
    EXPECT_NE(text.find("more: --events prints all"), std::string::npos) << text;
    words.emplace_back("--events");
    const std::string all = program(words).output;
    EXPECT_GT(lines_in(all), 100U);
    EXPECT_EQ(all.find("--events prints all"), std::string::npos);
  }
  // twenty are not cut, and none needs no table
  const std::string ball = program({"solve", "bouncing-ball", "--until", "2.7"}).output;
  EXPECT_EQ(ball.find("more: --events"), std::string::npos) << ball;
  EXPECT_EQ(program({"solve", "bouncing-ball", "--until", "0.5"}).output.find("event at"),
            std::string::npos);
}

TEST(Terminal, ARunIsACardWithItsVerdictAndTheMetricsThatMatter) {
  const std::vector<std::string> words = {
      "run", "breakwater/1910121100", "--engine", "exact", "--model", "event"};
  const Outcome card = program(words);
  EXPECT_EQ(card.code, 0) << card.errors;
  for (const char* part :
       {"breakwater/1910121100 on exact ", "model event, step 0.001 s\n", "verdict: sound\n",
        "Restitution: kept (", "Followed: position up to", "early position error", "overstretch",
        "energy gain", " m", " J", "--all prints all"}) {
    EXPECT_NE(card.output.find(part), std::string::npos) << part << "\nis not in\n" << card.output;
  }
  EXPECT_EQ(card.output.find('_'), std::string::npos) << "keys of files are no words";
  EXPECT_LE(lines_in(card.output), 24U) << card.output;
  std::vector<std::string> all = words;
  all.emplace_back("--all");
  EXPECT_NE(program(all).output.find("whole velocity error"), std::string::npos);
  std::vector<std::string> in_json = words;
  in_json.insert(in_json.end(), {"--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(program(in_json).output).at("verdict").at("word"), "sound");
}

TEST(Terminal, ARunWithProblemsSaysWhichAndWhy) {
  using namespace bench;
  Report report = bench::test::made_report();
  bench::test::add_engine(report, "e");
  RunRow& run = bench::test::add_run(report, "e", 0.5);
  run.verdict = Verdict();
  run.verdict->problems = {{"overstretch", "too long", 2.5, false, ""},
                           {"energy", "too fast", 3.5, true, "its spring"}};
  const std::string card = run_card(report, false, {80, false});
  for (const char* part :
       {"ball on e 1 (float64), model row, step 0.001 s\n", "Problem, overstretch: too long.\n",
        "Problem, energy: too fast. Listed: its spring.\n"}) {
    EXPECT_NE(card.find(part), std::string::npos) << part << "\nis not in\n" << card;
  }
}

TEST(Terminal, CompareOfOneReportAsksForAnother) {
  const Outcome outcome = program({"compare", "a.json"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.errors,
            "tautline: compare: a.json is one report; give two or more, the older first\n");
}

/// Every file and folder below `folder`, by its path from there.
std::set<std::string> tree(const std::filesystem::path& folder) {
  std::set<std::string> result;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    result.insert(std::filesystem::relative(entry.path(), folder).string());
  }
  return result;
}

TEST(Terminal, AFileInAFolderThatIsNotThereIsRefusedBeforeAnythingIsDone) {
  const TemporaryFolder folder;
  const std::string here = folder.path().string();
  const std::string missing = here + "/no/such/f.json";
  const std::vector<std::string> ball = {"bouncing-ball", "--engine", "exact"};
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"solve", "bouncing-ball", "--json", missing},
        {"solve", "bouncing-ball", "--plot", missing},
        {"run", "bouncing-ball", "--engine", "exact", "--model", "event", "--json", missing},
        {"run", "bouncing-ball", "--engine", "exact", "--model", "event", "--out", here + "/r",
         "--json", missing},
        {"bench", "bouncing-ball", "--engine", "exact", "--out", here + "/r", "--json", missing},
        {"compare", "/etc/hostname", "/etc/hostname", "--json", missing},
        {"check", "exact", "--json", missing},
        {"engines", "--json", missing},
        {"reproduce", "--out", here + "/r", "--json", missing},
        {"help", "--write", here + "/no/such"}}) {
    const Outcome outcome = program(words);
    EXPECT_EQ(outcome.code, 2) << words.front() << outcome.errors;
    EXPECT_NE(outcome.errors.find("folder"), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find(here + "/no/such"), std::string::npos) << outcome.errors;
    EXPECT_EQ(tree(folder.path()), std::set<std::string>()) << words.front();
  }
}

TEST(Terminal, NothingIsWrittenButWhatIsNamed) {
  const TemporaryFolder folder;
  // the folder of work, of the user and of passing files is one: whatever a command leaves is seen
  const std::string shell = "cd '" + folder.path().string() + "' && HOME=\"$PWD\" TMPDIR=\"$PWD\"";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"solve", "bouncing-ball"},
        {"run", "bouncing-ball", "--engine", "exact", "--model", "event"},
        {"engines"},
        {"cases"},
        {}}) {
    static_cast<void>(program(words, shell));
    EXPECT_EQ(tree(folder.path()), std::set<std::string>()) << (words.empty() ? "" : words[0]);
  }
  static_cast<void>(program({"bench", "bouncing-ball", "--engine", "exact", "--steps", "1e-2",
                             "--out", "r", "--json", "r/again.json"},
                            shell));
  for (const std::string& path : tree(folder.path())) {
    EXPECT_TRUE(path == "r" || path.starts_with("r/")) << path;
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "r/again.json"))
      << "a file in the folder that --out makes";
}

TEST(Terminal, BenchPrintsTheSchemaOfItsReport) {
  const Outcome schema = program({"bench", "--schema"});
  EXPECT_EQ(schema.code, 0) << schema.errors;
  const auto schema_json = nlohmann::json::parse(schema.output);
  EXPECT_TRUE(schema_json.contains("$schema"));
  EXPECT_NE(schema.output.find("early_position_error"), std::string::npos)
      << "the metrics are filled in";
}

}  // namespace
}  // namespace tautline::test
