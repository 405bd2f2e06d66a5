#include "bench/chapter/beside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/chapter/report.hpp"
#include "bench/report/replay_data.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

struct Point {
  double x;
  double y;
};
using Curve = std::vector<Point>;

constexpr std::size_t most_points = 600;  // of a curve; a plot is not wider in pixels

/// A curve may be off by so much of its extent: less than a pixel of a large plot.
constexpr double invisible = 5e-4;

/// The fields of each line of a CSV file without quotes; the headings first.
std::vector<std::vector<std::string>> csv_rows(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(csv);
  for (std::string line; std::getline(text, line);) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) {
      rows.back().push_back(field);
    }
  }
  return rows;
}

std::size_t column_of(const std::vector<std::vector<std::string>>& rows, const std::string& name) {
  const auto found = std::find(rows.front().begin(), rows.front().end(), name);
  return static_cast<std::size_t>(found - rows.front().begin());
}

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
Curve polygon(const Curve& curve, double tolerance) {
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
  Curve result;
  for (std::size_t index = 0; index < curve.size(); ++index) {
    if (kept[index]) {
      result.push_back(curve[index]);
    }
  }
  return result;
}

/// `curve` with both axes drawn to their own extents in mind, in at most `most_points`.
Curve thinned(const Curve& curve) {
  if (curve.size() < 3) {
    return curve;
  }
  const auto by_x = [](const Point& one, const Point& two) { return one.x < two.x; };
  const auto by_y = [](const Point& one, const Point& two) { return one.y < two.y; };
  const auto [left, right] = std::minmax_element(curve.begin(), curve.end(), by_x);
  const auto [low, high] = std::minmax_element(curve.begin(), curve.end(), by_y);
  const double width = right->x > left->x ? right->x - left->x : 1.0;
  const double height = high->y > low->y ? high->y - low->y : 1.0;
  Curve drawn;
  drawn.reserve(curve.size());
  for (const Point& point : curve) {
    drawn.push_back({point.x / width, point.y / height});
  }
  double tolerance = invisible;
  Curve result = polygon(drawn, tolerance);
  while (result.size() > most_points) {
    tolerance *= 1.5;
    result = polygon(drawn, tolerance);
  }
  for (Point& point : result) {
    point = {point.x * width, point.y * height};
  }
  return result;
}

ordered_json curve_json(const std::string& name, const Curve& curve) {
  ordered_json x = ordered_json::array();
  ordered_json y = ordered_json::array();
  for (const Point& point : curve) {
    x.push_back(rounded(point.x));
    y.push_back(rounded(point.y));
  }
  return {{"name", name}, {"x", std::move(x)}, {"y", std::move(y)}};
}

Curve curve_of(const std::vector<std::vector<std::string>>& rows, std::size_t x, std::size_t y) {
  Curve curve;
  for (std::size_t index = 1; index < rows.size(); ++index) {
    curve.push_back({std::stod(rows[index].at(x)), std::stod(rows[index].at(y))});
  }
  return curve;
}

/// The fastest `most_points` impacts in the order of time.
Curve fastest(Curve impacts) {
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

/// One curve of a motion; of impacts, the points of each cable.
ordered_json curves_json(const ChapterFigure& figure) {
  const auto rows = csv_rows(figure.csv);
  const std::size_t x = column_of(rows, figure.x);
  const std::size_t y = column_of(rows, figure.y);
  const std::size_t cable = column_of(rows, "cable");
  ordered_json curves = ordered_json::array();
  if (cable == rows.front().size()) {
    curves.push_back(curve_json("case " + figure.case_number, thinned(curve_of(rows, x, y))));
    return curves;
  }
  std::map<std::string, Curve> of_cable;
  for (std::size_t index = 1; index < rows.size(); ++index) {
    of_cable[rows[index].at(cable)].push_back(
        {std::stod(rows[index].at(x)), std::stod(rows[index].at(y))});
  }
  for (const auto& [name, impacts] : of_cable) {
    curves.push_back(curve_json("cable " + name, fastest(impacts)));
  }
  return curves;
}

ordered_json boundary_json(const ChapterFigure& figure) {
  if (figure.boundary_file.empty()) {
    return nullptr;
  }
  const auto rows = csv_rows(figure.boundary_csv);
  ordered_json curves = ordered_json::array();
  for (std::size_t column = 1; column < rows.front().size(); ++column) {
    curves.push_back(curve_json(rows.front()[column], thinned(curve_of(rows, 0, column))));
  }
  return {{"curves", std::move(curves)}};
}

ordered_json figure_json(const ChapterFigure& figure) {
  return {
      {"name", figure.number}, {"title", figure.title},         {"x", figure.x},
      {"y", figure.y},         {"curves", curves_json(figure)}, {"boundary", boundary_json(figure)},
      {"marks", figure.marks}, {"chapter", figure.chapter},     {"truth", figure.truth}};
}

/// What the chapter missed altogether: the motion that remains when it takes the body for settled.
bool of_the_swing(const Correction& correction) { return correction.numbers.contains("swinging"); }

}  // namespace

ordered_json chapter_row(const ChapterStudy& study) {
  ChapterReport report = chapter_report(study);
  std::stable_partition(report.corrections.begin(), report.corrections.end(), of_the_swing);
  ordered_json result = {{"tables", ordered_json::array()},
                         {"figures", ordered_json::array()},
                         {"corrections", ordered_json::array()}};
  for (const ChapterTable& table : report.tables) {
    const ordered_json whole = table_json(table);
    ordered_json& row = result["tables"].emplace_back();
    for (const char* key : {"name", "title", "columns", "rows", "notes"}) {
      row[key] = whole.at(key);
    }
  }
  for (const ChapterFigure& figure : report.figures) {
    result["figures"].push_back(figure_json(figure));
  }
  for (const Correction& one : report.corrections) {
    result["corrections"].push_back({{"where", one.where},
                                     {"chapter", one.chapter},
                                     {"right", one.right},
                                     {"shown", one.shown},
                                     {"holds", one.holds}});
  }
  return result;
}

bool runs_the_chapter(const SuiteOptions& options) {
  const std::vector<std::string> all = {"breakwater/*"};
  const std::vector<Case> chapter = select_cases(all).cases;
  return std::all_of(chapter.begin(), chapter.end(), [&](const Case& wanted) {
    return std::any_of(options.cases.begin(), options.cases.end(), [&](const Case& one) {
      return one.name == wanted.name && one.duration == wanted.duration;  // exactly: as shipped
    });
  });
}

ChapterBeside::ChapterBeside(bool wanted) {
  if (!wanted) {
    promise_.set_value(nullptr);
    return;
  }
  thread_ = std::jthread([this](const std::stop_token& stop) {
    struct GivenUp {};
    try {
      promise_.set_value(chapter_row(solve_chapter([&stop](std::size_t) {
        if (stop.stop_requested() || interruption()) {
          throw GivenUp();
        }
      })));
    } catch (const GivenUp&) {
      promise_.set_value(nullptr);
    } catch (const std::exception& error) {  // the runs beside it are worth their report
      failure_ = error.what();
      promise_.set_value(nullptr);
    }
  });
}

ordered_json ChapterBeside::result() { return promise_.get_future().get(); }

}  // namespace tautline::bench
