// One document, as Markdown, as a page and on a terminal.

#include "bench/base/document.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bench/base/html.hpp"

namespace tautline::bench {
namespace {

constexpr TerminalStyle narrow = {60, false, 30};

Table small_table() {
  Table table({"engine", "runs"}, 1);
  table.add(std::vector<std::string>{"o*e", "3"});
  return table;
}

/// A block of each kind, with a name that would mark words up.
Document document() {
  Document inside;
  inside.paragraph("**A** name: " + verbatim("<o*e> *x*") + ".", "answer");
  inside.list({"one *word*", "`two`"}, "reading");
  inside.heading(3, "Lower").table(small_table(), "some-table", "A caption.");
  inside.html("<hr>\n").in(Medium::terminal).paragraph("On a terminal.");
  inside.in(Medium::markdown).add(Document().paragraph("In Markdown.").paragraph("Twice."));
  Document out;
  out.section("part", "A part", inside, "Another part");
  out.fold("More", Document().titled(small_table(), "other-table", "A title"), "more");
  return out.paragraph("").list({}).table(Table({"nothing"}, 1), "", "");
}

TEST(Document, IsMarkdownWithABlankLineBetweenBlocks) {
  EXPECT_EQ(document().markdown(), R"(## Another part

**A** name: \<o\*e\> \*x\*.

- one *word*
- `two`

### Lower

| engine | runs |
| ------ | ---: |
| o\*e   |    3 |

In Markdown.

Twice.

### A title

| engine | runs |
| ------ | ---: |
| o\*e   |    3 |
)");
}

TEST(Document, IsAPageWithNothingMarkedUpThatComesFromElsewhere) {
  const std::string page = document().html();
  EXPECT_TRUE(
      page.starts_with("<section id=\"part\">\n<h2>A part</h2>\n<p class=\"answer\">"
                       "<strong>A</strong> name: &lt;o*e&gt; *x*.</p>\n"
                       "<ul class=\"reading\">\n<li>one <em>word</em></li>\n"
                       "<li><code>two</code></li>\n</ul>\n<h3>Lower</h3>\n"))
      << page;
  EXPECT_NE(page.find("<caption id=\"some-table-caption\">A caption.</caption>"), page.npos);
  EXPECT_NE(page.find("</div>\n<hr>\n</section>\n<details class=\"fold\" id=\"more\">"
                      "<summary>More</summary>\n<div class=\"table-box\""),
            page.npos)
      << page;
  EXPECT_NE(page.find("A title</caption>"), page.npos);
  EXPECT_TRUE(page.ends_with("</div>\n</details>\n"));
}

TEST(Document, IsForATerminalWithItsAnswersLastAndNoMarks) {
  EXPECT_EQ(document().plain(narrow), R"(A part
one word
two

Lower:
engine  runs
o*e        3

On a terminal.

A name: <o*e> *x*.

A title:
engine  runs
o*e        3
)");
}

TEST(Document, HasAnswersAsParagraphsOfAPageAndAsAListElsewhere) {
  const Document answers = Document().list({"One.", "Two."}, "answer");
  EXPECT_EQ(answers.html(), "<p class=\"answer\">One.</p>\n<p class=\"answer\">Two.</p>\n");
  EXPECT_EQ(answers.markdown(), "- One.\n- Two.\n");
  EXPECT_EQ(answers.plain(narrow), "One.\nTwo.\n");
}

TEST(Prose, LosesItsMarksAndKeepsWhatIsNone) {
  EXPECT_EQ(plain_prose("**a** and *b* and `c`, 2 * 3"), "a and b and c, 2 * 3");
  const std::string hostile = "*a* `b` **c** <d> [e](f) \\*";
  EXPECT_EQ(plain_prose(verbatim(hostile)), hostile);
  EXPECT_EQ(html_prose(verbatim(hostile)), html_text(hostile));
}

TEST(Table, SaysOnATerminalHowManyRowsWereCut) {
  Table table({"run"}, 1);
  for (const char* const run : {"a", "b", "c"}) {
    table.add(std::vector<std::string>{run});
  }
  table.cut(3);
  EXPECT_EQ(table.rows().size(), 3U);
  table.cut(1, " in the report");
  EXPECT_EQ(table.plain(narrow), "run\na\nand 2 more in the report\n");
}

}  // namespace
}  // namespace tautline::bench
