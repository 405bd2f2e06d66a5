#pragma once

#include <string>
#include <string_view>

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
};

/// A whole page: the style, the content, the data and the scripts in one file that needs no other
/// and no network.
[[nodiscard]] std::string html_document(const PageContent& page, const PageAssets& assets);

}  // namespace tautline::bench
