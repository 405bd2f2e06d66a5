// The picture of one case: what is in it, and what a hostile name or a huge number makes of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <regex>

#include "bench/plot/motion.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_settling.hpp"
#include "tests/bench/program.hpp"
#include "tests/bench/support.hpp"

namespace tautline::test {
namespace {

using bench::plot_svg;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// No number of the picture is infinite or none.
bool all_finite(const std::string& svg) {
  return svg.find("nan") == std::string::npos && svg.find("inf ") == std::string::npos &&
         svg.find("inf\"") == std::string::npos;
}

Case case_named(const std::string& name) {
  for (const Case& the_case : shipped_cases()) {
    if (the_case.name == name) {
      return the_case;
    }
  }
  throw std::logic_error("no case " + name);
}

TEST(Plot, ShowsPathBodiesAnchorsCablesImpactsAxesAndScale) {
  const Case the_case = case_named("plate-four-cables");
  const std::string svg = plot_svg(the_case, solve(the_case));
  const std::size_t panels = count(svg, "x [m]");  // a small motion has a second one
  EXPECT_EQ(count(svg, "<rect class=\"anchor\""), 4 * panels);
  EXPECT_EQ(count(svg, "<path class=\"cable before"), 4 * panels);  // the start's cables
  EXPECT_EQ(count(svg, "<g class=\"start\">"), panels);
  EXPECT_EQ(count(svg, "<g class=\"end\">"), panels);
  EXPECT_GE(count(svg, "<g class=\"faint\">"), 1U);
  EXPECT_GE(count(svg, "<circle class=\"impact\""), 10U);
  EXPECT_GE(count(svg, " slack\""), 4U);
  for (const char* part :
       {"x [m]", "y [m]", "prefers-color-scheme", " m</text>", "start</text>", "end</text>"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
  EXPECT_TRUE(all_finite(svg));
}

TEST(Plot, ASlackCableSagsAndATautOneIsStraight) {
  const Case ball = case_named("bouncing-ball");
  const std::string svg = plot_svg(ball, solve(ball));
  EXPECT_EQ(count(svg, "cable before slack\""), count(svg, "x [m]"));
  // the ball rests on its cable in the end
  const std::size_t last = svg.find("<path class=\"cable\" d=\"M");
  ASSERT_NE(last, std::string::npos);
  EXPECT_NE(svg.substr(last, 60).find('L'), std::string::npos) << svg.substr(last, 60);
  // a hanging line is as long as its cable, to the second order of a shallow one
  EXPECT_NEAR(8.0 * std::pow(bench::sag(1.01, 1.0), 2) / 3.0, 0.01, 2e-4);
  EXPECT_EQ(bench::sag(1.0, 1.0), 0.0);
  EXPECT_EQ(bench::sag(1.0, 1.1), 0.0);
}

TEST(Plot, AHostileNameIsHarmless) {
  Case the_case = case_named("bouncing-ball");
  the_case.name = "</title><script>alert('1')</script>\"&\x1b[31m\n" + std::string(10'000, 'x');
  const std::string svg = plot_svg(the_case, solve(the_case));
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find('\x1b'), std::string::npos);
  EXPECT_NE(svg.find("&lt;/title&gt;&lt;script&gt;"), std::string::npos);
  EXPECT_LT(svg.find("</svg>"), 300'000U);
}

TEST(Plot, HugeTinyAndStillMotionsHaveAPictureToo) {
  for (const double scale : {1e-8, 1.0, 1e9, 1e18}) {
    Case the_case = case_named("bouncing-ball");
    for (Cable& cable : the_case.cables) {
      cable.anchor *= scale;
      cable.length *= scale;
    }
    the_case.initial.position *= scale;
    the_case.gravity *= scale;
    const std::string svg = plot_svg(the_case, solve(the_case));
    EXPECT_TRUE(all_finite(svg)) << scale;
    EXPECT_LT(svg.size(), 300'000U) << scale;
    EXPECT_GE(count(svg, "class=\"grid\""), 6U) << scale;
  }
  bench::Extent extent;
  extent.add({std::numeric_limits<double>::infinity(), 0.0});
  extent.add({1e308, -1e308});
  EXPECT_TRUE(extent.with_margin().size().allFinite());
  bench::Extent still;
  still.add({3.0, 4.0});
  EXPECT_GT(still.with_margin().size().minCoeff(), 0.0);
}

/// The text elements of a picture that leave it, if letters are as wide as those of common fonts:
/// 0.6 of their size [em].
std::string cut_off(const std::string& svg) {
  const std::regex sheet("viewBox=\"0 0 ([0-9.]+) ");
  const std::regex text("<text([^>]*)>([^<]*)</text>");
  std::smatch found;
  std::regex_search(svg, found, sheet);
  const double width = std::stod(found[1]);
  std::string result;
  for (std::sregex_iterator at(svg.begin(), svg.end(), text), end; at != end; ++at) {
    const std::string attributes = (*at)[1];
    std::smatch x;
    if (!std::regex_search(attributes, x, std::regex(" x=\"([-0-9.e+]+)\""))) {
      continue;  // the label of the y axis, which is turned
    }
    const double size = attributes.find("\"title\"") != std::string::npos ? 16.0 : 13.0;
    std::smatch length;
    const double own = std::regex_search(attributes, length, std::regex("textLength=\"([0-9.]+)\""))
                           ? std::stod(length[1])
                           : 0.6 * size * static_cast<double>((*at)[2].length());
    const bool ends = attributes.find("\"end\"") != std::string::npos;
    const bool middle = attributes.find("\"middle\"") != std::string::npos;
    const double start = std::stod(x[1]) - (ends ? own : middle ? 0.5 * own : 0.0);
    if (start < 0.0 || start + own > width) {
      result += (*at)[2].str() + "; ";
    }
  }
  return result;
}

TEST(Plot, NoLabelIsCutOffAtAnySizeOrShape) {
  for (const double scale : {1e-8, 0.37, 123.0, 1e9, 1e18}) {
    for (const char* name : {"bouncing-ball", "breakwater/1910121100"}) {
      Case the_case = case_named(name);
      for (Cable& cable : the_case.cables) {
        cable.anchor *= scale;
        cable.attachment *= scale;
        cable.length *= scale;
      }
      the_case.initial.position *= scale;
      the_case.initial.velocity *= scale;
      the_case.gravity *= scale;
      the_case.body.inertia =
          std::clamp(scale * scale * the_case.body.inertia, 1e-18, 1e18);  // what a case may have
      the_case.duration = std::min(the_case.duration, 3.0);
      const std::string svg = plot_svg(the_case, solve(the_case));
      EXPECT_EQ(cut_off(svg), "") << name << " times " << scale;
    }
  }
  // tall and narrow: a short panel beside a long scale
  Case tall = case_named("bouncing-ball");
  tall.name = std::string(64, 'n');
  for (const double height : {1.0, 3.0, 10.0, 100.0}) {
    tall.cables.front().length = height;
    tall.cables.front().anchor.y() = height;
    EXPECT_EQ(cut_off(plot_svg(tall, solve(tall))), "") << height;
  }
}

TEST(Plot, ASystemHasItsBodiesCablesRingsAndMovingEnds) {
  for (const ShippedSystem& one : shipped_systems()) {
    const System& system = one.system;
    const auto solution = solve(system);
    const SystemSettling settled = settling(system, solution);
    const bench::SystemMotion motion = {system, solution, settled, std::nullopt};
    const std::string svg = plot_svg(motion);
    const std::string over_time = bench::plot_motion_svg(motion);
    const std::size_t bodies = system.bodies.size();
    const std::size_t panels = count(svg, "x [m]");
    EXPECT_EQ(count(svg, "<path class=\"path\""), bodies * panels + (bodies > 1 ? bodies : 0) + 1)
        << system.name;
    EXPECT_EQ(count(svg, "tension [N]"), 1U);
    bool rings = false;
    bool moves = false;
    for (const CableOfSystem& cable : system.cables) {
      rings = rings || !cable.through.empty();
      moves = moves || !cable.to.motion.empty();
    }
    EXPECT_EQ(count(svg, ">ring</text>"), rings ? 1U : 0U) << system.name;
    EXPECT_EQ(count(svg, ">moving end</text>"), moves ? 1U : 0U) << system.name;
    for (const BodyOfSystem& body : system.bodies) {
      EXPECT_EQ(count(svg, ">" + body.name + "</text>"), bodies > 1 ? 1U : 0U) << system.name;
      EXPECT_EQ(count(over_time, ">" + body.name + "</text>"), bodies > 1 ? 1U : 0U);
    }
    for (std::size_t index = 0; index < system.cables.size(); ++index) {
      const std::string name = ">cable " + std::to_string(index) + "</text>";
      EXPECT_EQ(count(svg, name) + count(over_time, name), 2U) << system.name << name;
    }
    for (const std::string& picture : {svg, over_time}) {
      EXPECT_TRUE(all_finite(picture)) << system.name;
      EXPECT_EQ(cut_off(picture), "") << system.name;
      EXPECT_LT(picture.size(), 1'000'000U) << system.name;
    }
  }
}

TEST(Plot, ASystemOfACaseIsDrawnAsTheCase) {
  const Case the_case = case_named("plate-four-cables");
  const System system = as_system(the_case);
  const auto solution = solve(system);
  const SystemSettling settled = settling(system, solution);
  const bench::PlotMotion one = bench::plot_motion(the_case, solve(the_case));
  const bench::PlotMotion other = bench::plot_motion(system, solution);
  EXPECT_EQ(one.marks.size(), other.marks.size());
  EXPECT_EQ(one.anchors, other.anchors);
  EXPECT_TRUE(other.moving.empty());
  EXPECT_LT((one.end.bodies[0].centre - other.end.bodies[0].centre).norm(), 1e-6);
  const std::string svg = plot_svg({system, solution, settled, 1.5});
  EXPECT_NE(svg.find("one of many motions from t = 1.5 s on"), std::string::npos);
  EXPECT_NE(svg.find(">start</text>"), std::string::npos);
}

/// A panel of a picture: its frame, its scales and what is drawn in it.
struct SvgPanel {
  std::string id;
  Vec2 low;     // [px]
  Vec2 high;    // [px]
  Vec2 scales;  // [px/m], of both axes, by their numbers; 0: it has fewer than two
  std::string drawn;
};

/// [px/m], by the places and the values of `numbers`.
double scale_of(const std::string& axes, const std::regex& numbers) {
  std::vector<std::pair<double, double>> found;
  for (std::sregex_iterator at(axes.begin(), axes.end(), numbers), end; at != end; ++at) {
    found.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
  }
  return found.size() < 2 ? 0.0
                          : (found.back().first - found.front().first) /
                                (found.back().second - found.front().second);
}

std::vector<SvgPanel> panels_of(const std::string& svg) {
  const std::regex clip(
      "<clipPath id=\"([^\"]*)\"><rect x=\"([^\"]*)\" y=\"([^\"]*)\" width=\"([^\"]*)\" "
      "height=\"([^\"]*)\"/>");
  const std::regex across("text-anchor=\"middle\" x=\"([^\"]*)\" y=\"[^\"]*\">([-0-9.e]+)<");
  const std::regex up("text-anchor=\"end\" x=\"[^\"]*\" y=\"([^\"]*)\">([-0-9.e]+)<");
  std::vector<SvgPanel> result;
  std::size_t from = 0;
  std::smatch found;
  while (
      std::regex_search(svg.begin() + static_cast<std::ptrdiff_t>(from), svg.end(), found, clip)) {
    const std::string axes = found.prefix();
    SvgPanel& panel = result.emplace_back();
    panel.id = found[1];
    panel.low = {std::stod(found[2]), std::stod(found[3])};
    panel.high = panel.low + Vec2(std::stod(found[4]), std::stod(found[5]));
    panel.scales = {scale_of(axes, across), -scale_of(axes, up)};
    const std::string rest = found.suffix();
    panel.drawn = rest.substr(0, rest.find("\n</g>\n"));
    from = svg.size() - rest.size() + panel.drawn.size();
  }
  return result;
}

/// The points of all lines of this class in `drawn`, each with a space in front of it.
std::vector<Vec2> points_of(const std::string& drawn, const std::string& look) {
  std::vector<Vec2> result;
  const std::regex line("<path class=\"" + look + "\"[^>]* d=\"([^\"]*)\"");
  const std::regex point("[ML]([-0-9.]+) ([-0-9.]+)");
  for (std::sregex_iterator at(drawn.begin(), drawn.end(), line), end; at != end; ++at) {
    const std::string d = (*at)[1];
    for (std::sregex_iterator one(d.begin(), d.end(), point); one != end; ++one) {
      result.emplace_back(std::stod((*one)[1]), std::stod((*one)[2]));
    }
  }
  return result;
}

std::size_t acting(const SpatialSystem& system, double time) {
  return static_cast<std::size_t>(
      std::count_if(system.cables.begin(), system.cables.end(),
                    [&](const SpatialCable& cable) { return cable.acts_at(time); }));
}

TEST(Plot, SpaceIsSeenFromThreeSidesAtOneScale) {
  for (const ShippedSpatialSystem& one : shipped_spatial_systems()) {
    const SpatialSystem& system = one.system;
    const auto solution = solve(system);
    const SystemSettling settled = settling(system, solution);
    const bench::SpatialMotion motion = {system, solution, settled, std::nullopt};
    const std::string svg = plot_svg(motion);
    const std::string over_time = bench::plot_motion_svg(motion);
    const std::vector<SvgPanel> panels = panels_of(svg);
    ASSERT_TRUE(panels.size() == 3 || panels.size() == 6) << system.name;
    std::size_t rigid = 0;
    for (const SpatialBody& body : system.bodies) {
      rigid += body.inertia.isZero(0) ? 0U : 1U;
    }
    for (std::size_t index = 0; index < panels.size(); ++index) {
      const SvgPanel& panel = panels[index];
      const std::string where = system.name + " " + panel.id;
      EXPECT_TRUE(panel.id.ends_with(std::array{"-xz", "-yz", "-xy"}.at(index % 3))) << where;
      for (const double scale : panel.scales) {
        const double first = panels[index - index % 3].scales.x();
        EXPECT_NEAR(scale, first, 2e-3 * first) << where;
      }
      EXPECT_EQ(count(panel.drawn, "<path class=\"path\""), system.bodies.size()) << where;
      EXPECT_EQ(count(panel.drawn, "<path class=\"cable before"), acting(system, 0.0)) << where;
      EXPECT_EQ(count(panel.drawn, "<path class=\"cable\"") +
                    count(panel.drawn, "<path class=\"cable slack\""),
                acting(system, solution.end_time()))
          << where;
      for (const char* const pose : {"<g class=\"start\">", "<g class=\"end\">"}) {
        EXPECT_EQ(count(panel.drawn, pose), system.bodies.size()) << where;
        EXPECT_GE(count(panel.drawn, std::string(pose) + "<path class=\"body box\""), rigid)
            << where;
      }
      EXPECT_EQ(count(panel.drawn, "<rect class=\"anchor\""),
                system.name == "hoisted-load" ? 1U : system.cables.size())
          << where;
      const bool whole = panel.id.starts_with("whole");
      for (const char* const look : {"path", "trace", "moving"}) {
        const auto points = points_of(panel.drawn, look);
        const bool off_view = !whole && panels.size() == 6 && look == std::string("moving");
        for (const Vec2& point : points) {
          EXPECT_TRUE(off_view || ((point.array() >= panel.low.array()).all() &&
                                   (point.array() <= panel.high.array()).all()))
              << where << ' ' << look << ' ' << point.transpose();
        }
      }
    }
    EXPECT_EQ(count(svg, "tension [N]"), 1U);
    EXPECT_EQ(count(svg, "solid box of its mass"), rigid > 0 ? 1U : 0U) << system.name;
    EXPECT_NE(svg.find("in space: t = 0 to"), std::string::npos);
    for (const char* part : {"x [m]", "y [m]", "z [m]", "turned from the start [rad]", "gap [m]",
                             "tension [N]", "energy [J]"}) {
      EXPECT_EQ(count(over_time, part), 1U) << system.name << ' ' << part;
    }
    for (std::size_t index = 0; index < system.cables.size(); ++index) {
      const std::string name = ">cable " + std::to_string(index) + "</text>";
      EXPECT_EQ(count(svg, name) + count(over_time, name), 2U) << system.name << name;
    }
    for (const std::string& picture : {svg, over_time}) {
      EXPECT_TRUE(all_finite(picture)) << system.name;
      EXPECT_EQ(cut_off(picture), "") << system.name;
      EXPECT_LT(picture.size(), 1'000'000U) << system.name;
    }
    EXPECT_EQ(svg.find("path to t"), std::string::npos) << system.name << " ends early";
  }
}

/// `planar` in the plane of x and z.
SpatialSystem upright(const System& planar) {
  using Point = BasicVector<double, 3>;
  const auto place = [](const Vec2& point) { return Point(point.x(), 0.0, point.y()); };
  SpatialSystem result;
  result.name = planar.name;
  result.duration = planar.duration;
  result.gravity = Function<3>::constant(place(planar.gravity.at(0.0)));
  for (std::size_t index = 0; index < planar.bodies.size(); ++index) {
    const BodyOfSystem& body = planar.bodies[index];
    SpatialBody& in_space = result.bodies.emplace_back();
    in_space.name = body.name;
    in_space.mass = body.mass;
    in_space.inertia = Point(0.6, 1.0, 0.7) * body.inertia;
    in_space.force = Function<3>::constant(place(body.force.at(0.0)));
    const State& start = planar.initial.bodies[index];
    SpatialState& state = result.initial.bodies.emplace_back();
    state.position = place(start.position);
    state.velocity = place(start.velocity);
    state.orientation = quaternion_of<double>(Point(0.0, -start.angle, 0.0));
    state.spin = Point(0.0, -start.spin, 0.0);
  }
  for (const CableOfSystem& cable : planar.cables) {
    SpatialCable& in_space = result.cables.emplace_back();
    in_space.length = cable.length;
    in_space.restitution = cable.restitution;
    in_space.from = {cable.from.body, place(cable.from.at), {}};
    in_space.to = {cable.to.body, place(cable.to.at), {}};
    for (const End& ring : cable.through) {
      in_space.through.push_back({ring.body, place(ring.at), {}});
    }
  }
  return result;
}

TEST(Plot, ThePlaneIsOneSideOfSpace) {
  for (System planar : {bench::test::named(shipped_systems(), "pulley"),
                        bench::test::named(shipped_systems(), "chain-of-three"),
                        as_system(case_named("plate-four-cables"))}) {
    planar.duration = std::min(planar.duration, 3.0);
    const SpatialSystem in_space = upright(planar);
    ASSERT_EQ(problems(in_space), std::vector<std::string>()) << planar.name;
    const bench::PlotMotion flat = bench::plot_motion(planar, solve(planar));
    const bench::BasicPlotMotion<3> whole = bench::plot_motion(in_space, solve(in_space));
    const bench::PlotMotion front = bench::seen(whole, bench::views<3>().front());
    EXPECT_EQ(front.anchors, flat.anchors) << planar.name;
    EXPECT_EQ(front.rings, flat.rings) << planar.name;
    ASSERT_EQ(front.marks.size(), flat.marks.size()) << planar.name;
    for (std::size_t index = 0; index < flat.marks.size(); ++index) {
      ASSERT_EQ(front.marks[index].places.size(), flat.marks[index].places.size());
    }
    const auto expect_alike = [&](const bench::BasicPose<2>& one,
                                  const bench::BasicPose<2>& other) {
      for (std::size_t body = 0; body < one.bodies.size(); ++body) {
        EXPECT_LT((one.bodies[body].centre - other.bodies[body].centre).norm(), 1e-6)
            << planar.name;
      }
      ASSERT_EQ(one.cables.size(), other.cables.size());
      for (std::size_t cable = 0; cable < one.cables.size(); ++cable) {
        EXPECT_EQ(one.cables[cable].taut, other.cables[cable].taut) << planar.name;
        for (std::size_t i = 0; i < one.cables[cable].points.size(); ++i) {
          EXPECT_LT((one.cables[cable].points[i] - other.cables[cable].points[i]).norm(), 1e-6);
        }
        for (std::size_t i = 0; i < one.cables[cable].lowest.size(); ++i) {
          EXPECT_LT((one.cables[cable].lowest[i] - other.cables[cable].lowest[i]).norm(), 1e-5);
        }
      }
    };
    expect_alike(front.start, flat.start);
    expect_alike(front.end, flat.end);
    const bench::PlotMotion side = bench::seen(whole, bench::views<3>()[1]);
    for (const auto& path : side.paths) {
      for (const Vec2& point : path) {
        EXPECT_NEAR(point.x(), 0.0, 1e-9) << planar.name << " leaves its plane";
      }
    }
    EXPECT_EQ(front.side, "front");
  }
}

TEST(Plot, ABodyInSpaceIsTheBoxOfItsMoments) {
  for (const ShippedSpatialSystem& one : shipped_spatial_systems()) {
    if (one.system.name != "crane-slings") {
      continue;
    }
    const SpatialSystem& system = one.system;  // a load of 2 m, 1 m and 0.5 m
    const auto motion = bench::plot_motion(system, solve(system));
    const auto& load = motion.start.bodies.front();
    ASSERT_EQ(load.faces.size(), 6U);
    bench::BasicExtent<3> extent;
    for (const auto& face : load.faces) {
      extent.add(face);
    }
    EXPECT_LT((extent.size() - BasicVector<double, 3>(2.0, 1.0, 0.5)).norm(), 1e-12);
    EXPECT_TRUE(load.points.empty()) << "the slings are at its corners";
    EXPECT_EQ(motion.traces.size(), 4U);
    for (const bench::View& view : bench::views<3>()) {
      // level at the start: one face, and four seen from their edges
      const auto faces = bench::seen(motion, view).start.bodies.front().faces;
      EXPECT_EQ(faces.size(), 5U) << view.name;
    }
  }
}

TEST(Plot, SpaceHasRingsAndAnyDirectionUp) {
  SpatialSystem system = upright(bench::test::named(shipped_systems(), "pulley"));
  system.gravity = Function<3>::constant(BasicVector<double, 3>(0.0, -9.81, 0.0));
  const auto solution = solve(system);
  const SystemSettling settled = settling(system, solution);
  const std::string svg = plot_svg(bench::SpatialMotion{system, solution, settled, 0.25});
  EXPECT_EQ(count(svg, ">ring</text>"), 1U);
  EXPECT_NE(svg.find("one of many motions from t = 0.25 s on"), std::string::npos);
  for (const char* name : {"seen along x", "seen along y", "seen along z"}) {
    EXPECT_NE(svg.find(name), std::string::npos) << name;
  }
  EXPECT_EQ(svg.find(">front<"), std::string::npos);
  EXPECT_EQ(svg.find("box of"), std::string::npos) << "it has point masses alone";
}

TEST(Plot, ManyBodiesWithHostileNamesFit) {
  System system = shipped_systems().back().system;  // a row of balls
  system.bodies.clear();
  system.cables.clear();
  system.initial.bodies.clear();
  for (std::size_t index = 0; index < max_bodies; ++index) {
    system.bodies.emplace_back().name =
        "</text><script>\x1b" + std::to_string(index) + std::string(200, 'W');
    system.initial.bodies.push_back({{static_cast<double>(index), 0.0}, 0.0, {0.0, 1.0}, 0.0});
    CableOfSystem& cable = system.cables.emplace_back();
    cable.from.body = index;
    cable.to = {std::nullopt, {static_cast<double>(index), 0.5}, {}};
  }
  const auto solution = solve(system);
  const SystemSettling settled = settling(system, solution);
  const bench::SystemMotion motion = {system, solution, settled, std::nullopt};
  for (const std::string& svg : {plot_svg(motion), bench::plot_motion_svg(motion)}) {
    EXPECT_EQ(cut_off(svg), "");
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_EQ(svg.find('\x1b'), std::string::npos);
    EXPECT_EQ(count(svg, "&lt;/text&gt;&lt;script"), max_bodies);
    EXPECT_EQ(count(svg, ">cable 7</text>"), 1U);
  }
}

TEST(Plot, GoesToAFileOrToStandardOutputAndSaysWhenItCannot) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "p.svg").string();
  const Outcome to_file = program({"solve", "bouncing-ball", "--plot", file});
  EXPECT_EQ(to_file.code, 0);
  EXPECT_NE(to_file.output.find("event at"), std::string::npos);
  const Outcome to_output = program({"solve", "bouncing-ball", "--plot", "-"});
  EXPECT_EQ(to_output.output, content_of(file));
  EXPECT_TRUE(to_output.output.starts_with("<svg"));
  const Outcome nowhere = program({"solve", "bouncing-ball", "--plot", "/proc/p.svg"});
  EXPECT_EQ(nowhere.code, 1);
  EXPECT_NE(nowhere.errors.find("cannot write /proc/p.svg"), std::string::npos) << nowhere.errors;
  EXPECT_EQ(program({"solve", "bouncing-ball", "--plot", "-", "--json", "-"}).code, 2);
}

TEST(Plot, ANameThatIsEmptyOrTakenIsRefused) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "p").string();
  const std::string same = (folder.path() / "." / "p").string();
  for (const auto& [option, name] : {std::pair{"--plot", ""}, {"--json", ""}}) {
    const Outcome empty = program({"solve", "bouncing-ball", option, name});
    EXPECT_EQ(empty.code, 2) << option;
    EXPECT_NE(empty.errors.find("must be the name of a file, or -"), std::string::npos)
        << empty.errors;
    EXPECT_EQ(empty.output, "");
  }
  const Outcome both = program({"solve", "bouncing-ball", "--plot", file, "--json", same});
  EXPECT_EQ(both.code, 2);
  EXPECT_NE(both.errors.find("would overwrite"), std::string::npos) << both.errors;
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace tautline::test
