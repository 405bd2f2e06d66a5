#include "bench/plot/svg.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// How the parts of a picture look, on light paper and on dark.
constexpr const char* plot_style = R"(<style>
text{font:13px system-ui,sans-serif;fill:#1a1a1a}
.title{font-size:16px;font-weight:600}
.muted{fill:#555}
.paper{fill:#fff}
.frame{fill:none;stroke:#8a8a8a}
.grid{stroke:#e3e3e3}
.path{fill:none;stroke:#1f6fb4;stroke-width:1.2;stroke-linejoin:round}
.cable{fill:none;stroke:#1a1a1a;stroke-width:1.6}
.before{opacity:.55}
.slack{stroke-dasharray:6 4}
.body{fill:#9a9a9a;stroke:#1a1a1a;stroke-width:1.5;stroke-linejoin:round}
.bar{fill:none;stroke:#1a1a1a;stroke-width:7;stroke-linecap:round}
.core{fill:none;stroke:#bdbdbd;stroke-width:4;stroke-linecap:round}
.start .body,.start .core{fill:#fff}.start .core{stroke:#fff}
.faint{opacity:.22}
.centre{fill:#1a1a1a}
.impact{fill:none;stroke:#c4320a;stroke-width:1.1;opacity:.75}
.anchor{fill:#1a1a1a}
.scale{stroke:#1a1a1a;stroke-width:2}
.halo{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round;font-weight:600}
@media (prefers-color-scheme:dark){
text{fill:#eee}.muted{fill:#b5b5b5}.paper{fill:#16181c}.frame{stroke:#7d7d7d}.grid{stroke:#30343a}
.path{stroke:#6db3f2}.cable,.scale{stroke:#eee}.body{fill:#70757d;stroke:#eee}.bar{stroke:#eee}
.core{stroke:#50555c}.start .body{fill:#16181c}.start .core{stroke:#16181c;fill:none}
.centre,.anchor{fill:#eee}.impact{stroke:#ff9166}.halo{stroke:#16181c}
}
</style>
)";

std::string anchor_attribute(const std::string& anchor) {
  return anchor.empty() ? "" : "text-anchor=\"" + anchor + "\" ";
}

}  // namespace

std::string line_look(std::size_t colour, std::size_t dashes) {
  return fmt::format("stroke=\"{}\" stroke-dasharray=\"{}\" style=\"fill:none\"",
                     line_colours[colour % line_colours.size()],
                     line_dashes[dashes % line_dashes.size()]);
}

std::string svg_start(double width, double height, const std::string& more) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\"{2}>\n",
      width, height, more);
}

std::string svg_sheet(const SvgSheet& sheet, const std::string& drawn) {
  const std::string title = xml_text(sheet.title);
  std::string out = svg_start(sheet.width, sheet.height) + "<title>" + title + "</title>\n";
  if (constexpr std::string_view whole = "role=\"img\""; sheet.has_links) {
    out.replace(out.find(whole), whole.size(), "role=\"group\"");
  }
  if (!sheet.description.empty()) {
    out += "<desc>" + xml_text(sheet.description) + "</desc>\n";
  }
  out += plot_style;
  out += fmt::format(
      "<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n"
      "<text class=\"title\" x=\"{}\" y=\"{}\">{}</text>\n",
      sheet.left, sheet.title_y, title);
  if (!sheet.line.empty()) {
    out += fmt::format("<text class=\"muted\" x=\"{}\" y=\"47\">{}</text>\n", sheet.left,
                       xml_text(sheet.line));
  }
  return out + drawn + "</svg>\n";
}

std::string muted_text(double x, double y, const std::string& words, const char* anchor) {
  return fmt::format("<text class=\"muted\" {}x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                     anchor_attribute(anchor), x, y, xml_text(words));
}

std::string turned_text(double x, double y, int degrees, const std::string& words,
                        const char* anchor) {
  return fmt::format(
      "<text class=\"muted\" {}transform=\"translate({:.1f} {:.1f}) rotate({})\">{}</text>\n",
      anchor_attribute(anchor), x, y, degrees, xml_text(words));
}

std::string rectangle(const std::string& look, double x, double y, double width, double height) {
  return fmt::format("<rect {}x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", look,
                     x, y, width, height);
}

std::string grid_down(double x, double top, double height) {
  return fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}v{:.1f}\"/>", x, top, height);
}

std::string grid_across(double left, double y, double width, const std::string& number) {
  constexpr double room = panel_left - 12.0;
  const std::string narrower =
      room_for(number, letters) > room
          ? fmt::format("textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\" ", room)
          : "";
  return fmt::format(
      "<path class=\"grid\" d=\"M{:.1f} {:.1f}h{:.1f}\"/><text class=\"muted\" "
      "text-anchor=\"end\" {}x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
      left, y, width, narrower, left - 6.0, y + 4.0, number);
}

std::string legend_entry(double x, double y, const std::string& look, const std::string& name) {
  return fmt::format("<path d=\"M{} {:.1f}h40\" {}/><text x=\"{}\" y=\"{:.1f}\">{}</text>\n", x, y,
                     look, x + 48.0, y + 4.0, xml_text(name));
}

void LegendRows::skip() {
  constexpr double row = 22.0;  // [px]
  x_ = panel_left;
  y_ += row;
}

void LegendRows::add(const std::string& mark, const std::string& name) {
  constexpr double before_name = 32.0;  // [px]
  constexpr double after = 12.0;
  const double width = before_name + room_for(name, letters);
  if (x_ == 0.0 || (x_ > panel_left && x_ + width > panel_left + panel_width)) {
    skip();
  }
  drawn_ += fmt::format(
      "<g transform=\"translate({:.1f} {:.1f})\">{}</g><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
      x_, y_, mark, x_ + before_name, y_ + 4.0, xml_text(name));
  x_ += width + after;
}

void add_point(std::string& path, double x, double y) {
  path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x, y);
}

double room_for(const std::string& text, double size) {
  constexpr double width_of_a_letter = 0.66;  // [-] of its size: bold letters and digits
  return width_of_a_letter * size * static_cast<double>(terminal_width(text));
}

double round_below(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= length) {
      return digit * power;
    }
  }
  return power;
}

std::vector<double> ticks(double low, double size) {
  constexpr double fewest = 3.5;  // intervals
  const double step = round_below(size / fewest);
  std::vector<double> result;
  const double first = std::ceil(low / step);
  constexpr int most = 20;  // where the steps are lost in the size of the numbers
  for (int index = 0; index < most && (first + index) * step <= low + size; ++index) {
    result.push_back((first + index) * step);
  }
  return result;
}

}  // namespace tautline::bench
