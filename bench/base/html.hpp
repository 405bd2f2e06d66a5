#pragma once

#include <string>
#include <string_view>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {

// What a page is made of. No text reaches it but through these.

/// `text` as the content of an element or of an attribute in quotes: on one line, cut after
/// `longest` bytes, with what HTML, a terminal or an editor would read as its own made harmless.
[[nodiscard]] std::string html_text(std::string_view text, std::size_t longest = quotable_length);

/// The same of a text with **strong**, *stressed* and `code` words, as our Markdown has them; a
/// character after a backslash marks nothing.
[[nodiscard]] std::string html_prose(std::string_view text);

/// That text without its marks.
[[nodiscard]] std::string plain_prose(std::string_view text);

/// `text` from elsewhere as a part of such a text: on one line, with nothing marked.
[[nodiscard]] std::string verbatim(std::string_view text, std::size_t longest = quotable_length);

/// `json` as the content of a script element: a script cannot end inside it.
[[nodiscard]] std::string html_json(std::string json);

/// `table` in a box of its own, which scrolls where the page is narrower. The whole of a number
/// stands in its cell: in the attribute data-value, or as its text where that is all of it. A body
/// for each run of rows with one `Row::body`.
[[nodiscard]] std::string html_table(const Table& table, const std::string& id,
                                     const std::string& caption);

}  // namespace tautline::bench
