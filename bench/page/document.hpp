#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/page/page_assets.hpp"

namespace tautline::bench {

/// What is a page's own.
struct PageContent {
  std::string_view title;
  std::string content;        // of its body, HTML
  std::string_view command;   // that made it
  std::string_view data_id;   // of the element with the data
  std::string data;           // that its scripts read: JSON in which no script can end
  std::string_view scripts;   //
  std::string motions = {};   // and that a replay reads, likewise; empty: it has none of its own
  bool files_beside = false;  // whether it may load scripts that lie next to it
  bool in_space = false;      // whether it replays systems in space
};

/// A picture that the program has drawn, for a page whose scripts are `PageAssets::figure_scripts`.
struct DrawnFigure {
  std::string name;   // of the files that a reader saves it as
  std::string label;  // for a reader who does not see it
  std::string svg;
  std::string csv;  // its numbers, from `csv_line`
};

/// The figure in a box that scrolls on a narrow page, so that its words stay legible.
[[nodiscard]] std::string figure_html(const DrawnFigure& figure);

/// A line of a CSV file (RFC 4180), with its end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

/// A whole page: the style, the content, the data and the scripts in one file that needs no other
/// and no network.
[[nodiscard]] std::string html_document(const PageContent& page, const PageAssets& assets);

}  // namespace tautline::bench
