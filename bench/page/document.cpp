#include "bench/page/document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/html.hpp"

namespace tautline::bench {
namespace {

// Nothing is fetched from anywhere: what the page may do is what stands in it.
constexpr std::string_view policy =
    "default-src 'none'; script-src 'unsafe-inline'{}; style-src 'unsafe-inline'; img-src data: "
    "blob:; base-uri 'none'; form-action 'none'";

std::string head(const PageContent& page, std::string_view style) {
  // a page on disk may load a file next to it as `file:`, one from a server as `'self'`
  const std::string allowed = fmt::format(policy, page.files_beside ? " 'self' file:" : "");
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n"
      "<link rel=\"icon\" href=\"data:,\">\n<style>\n{}</style>\n</head>\n",
      allowed, page.title, style);
}

/// A text of several lines as it stands; `more` attributes.
std::string preformatted(std::string_view text, std::string_view more = "") {
  constexpr std::size_t longest_line = 1000;
  std::string out = fmt::format("<pre{}>", more);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += html_text(text.substr(0, end), longest_line) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out + "</pre>";
}

std::string foot(const PageContent& page, const PageAssets& assets) {
  std::string out = fmt::format("<footer>\n<p>Made by <code>{}</code> {}.</p>\n", page.command,
                                html_text(TAUTLINE_VERSION));
  if (!assets.plotly.empty()) {
    out += "<details><summary>Charts are drawn by Plotly.js, under the MIT licence.</summary>\n" +
           preformatted(assets.licence) + "</details>\n";
  }
  if (page.in_space && !assets.three.empty()) {
    out +=
        "<details><summary>Systems in space are drawn by three.js, under the MIT "
        "licence.</summary>\n" +
        preformatted(assets.three_licence) + "</details>\n";
  }
  return out + "</footer>\n";
}

/// `content` with a name for its main part, to which the skip link leads.
std::string with_named_main(std::string content) {
  constexpr std::string_view main = "<main>";
  if (const std::size_t at = content.find(main); at != std::string::npos) {
    content.replace(at, main.size(), "<main id=\"content\" tabindex=\"-1\">");
  }
  return content;
}

/// The data, then what reads them. The parser comes to them last: the page is legible before.
std::string scripts(const PageContent& page, const PageAssets& assets) {
  std::string out = fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n",
                                page.data_id, page.data);
  if (!page.motions.empty()) {
    out += fmt::format("<script type=\"application/json\" id=\"motions-data\">{}</script>\n",
                       page.motions);
  }
  if (!assets.plotly.empty()) {
    out += fmt::format("<script id=\"plotly\">{}</script>\n", assets.plotly);
  }
  if (page.in_space && !assets.three.empty()) {
    out += fmt::format("<script id=\"three\">{}</script>\n", assets.three);
  }
  if (page.in_space) {
    out += fmt::format("<script id=\"space-scripts\">\n{}</script>\n", assets.space_scripts);
  }
  return out + fmt::format("<script id=\"page-scripts\">\n{}</script>\n", page.scripts);
}

}  // namespace

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    line += line.empty() ? "" : ",";
    if (cell.find_first_of(",\"\r\n") == std::string::npos) {
      line += cell;
      continue;
    }
    line += '"';
    for (const char letter : cell) {
      line += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    line += '"';
  }
  return line + "\n";
}

std::string figure_html(const DrawnFigure& figure) {
  const std::string label = html_text(figure.label);
  return fmt::format(
      "<figure class=\"drawn\" data-name=\"{}\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"{}\">\n{}{}</figure>\n",
      html_text(figure.name), label, figure.svg, preformatted(figure.csv, " hidden class=\"csv\""));
}

std::string html_document(const PageContent& page, const PageAssets& assets) {
  const bool charts = !assets.plotly.empty();
  return head(page, assets.style) +
         fmt::format("<body{}>\n<a class=\"skip\" href=\"#content\">Skip to the content</a>\n",
                     charts ? "" : " class=\"no-charts\"") +
         with_named_main(page.content) + foot(page, assets) + scripts(page, assets) +
         "</body>\n</html>\n";
}

}  // namespace tautline::bench
