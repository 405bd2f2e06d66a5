#include "bench/gate/trend/version_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "bench/base/text.hpp"
#include "bench/gate/trend/version_tables.hpp"
#include "bench/solution/plot_panel.hpp"
#include "bench/solution/plot_style.hpp"

namespace tautline::bench {
namespace {

// of the sheet [px]
constexpr double panel_width = 330.0;
constexpr double panel_height = 150.0;
constexpr double left = 76.0;
constexpr double top = 84.0;
constexpr double across = 56.0;  // from a panel to the next
constexpr double down = 34.0;
constexpr double legend_line = 20.0;
constexpr double title_size = 16.0;
constexpr double versions_room = 46.0;  // of a name under a panel

/// Colours that are told apart by those who see fewer, too (Okabe and Ito 2008), on light and dark.
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#e69f00", "#56b4e9", "#8a8a8a", "#a6761d"};

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
  explicit Sheet(const Trend& trend) {
    for (const TrendReport& report : trend.reports) {
      versions.push_back(printable(report.name));
    }
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
    return left + static_cast<double>(column) * (panel_width + across) + panel_width * part;
  }
  [[nodiscard]] const char* colour(const std::string& model) const {
    const auto place = std::find(models.begin(), models.end(), model) - models.begin();
    return colours[static_cast<std::size_t>(place) % colours.size()];
  }

  std::vector<std::string> versions;
  std::vector<double> steps;  // the longest first
  std::vector<std::string> models;
};

std::string frame(const Sheet& sheet, std::size_t column, double y, const Decades& decades) {
  const double start = left + static_cast<double>(column) * (panel_width + across);
  std::string out;
  const int every = std::max(1, (decades.high - decades.low) / 5);
  for (int power = decades.low; power <= decades.high; power += every) {
    const double at = y + decades.height_of(std::pow(10.0, power));
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}h{2:.1f}\"/><text class=\"muted\" "
        "text-anchor=\"end\" x=\"{3:.1f}\" y=\"{4:.1f}\">1e{5}</text>\n",
        start, at, panel_width, start - 6.0, at + 4.0, power);
  }
  for (std::size_t index = 0; index < sheet.versions.size(); ++index) {
    const double at = sheet.x(column, index);
    out += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}v{2:.1f}\"/><text class=\"muted\" "
        "text-anchor=\"end\" transform=\"translate({0:.1f} {3:.1f}) rotate(-40)\">{4}</text>\n",
        at, y, panel_height, y + panel_height + 14.0, xml_text(sheet.versions[index]));
  }
  return out + fmt::format(
                   "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
                   "height=\"{:.1f}\"/>\n",
                   start, y, panel_width, panel_height);
}

/// A line for each model, interrupted where a version has no such run.
std::string curves(const Sheet& sheet, std::size_t column, double y, const Quantity& quantity,
                   const Decades& decades) {
  std::string out;
  for (const auto& [key, points] : quantity.lines) {
    if (key.step != sheet.steps[column]) {  // both are the same number of a report
      continue;
    }
    const char* const colour = sheet.colour(key.model);
    std::string line;
    std::string dots;
    bool joined = false;
    for (std::size_t index = 0; index < points.size(); ++index) {
      if (!points[index]) {
        joined = false;
        continue;
      }
      const double at = y + decades.height_of(*points[index]);
      line += fmt::format("{}{:.1f} {:.1f}", joined ? 'L' : 'M', sheet.x(column, index), at);
      dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>",
                          sheet.x(column, index), at, colour);
      joined = true;
    }
    out += fmt::format("<path d=\"{0}\" fill=\"none\" stroke=\"{1}\" stroke-width=\"1.6\"/>{2}\n",
                       line, colour, dots);
  }
  return out;
}

std::string legend(const Sheet& sheet, double y) {
  std::string out;
  for (const std::string& model : sheet.models) {
    out += fmt::format(
        "<path d=\"M{0} {1:.1f}h24\" stroke=\"{2}\" stroke-width=\"3\"/><text x=\"{3}\" "
        "y=\"{4:.1f}\">{5}</text>\n",
        left, y, sheet.colour(model), left + 32.0, y + 4.0, xml_text(printable(model)));
    y += legend_line;
  }
  return out;
}

}  // namespace

std::string version_svg(const VersionTrend& versions) {
  const Sheet sheet(*versions.trend);
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
    panels += fmt::format(
        "<text class=\"muted\" text-anchor=\"end\" x=\"{:.1f}\" y=\"{:.1f}\">step {:g} s</text>\n",
        left + static_cast<double>(column) * (panel_width + across) + panel_width, top - 8.0,
        sheet.steps[column]);
  }
  const double columns = static_cast<double>(std::max<std::size_t>(1, sheet.steps.size()));
  const double width = std::max(left + columns * (panel_width + across),
                                left + room_for(version_title(versions), title_size));
  const double height = y + legend_line * static_cast<double>(sheet.models.size());
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n<desc>Error "
             "and cost over versions, medians over the cases; 0 lies on the lowest "
             "line.</desc>\n{3}<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n<text "
             "class=\"title\" x=\"{4}\" y=\"26\">{2}</text>\n<text class=\"muted\" x=\"{4}\" "
             "y=\"47\">medians over the cases; 0 lies on the lowest line</text>\n",
             width, height, xml_text(version_title(versions)), plot_style, left) +
         panels + legend(sheet, y - 20.0) + "</svg>\n";
}

}  // namespace tautline::bench
