#include "bench/base/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/base/html.hpp"

namespace tautline::test {
namespace {

using bench::Cell;
using bench::Colour;
using bench::Column;
using bench::number_cell;
using bench::Row;
using bench::Table;

/// Two bodies, two grouped columns, one that goes first, and a row that spans.
Table table_of_errors() {
  Table table({{"engine", "", "", "engine", "", false, 0},
               {"median", "m", "error", "error", "error", true, 0},
               {"worst", "m", "error", "error-worst", "", true, 2},
               {"cost", "", "", "cost", "", true, 1},
               {"verdict", "", "", "verdict", "", false, 0}});
  Cell verdict = "pass";
  verdict.kind = "verdict pass";
  verdict.colour = Colour::green;
  verdict.notes = {"gain 1 J, limit 2 J", "e 3, limit 4"};
  table.add(Row{{"exact", number_cell(0.0, bench::as_error), number_cell(1.24e-5, bench::as_error),
                 number_cell(1.0, bench::fixed(1)), verdict},
                "",
                "control"});
  table.add(Row{{"<b>", number_cell(std::nullopt, bench::as_error),
                 number_cell(-0.5, bench::as_error), number_cell(1234567.0, bench::as_count), "–"},
                "failed",
                ""});
  table.add(Row{{"gone", "not here: no library"}, "", "missing"});
  return table;
}

TEST(Table, ReadsTheSameRenderedAndRawInMarkdown) {
  EXPECT_EQ("\n" + table_of_errors().markdown(), R"(
| engine | error: median [m] | error: worst [m] |    cost | verdict                                 |
| ------ | ----------------: | ---------------: | ------: | --------------------------------------- |
| exact  |                 0 |          1.2e-05 |     1.0 | pass: gain 1 J, limit 2 J; e 3, limit 4 |
| \<b\>  |                 – |         -5.0e-01 | 1234567 | –                                       |
| gone   |                 – |                – |       – | not here: no library                    |
)");
}

TEST(Table, LinesUpOnATerminal) {
  EXPECT_EQ("\n" + table_of_errors().plain(), R"(
engine  error  error: worst     cost  verdict
exact       0       1.2e-05      1.0  pass: gain 1 J, limit 2 J; e 3, limit 4
<b>         –      -5.0e-01  1234567  –
gone    not here: no library
)");
}

TEST(Table, LeavesOutTheColumnsOfTheHighestRankAndNamesThem) {
  const Table table = table_of_errors();
  const std::string two = table.plain({70, false});
  EXPECT_EQ(two.substr(0, two.find('\n')), "engine  error     cost  verdict");
  EXPECT_NE(two.find("\nnot shown at this width: error: worst\n"), std::string::npos) << two;
  const std::string none = table.plain({20, false});
  EXPECT_EQ(none.substr(0, none.find('\n')), "engine  error  verdict") << "rank 0 never goes";
  EXPECT_NE(none.find("gone    not here: no library\n"), std::string::npos) << none;
}

TEST(Table, ColoursWordsAndNotTheirPadding) {
  Table table({{"verdict", "", "", "", "", false, 0}, {"n", "", "", "", "", true, 0}});
  Cell cell = "pass";
  cell.colour = Colour::green;
  table.add({cell, number_cell(1.0, bench::as_count)});
  EXPECT_EQ(table.plain({80, true}), "verdict  n\n\033[32mpass\033[0m     1\n");
}

TEST(Table, KeepsEveryDigitOnAPage) {
  const std::string html = bench::html_table(table_of_errors(), "errors", "All *errors*.");
  for (const std::string part : {
           "<caption id=\"errors-caption\">All <em>errors</em>.</caption>",
           "<th scope=\"col\" data-key=\"engine\" rowspan=\"2\">engine</th>",
           "<th scope=\"colgroup\" colspan=\"2\">error</th>",
           "<th scope=\"col\" class=\"n\" data-key=\"error-worst\">worst <span "
           "class=\"unit\">[m]</span></th>",
           "<tbody class=\"control\">\n<tr><th scope=\"row\">exact</th>",
           "<td data-value=\"1.24e-05\">1.2e-05</td>",
           "<td class=\"verdict pass\"><span>pass</span><br>gain 1 J, limit 2 J<br>e 3, limit "
           "4</td>",
           "</tbody>\n<tbody>\n<tr class=\"failed\"><th scope=\"row\">&lt;b&gt;</th>",
           "<td data-value>–</td>",
           "<td colspan=\"4\">not here: no library</td></tr>\n</tbody>\n</table>",
       }) {
    EXPECT_NE(html.find(part), std::string::npos) << part << "\nis not in\n" << html;
  }
}

TEST(Table, KeepsItsColumnsWhateverTheCellsHold) {
  Table table({"name", "number"}, 1);
  table.add({"a|b<script>`x`\nnew", "1"});
  table.add({"käse", "22"});
  const std::string markdown = table.markdown();
  EXPECT_EQ(std::count(markdown.begin(), markdown.end(), '\n'), 4);
  EXPECT_EQ(markdown.find("<script"), markdown.find("\\<script") + 1);
  EXPECT_NE(table.plain().find("käse"), std::string::npos);
}

TEST(Number, HasTheDigitsThatItIsGoodFor) {
  EXPECT_EQ(bench::number_text(1.24e-5, bench::as_error), "1.2e-05");
  EXPECT_EQ(bench::number_text(0.9, bench::fixed(4)), "0.9000");
  EXPECT_EQ(bench::number_text(12345678.0, bench::as_count), "12345678") << "a count is whole";
  EXPECT_EQ(bench::number_text(0.001, bench::as_count), "0.001");
  EXPECT_EQ(bench::number_text(-0.0, bench::as_error), "0");
  EXPECT_EQ(bench::number_text(-1e-7, bench::fixed(4)), "0.0000");
  EXPECT_EQ(number_cell(std::nullopt, bench::as_error).text, bench::dash);
}

TEST(Words, AreWrappedAtBlanks) {
  EXPECT_EQ(bench::wrapped("one two three", 7), "one two\nthree\n");
  EXPECT_EQ(bench::wrapped("a word-that-is-too-long b", 6), "a\nword-that-is-too-long\nb\n");
  EXPECT_EQ(bench::wrapped("", 7), "");
}

}  // namespace
}  // namespace tautline::test
