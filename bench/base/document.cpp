#include "bench/base/document.hpp"

#include <fmt/format.h>

#include <utility>

#include "bench/base/html.hpp"

namespace tautline::bench {

Document& Document::push(bool has_content, Block block) {
  if (has_content) {
    block.in = next_ ? next_ : block.in;
    blocks_.push_back(std::move(block));
  }
  next_.reset();
  return *this;
}

Document& Document::heading(int level, const std::string& text) {
  return push(true, {.kind = Kind::heading, .text = text, .level = level});
}

Document& Document::paragraph(const std::string& text, const std::string& look) {
  return push(!text.empty(), {.kind = Kind::paragraph, .text = text, .look = look});
}

Document& Document::list(const std::vector<std::string>& items, const std::string& look) {
  return push(!items.empty(), {.kind = Kind::list, .look = look, .items = items});
}

Document& Document::table(Table table, const std::string& id, const std::string& caption) {
  const bool has_rows = !table.empty();
  return push(has_rows,
              {.kind = Kind::table, .text = caption, .id = id, .table = std::move(table)});
}

Document& Document::titled(Table table, const std::string& id, const std::string& title) {
  const bool has_rows = !table.empty();
  return push(
      has_rows,
      {.kind = Kind::table, .text = title, .id = id, .level = 3, .table = std::move(table)});
}

Document& Document::section(const std::string& id, const std::string& heading, Document inside,
                            const std::string& in_markdown) {
  return push(true, {.kind = Kind::section,
                     .text = heading,
                     .id = id,
                     .in_markdown = in_markdown,
                     .level = 2,
                     .inside = {std::move(inside)}});
}

Document& Document::fold(const std::string& summary, Document inside, const std::string& id) {
  return push(true, {.kind = Kind::fold, .text = summary, .id = id, .inside = {std::move(inside)}});
}

Document& Document::html(const std::string& html) {
  return push(true, {.text = html, .in = Medium::page});
}

Document& Document::add(Document other) {
  for (Block& block : other.blocks_) {
    block.in = next_ ? next_ : block.in;
    blocks_.push_back(std::move(block));
  }
  next_.reset();
  return *this;
}

Document& Document::in(Medium medium) {
  next_ = medium;
  return *this;
}

std::string Document::markdown_of(const Block& block) {
  std::string out = block.inside.empty() ? "" : block.inside.front().markdown();
  for (const std::string& item : block.items) {
    out += "- " + item + "\n";
  }
  if (block.kind == Kind::paragraph) {
    out = block.text + "\n";
  } else if (block.table) {
    out = block.table->markdown();
  }
  return block.level == 0 ? out
                          : fmt::format("{:#>{}} {}\n{}{}", "", block.level,
                                        block.in_markdown.empty() ? block.text : block.in_markdown,
                                        out.empty() ? "" : "\n", out);
}

std::string Document::html_of(const Block& block) {
  const std::string text = block.kind == Kind::html ? block.text : html_prose(block.text);
  const std::string inside = block.inside.empty() ? "" : block.inside.front().html();
  const std::string id = block.id.empty() ? "" : " id=\"" + html_text(block.id) + "\"";
  const std::string look = block.look.empty() ? "" : " class=\"" + html_text(block.look) + "\"";
  const bool answers = block.look == "answer";  // each is a paragraph
  std::string items;
  for (const std::string& item : block.items) {
    items += answers ? "<p" + look + ">" + html_prose(item) + "</p>\n"
                     : "<li>" + html_prose(item) + "</li>\n";
  }
  switch (block.kind) {
    case Kind::heading:
      return fmt::format("<h{0}>{1}</h{0}>\n", block.level, text);
    case Kind::paragraph:
      return "<p" + look + ">" + text + "</p>\n";
    case Kind::list:
      return answers ? items : "<ul" + look + ">\n" + items + "</ul>\n";
    case Kind::table:
      return html_table(*block.table, block.id, block.text);
    case Kind::section:
      return fmt::format("<section{}>\n<h2>{}</h2>\n{}</section>\n", id, text, inside);
    case Kind::fold:
      return fmt::format("<details class=\"fold\"{}><summary>{}</summary>\n{}</details>\n", id,
                         text, inside);
    case Kind::html:
      break;
  }
  return text;
}

std::string Document::plain_of(const Block& block, const TerminalStyle& style) {
  std::string out;
  for (const std::string& item : block.items) {
    out += wrapped(plain_prose(item), style.text);
  }
  if (block.level > 2) {
    out = plain_prose(block.text) + ":\n";
  } else if (block.level > 0 || block.kind == Kind::paragraph) {
    out = wrapped(plain_prose(block.text), style.text);
  }
  return out + (block.table ? block.table->plain(style) : "") +
         (block.inside.empty() ? "" : block.inside.front().plain(style));
}

std::string Document::markdown() const {
  std::string out;
  for (const Block& block : blocks_) {
    const std::string text =
        block.in.value_or(Medium::markdown) == Medium::markdown ? markdown_of(block) : "";
    out += (out.empty() || text.empty() ? "" : "\n") + text;
  }
  return out;
}

std::string Document::html() const {
  std::string out;
  for (const Block& block : blocks_) {
    out += block.in.value_or(Medium::page) == Medium::page ? html_of(block) : "";
  }
  return out;
}

std::string Document::plain(const TerminalStyle& style) const {
  std::string out;
  std::string answers;
  bool follows = false;  // what needs a blank line
  for (const Block& block : blocks_) {
    const std::string text =
        block.in.value_or(Medium::terminal) == Medium::terminal ? plain_of(block, style) : "";
    if (block.look == "answer") {
      answers += text;
    } else if (!text.empty()) {
      out += (follows ? "\n" : "") + text;
      follows = block.kind != Kind::heading;
    }
  }
  return out + (out.empty() || answers.empty() ? "" : "\n") + answers;
}

}  // namespace tautline::bench
