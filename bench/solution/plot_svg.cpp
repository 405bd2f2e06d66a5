// Draws the picture of one motion. Words, dashes and shapes say everything that colours say.

#include "bench/solution/plot_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/text.hpp"
#include "bench/solution/plot_motion.hpp"
#include "bench/solution/plot_panel.hpp"
#include "bench/solution/plot_style.hpp"
#include "bench/solution/plot_view.hpp"

namespace tautline::bench {
namespace {

// The sheet [px].
constexpr double right = 20.0;
constexpr double top = 64.0;
constexpr double bottom = 92.0;
constexpr double between = 84.0;      // two panels
constexpr double narrowest = 560.0;   // [px]
constexpr double legend_end = 388.0;  // [px], of the words left of the scale bar

/// The motion has a panel of its own where it fills less of the whole than this [-].
constexpr double enlarged_below = 0.33;

/// The length of the scale bar [m] and its label.
struct ScaleBar {
  explicit ScaleBar(const PlotPanel& panel)
      : length(round_below(0.25 * panel.view().size().x())),
        label(fmt::format("{:g} m", length)),
        width(panel.scale() * length) {}
  [[nodiscard]] double text_start() const { return panel_left + legend_end + width; }

  double length;      // [m]
  std::string label;  //
  double width;       // [px]
};

/// How the motion ends, after "ends".
std::string ending_words(const Solution& solution) {
  switch (solution.ending()) {
    case Ending::reached_duration:
      return "at its duration";
    case Ending::rest:
      return "at rest";
    case Ending::unstable_rest:
      return "at an unstable equilibrium";
    case Ending::locked:
      return "locked";
    case Ending::angle_limit:
      return "at the angle limit";
    case Ending::ceiling:
      return "at the ceiling";
    default:
      return std::string(to_string(solution.ending()));
  }
}

/// The words above the panels.
struct Heading {
  std::string name;
  std::string line;
};

Heading heading_of(const PlotMotion& motion) {
  constexpr std::size_t longest_title = 64;  // [bytes]
  return {printable(motion.the_case.name, longest_title),
          fmt::format("t = 0 to {:.6g} s, {} impact{}, ends {}{}", motion.solution.end_time(),
                      motion.marks.size(), motion.marks.size() == 1 ? "" : "s",
                      ending_words(motion.solution),
                      motion.path_end < motion.solution.end_time()
                          ? fmt::format("; path to t = {:.6g} s", motion.path_end)
                          : "")};
}

/// The sheet, its title and what it is.
std::string begin(const PlotMotion& motion, double sheet_width, double sheet_height) {
  const Heading words = heading_of(motion);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n<desc>Exact "
      "motion of a body on {3} cable{4}: {5}.</desc>\n{6}<rect class=\"paper\" width=\"100%\" "
      "height=\"100%\"/>\n<text class=\"title\" x=\"{7}\" y=\"26\">{2}</text>\n<text "
      "class=\"muted\" x=\"{7}\" y=\"47\">{5}</text>\n",
      sheet_width, sheet_height, xml_text(words.name), motion.the_case.cables.size(),
      motion.the_case.cables.size() == 1 ? "" : "s", words.line, plot_style, panel_left);
}

std::string heading(const PlotPanel& panel) {
  return fmt::format(
      "<text class=\"muted\" x=\"{:.1f}\" y=\"{:.1f}\">the dotted part, "
      "enlarged</text>\n",
      panel_left, panel.top() - 10.0);
}

/// What the lines mean, and the scale bar of the last panel.
std::string legend(const PlotPanel& panel, double y) {
  const ScaleBar bar(panel);
  return fmt::format(
      "<path class=\"path\" d=\"M{0} {1:.1f}h26\"/><text x=\"{2}\" y=\"{3:.1f}\">centre of "
      "mass</text>\n<path class=\"cable\" d=\"M{4} {1:.1f}h26\"/><text x=\"{5}\" "
      "y=\"{3:.1f}\">taut</text>\n<path class=\"cable slack\" d=\"M{6} {1:.1f}h30\"/><text "
      "x=\"{7}\" y=\"{3:.1f}\">slack</text>\n<circle class=\"impact\" cx=\"{8}\" "
      "cy=\"{1:.1f}\" r=\"3\"/><text x=\"{9}\" y=\"{3:.1f}\">impact</text>\n<path "
      "class=\"scale\" d=\"M{10} {11:.1f}v8m0-4h{12:.1f}m0-4v8\"/><text x=\"{13:.1f}\" "
      "y=\"{3:.1f}\">{14}</text>\n",
      panel_left, y, panel_left + 32.0, y + 4.0, panel_left + 140.0, panel_left + 172.0,
      panel_left + 214.0, panel_left + 250.0, panel_left + 304.0, panel_left + 313.0,
      panel_left + legend_end - 8.0, y - 4.0, bar.width, bar.text_start(), bar.label);
}

/// What the panels and all words need [px].
double width_of_sheet(const PlotMotion& motion, const PlotPanel& last, double panels) {
  const Heading words = heading_of(motion);
  const ScaleBar bar(last);
  const double end = std::max({panels, bar.text_start() + room_for(bar.label, letters),
                               panel_left + room_for(words.name, 16.0),
                               panel_left + room_for(words.line, letters)});
  return std::max(end + right, narrowest);
}

/// The sheet around its panels, of which `last` is the lowest.
std::string sheet(const PlotMotion& motion, const std::string& panels, const PlotPanel& last,
                  double width) {
  return begin(motion, width_of_sheet(motion, last, width), last.bottom() + bottom) + panels +
         legend(last, last.bottom() + 68.0) + "</svg>\n";
}

}  // namespace

std::string plot_svg(const Case& the_case, const Solution& solution) {
  const PlotMotion motion = plot_motion(the_case, solution);
  const Extent all = extent_of_all(motion).with_margin();
  const Extent bodies = extent_of_bodies(motion).with_margin();
  const PlotPanel whole(motion, all, top);
  const bool enlarge = bodies.size().maxCoeff() < enlarged_below * all.size().maxCoeff();
  if (!enlarge) {
    return sheet(motion, whole.text(PlotPanel::Kind::all), whole, whole.labels_end());
  }
  const PlotPanel enlarged(motion, bodies, whole.bottom() + between);
  const std::string panels = whole.text(PlotPanel::Kind::whole) + whole.frame(bodies) +
                             heading(enlarged) + enlarged.text(PlotPanel::Kind::enlarged);
  return sheet(motion, panels, enlarged, std::max(whole.labels_end(), enlarged.labels_end()));
}

}  // namespace tautline::bench
