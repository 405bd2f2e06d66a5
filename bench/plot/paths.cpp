// Draws the picture of one motion, in the plane or from the sides of space. Words, dashes and
// shapes say everything that colours say.

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/text.hpp"
#include "bench/plot/panel.hpp"
#include "bench/plot/svg.hpp"

namespace tautline::bench {
namespace {

// The sheet [px].
constexpr double right_margin = 20.0;
constexpr double first_top = 64.0;
constexpr double side_name = 22.0;        // above a panel that has one
constexpr double between_columns = 70.0;  // with the numbers of an axis
constexpr double below_panels = 92.0;
constexpr double between_views = 84.0;
constexpr double narrowest = 560.0;   // [px]
constexpr double legend_end = 388.0;  // [px], of the words left of the scale bar

/// The motion has a panel of its own where it fills less of the whole than this [-].
constexpr double enlarged_below = 0.33;

// Of a panel [px].
constexpr double widest = panel_width;  // of a sheet of 720
constexpr double tallest = 900.0;

/// The looks that a picture of a system adds: of cables by their state, and of ends that move.
constexpr const char* system_style = R"(<style>
.path{stroke-width:1.6}.cable{stroke-width:3}.slack{stroke:#8a8a8a;stroke-width:1.6}
.moving{fill:none;stroke:#8a4fb0;stroke-width:1.6}
.ring{fill:#fff;stroke:#1a1a1a;stroke-width:1.8}
@media (prefers-color-scheme:dark){.moving{stroke:#c79be8}.ring{fill:#16181c;stroke:#eee}}
</style>
)";

/// Looks that a picture of space adds: of the paths of attachments, and of their places off a box.
constexpr const char* space_style = R"(<style>
.trace{fill:none;stroke:#8a8a8a;stroke-width:.7}.arm{fill:none;stroke:#1a1a1a;stroke-width:1.2}
.box{fill-opacity:.5}
@media (prefers-color-scheme:dark){.arm{stroke:#eee}}
</style>
)";

/// The length of the scale bar [m] and its label.
struct ScaleBar {
  explicit ScaleBar(const PlotPanel& panel)
      : length(round_below(0.25 * panel.shown().size().x())),
        label(fmt::format("{:g} m", length)),
        width(panel.scale() * length) {}
  [[nodiscard]] double text_start() const { return panel_left + legend_end + width; }

  double length;      // [m]
  std::string label;  //
  double width;       // [px]
};

/// How the motion ends, after "ends".
std::string ending_words(Ending ending) {
  switch (ending) {
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
      return std::string(to_string(ending));
  }
}

/// The words below the title.
std::string heading_of(const PlotMotion& motion) {
  return fmt::format(
      "t = 0 to {:.6g} s, {} impact{}{}, ends {}{}", motion.end_time, motion.marks.size(),
      motion.marks.size() == 1 ? "" : "s", motion.contacts, ending_words(motion.ending),
      motion.path_end < motion.end_time ? fmt::format("; path to t = {:.6g} s", motion.path_end)
                                        : "");
}

/// What the lines mean, and the scale bar.
std::string legend(const ScaleBar& bar, double y) {
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

/// `motion` as it is seen from each side, and what the panels need of the whole of it.
template <int D>
struct Sides {
  explicit Sides(const BasicPlotMotion<D>& motion)
      : all(extent_of_all(motion).with_margin()), bodies(extent_of_bodies(motion).with_margin()) {
    for (const View& view : views<D>()) {
      motions.push_back(seen(motion, view));
    }
  }

  std::vector<PlotMotion> motions;  // by view
  BasicExtent<D> all;
  BasicExtent<D> bodies;
};

/// A panel for each side, at one scale, from `top` [px] down: in space the side to the right of the
/// front, at its height, and the top below the front.
template <int D>
std::vector<PlotPanel> panels_of(const std::vector<PlotMotion>& motions,
                                 const BasicExtent<D>& shown, double top) {
  const auto size = shown.size();
  const double scale = D == 2 ? std::min(widest / size[0], tallest / size[1])
                              : std::min((widest - between_columns) / (size[0] + size[1]),
                                         tallest / (size[1] + size[D - 1]));
  std::vector<PlotPanel> panels;
  for (const View& view : views<D>()) {
    const bool right = !panels.empty() && view.right == 1;
    const bool below = panels.size() == 2;
    panels.emplace_back(motions[panels.size()], view, shown.seen(view),
                        right ? panels.front().right() + between_columns : panel_left,
                        below ? panels.front().bottom() + between_views : top, scale);
  }
  return panels;
}

/// The panels of a sheet.
struct Views {
  std::string drawn;
  ScaleBar bar;
  double bottom;  // [px], of the last
  double end;     // [px], where the words next to them end
};

template <int D>
Views views_of(const Sides<D>& sides) {
  const double name = D == 2 ? 0.0 : side_name;
  const std::vector<PlotPanel> whole = panels_of(sides.motions, sides.all, first_top + name);
  const bool enlarge =
      sides.bodies.size().maxCoeff() < enlarged_below * sides.all.size().maxCoeff();
  std::string drawn;
  double end = 0.0;
  const auto draw = [&](const PlotPanel& panel, PlotPanel::Kind kind) {
    drawn += panel.text(kind);
    end = std::max(end, panel.labels_end());
  };
  for (std::size_t side = 0; side < whole.size(); ++side) {
    draw(whole[side], enlarge ? PlotPanel::Kind::whole : PlotPanel::Kind::all);
    drawn += enlarge ? whole[side].frame(sides.bodies.seen(views<D>().at(side))) : "";
  }
  if (!enlarge) {
    return {drawn, ScaleBar(whole.front()), whole.back().bottom(), end};
  }
  const std::vector<PlotPanel> enlarged =
      panels_of(sides.motions, sides.bodies, whole.back().bottom() + between_views + name);
  drawn +=
      muted_text(panel_left, enlarged.front().top() - 10.0 - name, "the dotted part, enlarged");
  for (const PlotPanel& panel : enlarged) {
    draw(panel, PlotPanel::Kind::enlarged);
  }
  return {drawn, ScaleBar(enlarged.front()), enlarged.back().bottom(), end};
}

/// The sheet around its views, with what is drawn below them.
std::string sheet(const PlotMotion& motion, const Views& views, const std::string& heading,
                  const std::string& below, double height, double least_width) {
  constexpr std::size_t longest_title = 64;  // [bytes]
  const std::string name = printable(motion.name, longest_title);
  const ScaleBar& bar = views.bar;
  const double end = std::max({views.end, bar.text_start() + room_for(bar.label, letters),
                               panel_left + room_for(name, title_letters),
                               panel_left + room_for(heading, letters)});
  return svg_sheet({.width = std::max(end + right_margin, least_width),
                    .height = height,
                    .left = panel_left,
                    .title = name,
                    .description = "Exact motion of " + motion.subject + ": " + heading + ".",
                    .line = heading},
                   views.drawn + legend(bar, views.bottom + 68.0) + below);
}

template <int D>
std::string picture_of(const BasicSystemMotion<D>& asked) {
  const Sides<D> sides(plot_motion(asked.system, asked.solution));
  const PlotMotion& motion = sides.motions.front();
  const Views views = views_of(sides);
  LegendRows rows(views.bottom + 68.0);
  std::string style = system_style;
  if (!motion.bodies.empty()) {
    style += "<style>.path{stroke:#8a8a8a}</style>\n";  // in the legend: each has its own
    for (std::size_t index = 0; index < motion.bodies.size(); ++index) {
      rows.add("<path class=\"path\"" + style_of(index, true) + " d=\"M0 0h26\"/>",
               motion.bodies[index]);
    }
    rows.add("<g class=\"start\"><circle class=\"body\" cx=\"13\" cy=\"0\" r=\"5\"/></g>", "start");
    rows.add("<circle class=\"body\" cx=\"13\" cy=\"0\" r=\"5\"/>", "end");
  }
  if (!motion.anchors.empty()) {
    rows.add(anchor_at(13.0, 0.0), "anchor");
  }
  if (!motion.moving.empty()) {
    rows.add("<path class=\"moving\" d=\"M0 0h26\"/>", "moving end");
  }
  if (!motion.rings.empty()) {
    rows.add(ring_at(13.0, 0.0), "ring");
  }
  if (!motion.traces.empty()) {
    rows.add("<path class=\"trace\" d=\"M0 0h26\"/>", "attachment");
  }
  const auto& bodies = motion.start.bodies;
  if (std::any_of(bodies.begin(), bodies.end(),
                  [](const auto& body) { return !body.faces.empty(); })) {
    style += space_style;
    rows.add("<path class=\"body box\" d=\"M4 -5h18v10h-18z\"/>",
             "a body: the solid box of its mass and moments of inertia");
  }
  const TensionPanel tensions = tension_panel(asked, rows.bottom() + 52.0);
  return sheet(motion, views, heading_of(motion) + horizon_words(asked.horizon),
               style + rows.drawn() + tensions.drawn, tensions.bottom,
               panel_left + widest + right_margin);
}

}  // namespace

std::string plot_svg(const Case& the_case, const Solution& solution) {
  const Sides<2> sides(plot_motion(the_case, solution));
  const PlotMotion& motion = sides.motions.front();
  const Views views = views_of(sides);
  return sheet(motion, views, heading_of(motion), "", views.bottom + below_panels, narrowest);
}

std::string plot_svg(const SystemMotion& motion) { return picture_of(motion); }
std::string plot_svg(const SpatialMotion& motion) { return picture_of(motion); }

}  // namespace tautline::bench
