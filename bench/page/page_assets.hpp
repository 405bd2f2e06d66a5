#pragma once

#include <string_view>

namespace tautline::bench {

/// The files of the pages, as they stand in bench/page; part of the program.
struct PageAssets {
  std::string_view style;                // page.css and controls.css
  std::string_view scripts;              // of the report page, in their order
  std::string_view chapter_scripts;      // of the chapter's page
  std::string_view plotly;               // draws the charts; empty in a build without it
  std::string_view licence;              // of Plotly, which asks to stand in every copy
  std::string_view figure_scripts = {};  // of pages whose figures the program draws
  std::string_view space_scripts = {};   // of the replay of systems in space, before `scripts`
  std::string_view three = {};           // draws those; empty in a build without it
  std::string_view three_licence = {};   // of three.js, for every copy
};

/// Written by bench/page/embed.cmake when the program is built.
[[nodiscard]] const PageAssets& page_assets();

}  // namespace tautline::bench
