#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/base/table.hpp"

namespace tautline::bench {

/// How a document is shown.
enum class Medium { markdown, page, terminal };

/// What a file in Markdown, a page and a terminal show, written once, block by block from the top.
/// Texts have **strong**, *stressed* and `code` words as Markdown has them; words from elsewhere
/// are `verbatim`. Blocks without content are left out.
class Document {
 public:
  /// Of level 2 or 3; a terminal ends one of level 3 with a colon.
  Document& heading(int level, const std::string& text);
  /// `look` is a class of the page; what looks as an "answer" is last on a terminal, where the
  /// reader is.
  Document& paragraph(const std::string& text, const std::string& look = "");
  Document& list(const std::vector<std::string>& items, const std::string& look = "");
  /// `caption` is for a page alone.
  Document& table(Table table, const std::string& id, const std::string& caption);
  /// `title` is the caption on a page, a heading of level 3 elsewhere.
  Document& titled(Table table, const std::string& id, const std::string& title);
  /// `inside` below a heading of level 2, which may be another one in Markdown.
  Document& section(const std::string& id, const std::string& heading, Document inside,
                    const std::string& in_markdown = "");
  /// `inside`, which a page shows on demand.
  Document& fold(const std::string& summary, Document inside, const std::string& id = "");
  /// A part of a page.
  Document& html(const std::string& html);
  /// The blocks of another document.
  Document& add(Document other);
  /// What is added next is shown in this medium alone.
  Document& in(Medium medium);

  [[nodiscard]] std::string markdown() const;
  [[nodiscard]] std::string html() const;
  [[nodiscard]] std::string plain(const TerminalStyle& style) const;

 private:
  enum class Kind { heading, paragraph, list, table, section, fold, html };
  struct Block {
    Kind kind = Kind::html;
    std::string text = {};  // or the caption, the summary, HTML
    std::string look = {};
    std::string id = {};
    std::string in_markdown = {};   // the heading there; empty: `text`
    int level = 0;                  // of the heading; 0: none
    std::optional<Medium> in = {};  // empty: all
    std::vector<std::string> items = {};
    std::optional<Table> table = {};
    std::vector<Document> inside = {};  // one, of a section and a fold
  };
  Document& push(bool has_content, Block block);
  static std::string markdown_of(const Block& block);
  static std::string html_of(const Block& block);
  static std::string plain_of(const Block& block, const TerminalStyle& style);

  std::vector<Block> blocks_;
  std::optional<Medium> next_;  // of the next block alone
};

}  // namespace tautline::bench
