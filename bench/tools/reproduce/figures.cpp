#include "bench/tools/reproduce/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/tools/reproduce/checks.hpp"
#include "bench/tools/reproduce/source.hpp"
#include "tautline/geometry.hpp"
#include "tautline_bench_reproduce_words.inc"

namespace tautline::bench {

namespace {

using namespace fmt::literals;

/// The columns of `motion_data`.
namespace motion_column {
inline constexpr std::size_t time = 0;
inline constexpr std::size_t x = 1;
inline constexpr std::size_t y = 2;
inline constexpr std::size_t angle = 3;
}  // namespace motion_column

/// The columns of `impacts_data`.
namespace impacts_column {
inline constexpr std::size_t time = 0;
inline constexpr std::size_t cable = 1;
inline constexpr std::size_t speed = 2;  // normal velocity before
}  // namespace impacts_column

/// The columns of `boundary_data`.
namespace boundary_column {
inline constexpr std::size_t x = 0;
inline constexpr std::size_t lowest = 3;
}  // namespace boundary_column

/// A cable that is held closes at rounding only [sqrt(gS)].
constexpr double resting_speed = 1e-12;

DataRow motion_row(const ChapterCase& solved, double time, const State& state,
                   std::string_view side, std::string_view kind) {
  return {{time, state.position.x(), state.position.y(), state.angle, state.velocity.x(),
           state.velocity.y(), state.spin, energy(solved.the_case, state)},
          {side, kind}};
}

/// Where the motion of a figure ends: at rest, or with the solution.
double figure_end(const ChapterCase& solved) {
  const auto& lock = solved.settling.lock;
  const double end = solved.solution.end_time();
  return lock && lock->rests ? std::min(end, std::ceil(lock->time)) : end;
}

/// The whole motion: a row each `figure_step` and two at each event, before and after.
FigureData motion_data(const ChapterCase& solved) {
  FigureData data{{"t [sqrt(S/g)]", "x [S]", "y [S]", "theta [rad]", "vx [sqrt(gS)]",
                   "vy [sqrt(gS)]", "vtheta [sqrt(g/S)]", "energy [mgS]", "event", "kind"},
                  {}};
  const double end = figure_end(solved);
  const auto samples = static_cast<int>(std::lround(end / figure_step));
  auto event = solved.solution.events().begin();
  for (int index = 0; index <= samples; ++index) {
    const double time = std::min(index * figure_step, end);
    for (; event != solved.solution.events().end() && event->time <= time; ++event) {
      const std::string_view kind = to_string(event->kind);
      data.rows.push_back(motion_row(solved, event->time, event->before, "before", kind));
      data.rows.push_back(motion_row(solved, event->time, event->after, "after", kind));
    }
    data.rows.push_back(motion_row(solved, time, solved.solution.at(time), "", ""));
  }
  return data;
}

/// One row per impact and cable: normal velocity and energy before and after.
FigureData impacts_data(const ChapterCase& solved) {
  FigureData data{{"t [sqrt(S/g)]", "cable", "vn before [sqrt(gS)]", "vn after [sqrt(gS)]",
                   "energy before [mgS]", "energy after [mgS]"},
                  {}};
  for (const Event& event : solved.solution.events()) {
    for (const std::size_t index : event.cables) {
      const Cable& cable = solved.the_case.cables[index];
      // the chapter's normal velocity stretches the cable where it is above 0
      const double before = -gap_rate(cable, event.before);
      if (event.kind == EventKind::impact && before > resting_speed) {
        data.rows.push_back(
            {{event.time, static_cast<double>(index), before, -gap_rate(cable, event.after),
              energy(solved.the_case, event.before), energy(solved.the_case, event.after)},
             {}});
      }
    }
  }
  return data;
}

/// Where the centre of mass is on g1 = 0 and on g2 = 0 at angle 0 (Eqs. 5.65 and 5.93): x, then
/// the two and the lower bound of both.
FigureData boundary_data(const Breakwater& parameters) {
  FigureData data{{"x [S]", "y on g1 = 0 [S]", "y on g2 = 0 [S]", "lowest y [S]"}, {}};
  const double r = parameters.r;
  const double span = 1.0 - parameters.a;
  const double h = std::sqrt(r * r - span * span);
  // between these neither cable, stretched, is above its anchor's height
  const double reach = r - span;
  constexpr int half = 200;  // samples on each side
  for (int index = -half; index <= half; ++index) {
    const double x = reach * index / half;
    const auto boundary = [&](double across) {
      return h - std::sqrt(std::max(0.0, r * r - across * across));
    };
    const double right = boundary(span - x);
    const double left = boundary(span + x);
    data.rows.push_back({{x, right, left, std::max(right, left)}, {}});
  }
  return data;
}

enum class Plot { trajectory, rotation, impacts };

/// A figure of the chapter: what its caption names.
struct Caption {
  std::string_view figure;
  Plot plot;
  std::string_view number;   // of the case
  std::string_view chapter;  // what the text says of it
};

constexpr Caption captions[] = {
    {"5.6", Plot::trajectory, "1910121100", words::of_size},
    {"5.7", Plot::trajectory, "2910121100", words::of_size},
    {"5.8", Plot::trajectory, "1911121100", words::of_flatness},
    {"5.9", Plot::trajectory, "2911121100", words::of_flatness},
    {"5.10", Plot::trajectory, "1921121100", words::of_flatness},
    {"5.11", Plot::trajectory, "2921121100", words::of_flatness},
    {"5.12", Plot::rotation, "1911121100", words::of_rotation},
    {"5.13", Plot::rotation, "1921121100", words::of_rotation},
    {"5.14", Plot::rotation, "1931121100", words::of_rotation},
    {"5.15", Plot::impacts, "1110121100", words::of_elastic},
    {"5.16", Plot::impacts, "1910121100", words::of_restitution},
    {"5.17", Plot::impacts, "1710121100", words::of_restitution},
    {"5.18", Plot::impacts, "1510121100", words::of_restitution},
    {"5.19", Plot::trajectory, "1900461100", words::of_point},
    {"5.20", Plot::trajectory, "1900461100", words::of_point},
};

/// "5.6" as "figure_5_06": sorted by name is sorted by number.
std::string stem(std::string_view figure) {
  return fmt::format("figure_5_{:0>2}", figure.substr(2));
}

/// The last impact that Table 5.3 prints.
double last_printed_impact() {
  return printed_value(split(printed_table_5_3().back().cells).front());
}

/// From where the chapter and the exact motion part, for a plot to show.
std::vector<FigureMark> marks(const ChapterStudy& study, const ChapterCase& solved) {
  std::vector<FigureMark> result;
  if (is_point_mass(solved.the_case) || &solved == &study.rigid_point) {
    result.push_back({last_printed_impact(), "the chapter's last impact"});
  }
  if (solved.parameters.e == 1.0) {  // exactly: as given
    result.push_back({study.limit_time, "the chapter's rotation limit"});
  }
  if (const auto& lock = solved.settling.lock) {
    result.push_back({lock->time, lock->rests ? "at rest" : "both cables taut from here on"});
  }
  return result;
}

/// What the motion does at its end, and where the chapter takes leave of it.
std::string end_sentence(const ChapterStudy& study, const ChapterCase& solved) {
  const auto& lock = solved.settling.lock;
  const double start = energy(solved.the_case, solved.the_case.initial);
  if (!lock) {
    const double end = solved.solution.end_time();
    return fmt::format(words::goes_on, "limit"_a = study.limit_time,
                       "energy"_a = energy(solved.the_case, solved.solution.at(end)),
                       "end"_a = end);
  }
  if (lock->rests) {
    return fmt::format(words::rests, "last"_a = last_printed_impact(), "rest"_a = lock->time);
  }
  return fmt::format(words::swings_on, "time"_a = lock->time,
                     "amplitude"_a = lock->swing->amplitude, "period"_a = lock->swing->period,
                     "energy"_a = lock->swing->energy,
                     "percent"_a = 100.0 * lock->swing->energy / start, "start"_a = start);
}

/// What the motion shows on the point that the chapter makes.
std::string finding(const ChapterStudy& study, const ChapterCase& solved, Plot plot) {
  const Breakwater& p = solved.parameters;
  if (plot == Plot::impacts) {
    return fmt::format(words::fast_impacts,
                       "impacts"_a = impact_count(solved.the_case, solved.solution, counted_speed),
                       "speed"_a = counted_speed, "fastest"_a = fastest_impact(solved));
  }
  const std::string angle = fmt::format("{:.4f}", largest_angle(solved));
  if (plot == Plot::rotation) {
    return fmt::format("Inertia {:.4f}, largest |theta| {} rad.", solved.the_case.body.inertia,
                       angle);
  }
  const double difference =
      p.a > 0.0 ? 0.0 : largest_difference(study.at(solved.number), study.rigid_point);
  return fmt::format("At angle 0 the boundaries meet at {:.1f} degrees{}. {}",
                     corner_angle(p) * 180.0 / std::numbers::pi, p.b > 0.0 ? ", for any b" : "",
                     p.a > 0.0 ? fmt::format("The largest |theta| is {} rad.", angle)
                     : difference == 0.0
                         ? words::same_motions
                         : fmt::format(words::different_motions, "difference"_a = difference));
}

ChapterFigure figure(const ChapterStudy& study, const Caption& caption) {
  const bool rigid_point = caption.figure == "5.20";
  const ChapterCase& solved = rigid_point ? study.rigid_point : study.at(caption.number);
  ChapterFigure result;
  result.number = caption.figure;
  result.case_number = caption.number;
  result.file = stem(caption.figure) + ".csv";
  result.chapter = caption.chapter;
  result.truth = finding(study, solved, caption.plot) + " " + end_sentence(study, solved);
  result.marks = marks(study, solved);
  const auto& [r, e, a, b, shape, initial, duration] = solved.parameters;
  const std::string body = fmt::format("r = {}, e = {}, a = {}, b = {}", r, e, a, b);
  switch (caption.plot) {
    case Plot::trajectory:
      result.title = fmt::format("y over x, {}case {} ({})",
                                 a > 0.0       ? ""
                                 : rigid_point ? "a rigid body without dimensions, "
                                               : "the point mass, ",
                                 caption.number, body);
      result.data = motion_data(solved);
      result.x = motion_column::x;
      result.y = motion_column::y;
      result.boundary = {stem(caption.figure) + "_boundary.csv", boundary_data(solved.parameters)};
      break;
    case Plot::rotation:
      result.title = fmt::format("theta over t, case {} ({})", caption.number, body);
      result.data = motion_data(solved);
      result.x = motion_column::time;
      result.y = motion_column::angle;
      break;
    case Plot::impacts:
      result.title =
          fmt::format("normal velocity before impact over t, case {} ({})", caption.number, body);
      result.data = impacts_data(solved);
      result.x = impacts_column::time;
      result.y = impacts_column::speed;
      result.by = impacts_column::cable;
      break;
  }
  return result;
}

struct Point {
  double x;
  double y;
};
using Points = std::vector<Point>;

/// A curve may be off by so much of its extent: less than a pixel of a large plot.
constexpr double invisible = 5e-4;

/// How far `point` is from the line through `one` and `other`, or from `one` if they coincide.
double distance(const Point& point, const Point& one, const Point& other) {
  const double x = other.x - one.x;
  const double y = other.y - one.y;
  const double length = std::hypot(x, y);
  return length > 0.0 ? std::abs(x * (point.y - one.y) - y * (point.x - one.x)) / length
                      : std::hypot(point.x - one.x, point.y - one.y);
}

/// The points that a polygon needs to stay within `tolerance` of `curve` (Ramer, Douglas and
/// Peucker): the corners at impacts stay.
Points polygon(const Points& curve, double tolerance) {
  std::vector<bool> kept(curve.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, curve.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    kept[first] = kept[last] = true;
    std::size_t farthest = first;
    double largest = tolerance;
    for (std::size_t index = first + 1; index < last; ++index) {
      const double away = distance(curve[index], curve[first], curve[last]);
      if (away > largest) {
        largest = away;
        farthest = index;
      }
    }
    if (farthest != first) {
      open.emplace_back(first, farthest);
      open.emplace_back(farthest, last);
    }
  }
  Points result;
  for (std::size_t index = 0; index < curve.size(); ++index) {
    if (kept[index]) {
      result.push_back(curve[index]);
    }
  }
  return result;
}

/// `curve` with both axes drawn to their own extents in mind, in at most `most_points`.
Points thinned(const Points& curve) {
  if (curve.size() < 3) {
    return curve;
  }
  const auto by_x = [](const Point& one, const Point& two) { return one.x < two.x; };
  const auto by_y = [](const Point& one, const Point& two) { return one.y < two.y; };
  const auto [left, right] = std::minmax_element(curve.begin(), curve.end(), by_x);
  const auto [low, high] = std::minmax_element(curve.begin(), curve.end(), by_y);
  const double width = right->x > left->x ? right->x - left->x : 1.0;
  const double height = high->y > low->y ? high->y - low->y : 1.0;
  Points drawn;
  drawn.reserve(curve.size());
  for (const Point& point : curve) {
    drawn.push_back({point.x / width, point.y / height});
  }
  double tolerance = invisible;
  Points result = polygon(drawn, tolerance);
  while (result.size() > most_points) {
    tolerance *= 1.5;
    result = polygon(drawn, tolerance);
  }
  for (Point& point : result) {
    point = {point.x * width, point.y * height};
  }
  return result;
}

/// The fastest `most_points` impacts in the order of time.
Points fastest(Points impacts) {
  if (impacts.size() > most_points) {
    const auto cut = impacts.begin() + static_cast<std::ptrdiff_t>(most_points);
    std::nth_element(impacts.begin(), cut, impacts.end(),
                     [](const Point& one, const Point& two) { return one.y > two.y; });
    impacts.erase(cut, impacts.end());
    std::sort(impacts.begin(), impacts.end(),
              [](const Point& one, const Point& two) { return one.x < two.x; });
  }
  return impacts;
}

Points points_of(const FigureData& data, std::size_t x, std::size_t y) {
  Points points;
  for (const DataRow& row : data.rows) {
    points.push_back({row.numbers[x], row.numbers[y]});
  }
  return points;
}

Curve curve_of(const std::string& name, const Points& points) {
  Curve curve{name, {}, {}};
  for (const Point& point : points) {
    curve.x.push_back(point.x);
    curve.y.push_back(point.y);
  }
  return curve;
}

}  // namespace

std::vector<ChapterFigure> chapter_figures(const ChapterStudy& study) {
  return listed(captions, [&](const Caption& caption) { return figure(study, caption); });
}

std::vector<Curve> figure_curves(const ChapterFigure& figure) {
  if (!figure.by) {
    const Points motion = points_of(figure.data, figure.x, figure.y);
    return {curve_of("case " + figure.case_number, thinned(motion))};
  }
  std::map<std::size_t, Points> of_cable;
  for (const DataRow& row : figure.data.rows) {
    const auto cable = static_cast<std::size_t>(row.numbers[*figure.by]);
    of_cable[cable].push_back({row.numbers[figure.x], row.numbers[figure.y]});
  }
  return listed(of_cable, [](const auto& one) {
    return curve_of("cable " + std::to_string(one.first), fastest(one.second));
  });
}

Curve boundary_curve(const Boundary& boundary) {
  return curve_of("boundary at angle 0",
                  thinned(points_of(boundary.data, boundary_column::x, boundary_column::lowest)));
}

}  // namespace tautline::bench
