#include "bench/tools/trend/version_trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "bench/base/text.hpp"
#include "bench/page/document.hpp"
#include "bench/plot/svg.hpp"

namespace tautline::bench {
namespace {

// of the sheet [px]
constexpr double column_width = 330.0;
constexpr double panel_height = 150.0;
constexpr double left = 76.0;
constexpr double top = 84.0;
constexpr double across = 56.0;  // from a panel to the next
constexpr double down = 34.0;
constexpr double legend_line = 20.0;
constexpr double versions_room = 46.0;  // of a name under a panel
constexpr double apart = 16.0;          // at least, from a version's name to the next

using Points = std::vector<std::optional<double>>;

/// A quantity over the versions: its name, and the points of each model and step.
struct Quantity {
  std::string name;
  std::map<SetupKey, Points> lines;
};

/// The metrics that are looked at first, and the cost.
std::vector<Quantity> quantities_of(const Trend& trend) {
  constexpr std::array<std::string_view, 2> shown = {"early_position_error", "restitution_error"};
  std::vector<Quantity> result;
  for (const std::string_view name : shown) {
    const std::size_t place = place_of(name).value();
    const Metric& metric = metric_list()[place];
    Quantity& quantity = result.emplace_back();
    quantity.name = (metric.group.empty() ? "" : std::string(metric.group) + ", ") +
                    std::string(metric.heading) +
                    (metric.unit == "1" ? "" : " [" + std::string(metric.unit) + "]");
    for (const TrendRow& row : trend.rows) {
      if (row.metric == place) {
        Points& points = quantity.lines[row.key];
        for (const std::optional<TrendPoint>& point : row.points) {
          points.push_back(point ? std::optional(point->median) : std::nullopt);
        }
      }
    }
  }
  Quantity& cost = result.emplace_back();
  cost.name = "cost of a simulated second [s]";
  for (const TrendCost& one : trend.costs) {
    cost.lines.emplace(one.key, one.points);
  }
  return result;
}

/// Powers of ten around every number above 0; what is 0 lies on the lowest.
struct Decades {
  explicit Decades(const Quantity& quantity) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const auto& [key, points] : quantity.lines) {
      for (const std::optional<double>& point : points) {
        if (point && *point > 0.0) {
          least = std::min(least, *point);
          most = std::max(most, *point);
        }
      }
    }
    if (most > 0.0) {
      low = static_cast<int>(std::floor(std::log10(least)));
      high = std::max(low + 1, static_cast<int>(std::ceil(std::log10(most))));
    }
  }
  [[nodiscard]] double height_of(double value) const {
    const double exponent = value > 0.0 ? std::log10(value) : low;
    return panel_height * (high - std::max(exponent, static_cast<double>(low))) / (high - low);
  }

  int low = 0;
  int high = 1;
};

/// Where panels, versions and models lie.
struct Sheet {
  explicit Sheet(const VersionTrend& trend_of) {
    for (const TrendVersion& version : trend_of.versions) {
      const std::string name = printable(version.version);
      if (version.report) {
        with_report.push_back(versions.size());
      }
      versions.push_back(version.report ? name : "(" + name + ")");
    }
    const Trend& trend = *trend_of.trend;
    std::set<double> found;
    std::set<std::string> names;
    for (const TrendRow& row : trend.rows) {
      found.insert(row.key.step);
      names.insert(row.key.model);
    }
    steps.assign(found.rbegin(), found.rend());
    models.assign(names.begin(), names.end());
  }
  [[nodiscard]] double x(std::size_t column, std::size_t version) const {
    const double part = (static_cast<double>(version) + 0.5) / static_cast<double>(versions.size());
    return left + static_cast<double>(column) * (column_width + across) + column_width * part;
  }
  /// How the line of a model looks, as attributes.
  [[nodiscard]] std::string look(const std::string& model) const {
    const auto place =
        static_cast<std::size_t>(std::find(models.begin(), models.end(), model) - models.begin());
    return line_look(place, place);
  }
  /// Of each version its name, or of so many that they would run into each other of every nth, back
  /// from the newest.
  [[nodiscard]] bool is_named(std::size_t version) const {
    const auto most = static_cast<std::size_t>(column_width / apart);
    return (versions.size() - 1 - version) % (1 + (versions.size() - 1) / most) == 0;
  }

  std::vector<std::string> versions;     // in brackets without a report
  std::vector<std::size_t> with_report;  // of each report its version
  std::vector<double> steps;             // the longest first
  std::vector<std::string> models;
};

std::string frame(const Sheet& sheet, std::size_t column, double y, const Decades& decades) {
  const double start = left + static_cast<double>(column) * (column_width + across);
  std::string out;
  const int every = std::max(1, (decades.high - decades.low) / 5);
  for (int power = decades.low; power <= decades.high; power += every) {
    out += grid_across(start, y + decades.height_of(std::pow(10.0, power)), column_width,
                       fmt::format("1e{}", power));
  }
  for (std::size_t index = 0; index < sheet.versions.size(); ++index) {
    const double at = sheet.x(column, index);
    out += grid_down(at, y, panel_height) + "\n";
    if (sheet.is_named(index)) {
      out += turned_text(at, y + panel_height + 14.0, -40, sheet.versions[index], "end");
    }
  }
  return out + rectangle(frame_look, start, y, column_width, panel_height) + "\n";
}

/// A line for each model, interrupted where a version has no such run.
std::string curves(const Sheet& sheet, std::size_t column, double y, const Quantity& quantity,
                   const Decades& decades) {
  std::string out;
  for (const auto& [key, points] : quantity.lines) {
    if (key.step != sheet.steps[column]) {  // both are the same number of a report
      continue;
    }
    std::string line;
    std::string dots;
    std::optional<std::size_t> last;  // version with a point
    for (std::size_t index = 0; index < points.size(); ++index) {
      if (!points[index]) {
        continue;
      }
      const std::size_t version = sheet.with_report[index];
      const double x = sheet.x(column, version);
      const double at = y + decades.height_of(*points[index]);
      line += fmt::format("{}{:.1f} {:.1f}", last && *last + 1 == version ? 'L' : 'M', x, at);
      dots += fmt::format("M{:.1f} {:.1f}h0", x, at);  // a round cap is a dot
      last = version;
    }
    out += fmt::format(
        "<g {}><path d=\"{}\" stroke-width=\"1.6\"/><path d=\"{}\" stroke-width=\"6\" "
        "stroke-dasharray=\"none\" stroke-linecap=\"round\"/></g>\n",
        sheet.look(key.model), line, dots);
  }
  return out;
}

std::string legend(const Sheet& sheet, double y) {
  std::string out;
  for (const std::string& model : sheet.models) {
    out += legend_entry(left, y, sheet.look(model) + " stroke-width=\"2.4\"", printable(model));
    y += legend_line;
  }
  return out;
}

}  // namespace

std::string version_csv(const VersionTrend& versions) {
  const Sheet sheet(versions);
  std::string csv = csv_line({"quantity", "model", "step [s]", "version", "median over the cases"});
  for (const Quantity& quantity : quantities_of(*versions.trend)) {
    for (const auto& [key, points] : quantity.lines) {
      for (std::size_t index = 0; index < points.size(); ++index) {
        csv += csv_line({quantity.name, printable(key.model), fmt::format("{}", key.step),
                         sheet.versions[sheet.with_report[index]],
                         points[index] ? fmt::format("{}", *points[index]) : ""});
      }
    }
  }
  return csv;
}

std::string version_svg(const VersionTrend& versions) {
  const Sheet sheet(versions);
  const std::vector<Quantity> quantities = quantities_of(*versions.trend);
  std::string panels;
  double y = top;
  for (const Quantity& quantity : quantities) {
    const Decades decades(quantity);
    panels += fmt::format("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", left, y - 8.0,
                          xml_text(quantity.name));
    for (std::size_t column = 0; column < sheet.steps.size(); ++column) {
      panels += frame(sheet, column, y, decades) + curves(sheet, column, y, quantity, decades);
    }
    y += panel_height + versions_room + down;
  }
  for (std::size_t column = 0; column < sheet.steps.size(); ++column) {
    panels +=
        muted_text(left + static_cast<double>(column) * (column_width + across) + column_width,
                   top - 8.0, fmt::format("step {:g} s", sheet.steps[column]), "end");
  }
  const double columns = static_cast<double>(std::max<std::size_t>(1, sheet.steps.size()));
  const std::string reading = fmt::format(
      "Medians over the cases; 0 lies on the lowest line{}.",
      sheet.with_report.size() < sheet.versions.size() ? "; (a version) has no report" : "");
  const std::string title = version_title(versions);
  return svg_sheet({.width = std::max({left + columns * (column_width + across),
                                       left + room_for(title, title_letters),
                                       left + room_for(reading, letters)}),
                    .height = y + legend_line * static_cast<double>(sheet.models.size()),
                    .left = left,
                    .title = title,
                    .description = "Error and cost over versions. " + reading,
                    .line = reading},
                   panels + legend(sheet, y - 20.0));
}

}  // namespace tautline::bench
