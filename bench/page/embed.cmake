# Writes OUTPUT, the C++ source that holds the pages' files, from STYLE, SCRIPTS, CHAPTER_SCRIPTS, FIGURE_SCRIPTS and
# SPACE_SCRIPTS (each in order, separated by |), PLOTLY and its LICENCE, THREE and its THREE_LICENCE (all four may be empty).
# Called at build time by bench/page/CMakeLists.txt.

# Sets `result` to the text of `files`, one after another.
function(read_files files result)
  set(whole "")
  string(REPLACE "|" ";" files "${files}")
  foreach(file IN LISTS files)
    file(READ "${file}" text)
    string(APPEND whole "${text}")
  endforeach()
  set(${result} "${whole}" PARENT_SCOPE)
endfunction()

read_files("${STYLE}" style)
read_files("${SCRIPTS}" scripts)
read_files("${CHAPTER_SCRIPTS}" chapter_scripts)
read_files("${FIGURE_SCRIPTS}" figure_scripts)
read_files("${SPACE_SCRIPTS}" space_scripts)
read_files("${THREE}" three)
read_files("${THREE_LICENCE}" three_licence)

set(plotly "")
set(licence "")
if(PLOTLY)
  file(READ "${LICENCE}" licence)
  file(READ "${PLOTLY}" plotly)
  # The page reaches for no network. Plotly names addresses in its settings (of maps, of its own service,
  # of its logo) and in comments; the names of XML's own namespaces stay, they are never opened.
  string(REPLACE "http://www.w3.org/" "@namespace@" plotly "${plotly}")
  string(REPLACE "https://" "" plotly "${plotly}")
  string(REPLACE "http://" "" plotly "${plotly}")
  string(REPLACE "@namespace@" "http://www.w3.org/" plotly "${plotly}")
endif()

foreach(part IN ITEMS style scripts chapter_scripts figure_scripts plotly licence space_scripts three three_licence)
  # the end of a script, or what opens a comment in one, would end it inside the page
  string(TOLOWER "${${part}}" lower)
  if(lower MATCHES "</script|</style|<!--|\\)tautline_page\"")
    message(FATAL_ERROR "bench/page: ${part} holds ${CMAKE_MATCH_0}, which would end it inside the page")
  endif()
endforeach()

file(WRITE "${OUTPUT}" "// Written by bench/page/embed.cmake.
#include \"bench/page/page_assets.hpp\"

namespace tautline::bench {

const PageAssets& page_assets() {
  static const PageAssets assets{
R\"tautline_page(${style})tautline_page\",
R\"tautline_page(${scripts})tautline_page\",
R\"tautline_page(${chapter_scripts})tautline_page\",
R\"tautline_page(${plotly})tautline_page\",
R\"tautline_page(${licence})tautline_page\",
R\"tautline_page(${figure_scripts})tautline_page\",
R\"tautline_page(${space_scripts})tautline_page\",
R\"tautline_page(${three})tautline_page\",
R\"tautline_page(${three_licence})tautline_page\"};
  return assets;
}

}  // namespace tautline::bench
")
