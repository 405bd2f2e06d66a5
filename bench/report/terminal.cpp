// The answers of a report on a terminal: as many columns as fit, and the verdict in a word.

#include "bench/report/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <tuple>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/report/tables.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;
using Key = std::tuple<std::string, std::string, double>;  // engine, model, step

Key key_of(const ordered_json& row) {
  return {row.at("engine"), row.at("model"), row.at("step").get<double>()};
}

/// What the verdicts on one engine, model and step come to, the worst first.
enum class Word { failed, flagged, known, unsupported, informative, pass, none };
constexpr const char* words[] = {"failed",      "flagged", "known", "unsupported",
                                 "informative", "pass",    ""};

Word word_of(const ordered_json& run) {
  if (run.at("status") == "failed" || run.at("status") == "diverged") {
    return Word::failed;
  }
  const ordered_json verdict = run.value("verdict", ordered_json(nullptr));
  if (!verdict.is_object()) {
    return Word::none;
  }
  if (verdict.at("word") != "deviation-flagged") {
    return verdict.at("word") == "pass"          ? Word::pass
           : verdict.at("word") == "unsupported" ? Word::unsupported
                                                 : Word::informative;
  }
  const auto& checks = verdict.at("checks");
  const bool all_known = std::all_of(checks.begin(), checks.end(), [](const ordered_json& check) {
    return check.at("holds").get<bool>() || check.at("known").get<bool>();
  });
  return all_known ? Word::known : Word::flagged;
}

/// The worst word of some runs, and how many have it.
struct Tally {
  Word worst = Word::none;
  std::size_t count = 0;
  std::size_t runs = 0;

  void add(Word word) {
    count = word == worst ? count + 1 : word < worst ? 1 : count;
    worst = std::min(worst, word);
    ++runs;
  }
  [[nodiscard]] std::string text() const {
    const std::string word = words[static_cast<std::size_t>(worst)];
    return count == runs ? word : fmt::format("{} {}/{}", word, count, runs);
  }
};

std::map<Key, Tally> tallies(const ordered_json& report) {
  std::map<Key, Tally> result;
  for (const ordered_json& run : report.at("runs")) {
    result[key_of(run)].add(word_of(run));
  }
  return result;
}

Colour colour_of(Word word) {
  switch (word) {
    case Word::failed:
    case Word::flagged:
      return Colour::red;
    case Word::known:
      return Colour::yellow;
    case Word::pass:
      return Colour::green;
    case Word::unsupported:
    case Word::informative:
    case Word::none:
      break;
  }
  return Colour::grey;
}

/// Two digits are what an error is good for.
std::string error_text(const ordered_json& value) {
  return value.is_number() ? fmt::format("{:.1e}", value.get<double>()) : "–";
}

std::string median(const ordered_json& pair) {
  return pair.is_object() ? error_text(pair.at("median")) : "–";
}

struct Column {
  const char* heading;
  int rank;  // the higher, the sooner it is left out
  std::string (*cell)(const ordered_json& row);
};

std::string impacts_text(const ordered_json& row) {
  const ordered_json& impacts = row.at("impacts");
  return fmt::format("{}/{}", impacts.at("matched").get<int>(), impacts.at("exact").get<int>());
}

/// The columns in the order in which they stand; the verdict comes behind them.
const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      {"engine", 0, [](const ordered_json& row) { return report_text(row.at("engine")); }},
      {"model", 0, [](const ordered_json& row) { return report_text(row.at("model")); }},
      {"step", 0,
       [](const ordered_json& row) { return fmt::format("{:g}", row.at("step").get<double>()); }},
      {"early", 0, [](const ordered_json& row) { return median(row.at("early_position_error")); }},
      {"horizon", 3,
       [](const ordered_json& row) { return median(row.at("horizon_position_error")); }},
      {"impacts", 1, impacts_text},
      {"e error", 2,
       [](const ordered_json& row) { return error_text(row.at("worst_restitution_error")); }},
      {"stretch", 5, [](const ordered_json& row) { return error_text(row.at("overstretch")); }},
      {"gain", 4, [](const ordered_json& row) { return error_text(row.at("energy_gain")); }},
  };
  return all;
}

/// The table with the columns up to `rank`, without colour.
std::string table_text(const ordered_json& report, const std::map<Key, Tally>& verdicts, int rank) {
  std::vector<std::string> headings;
  for (const Column& column : columns()) {
    if (column.rank <= rank) {
      headings.emplace_back(column.heading);
    }
  }
  headings.emplace_back("verdict");
  Table table(headings, 2, 1);
  for (const ordered_json& row : report.at("summary")) {
    std::vector<std::string> cells;
    for (const Column& column : columns()) {
      if (column.rank <= rank) {
        cells.push_back(column.cell(row));
      }
    }
    cells.push_back(verdicts.at(key_of(row)).text());
    table.add(std::move(cells));
  }
  return table.plain();
}

std::size_t width_of(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) {
    widest = std::max(widest, terminal_width(line));
  }
  return widest;
}

/// Colours the verdict that ends each line but the first.
std::string with_colours(const std::string& text, const ordered_json& report,
                         const std::map<Key, Tally>& verdicts, const TerminalStyle& style) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  std::string result = line + "\n";
  for (const ordered_json& row : report.at("summary")) {
    const Tally& tally = verdicts.at(key_of(row));
    std::getline(lines, line);
    const std::string word = tally.text();
    result += line.substr(0, line.size() - word.size()) +
              coloured(word, colour_of(tally.worst), style) + "\n";
  }
  return result;
}

}  // namespace

std::string terminal_answers(const ordered_json& report, const TerminalStyle& style) {
  const auto verdicts = tallies(report);
  int rank = 5;  // of the first to go
  std::string text = table_text(report, verdicts, rank);
  while (rank > 0 && width_of(text) > style.width) {
    text = table_text(report, verdicts, --rank);
  }
  std::string left_out;
  for (const Column& column : columns()) {
    if (column.rank > rank) {
      left_out += fmt::format("{}{}", left_out.empty() ? "" : ", ", column.heading);
    }
  }
  return with_colours(text, report, verdicts, style) +
         (left_out.empty() ? "" : "not shown at this width: " + left_out + "\n");
}

}  // namespace tautline::bench
