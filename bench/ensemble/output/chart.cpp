#include "bench/ensemble/output/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/page/document.hpp"
#include "bench/plot/svg.hpp"

namespace tautline::bench {
namespace {

// of the sheet [px]
constexpr double panel = 330.0;
constexpr double left_edge = 88.0;
constexpr double top_edge = 64.0;
constexpr double between = 112.0;
constexpr double under = 56.0;
constexpr double title_from_axis = 70.0;  // of an axis that goes up
constexpr double legend_line = 20.0;      // of the legend

/// Points of a curve: closer ones are not seen.
constexpr int curve_points = 200;

/// How the line of a setup looks, as attributes; grey is the exact motion's alone.
std::string look_of(std::size_t setup) {
  const std::size_t other = (setup - 1) % (line_colours.size() - 1);
  const std::size_t colour = setup == 0 ? grey_line : other < grey_line ? other : other + 1;
  return line_look(colour, setup) + " stroke-width=\"1.8\"";
}

/// The numbers that a panel shows, and where they lie.
struct Axis {
  double low;
  double high;
  [[nodiscard]] double part(double value) const { return (value - low) / (high - low); }
};

/// From the least to the largest of all samples but for one in a hundred at each end.
Axis axis_of(const std::vector<EnsembleSample>& samples) {
  Axis axis{INFINITY, -INFINITY};
  for (const EnsembleSample& sample : samples) {
    if (!sample.values.empty()) {
      axis.low = std::min(axis.low, nearest_value(sample.values, 0.01));
      axis.high = std::max(axis.high, nearest_value(sample.values, 0.99));
    }
  }
  if (!(axis.low < axis.high)) {  // one value, or none
    const double middle = std::isfinite(axis.low) ? axis.low : 0.0;
    return {middle - 0.5, middle + 0.5};
  }
  return axis;
}

/// A frame with round numbers on each axis, and what the axes show.
std::string frame_at(double x, const Axis& across, const Axis& up, const std::string& across_title,
                     const std::string& up_title) {
  const double bottom = top_edge + panel;
  std::string out;
  for (const double number : ticks(across.low, across.high - across.low)) {
    const double at = x + panel * across.part(number);
    out += grid_down(at, top_edge, panel) + "\n" +
           muted_text(at, bottom + 18.0, fmt::format("{:g}", number), "middle");
  }
  for (const double number : ticks(up.low, up.high - up.low)) {
    out += grid_across(x, bottom - panel * up.part(number), panel, fmt::format("{:g}", number));
  }
  return out + rectangle(frame_look, x, top_edge, panel, panel) + "\n" +
         muted_text(x + panel / 2.0, bottom + 40.0, across_title, "middle") +
         turned_text(x - title_from_axis, top_edge + panel / 2.0, -90, up_title, "middle");
}

/// A point of a panel at `x`, inside its frame.
std::string point(double x, double across, double up) {
  return fmt::format("{:.1f} {:.1f}", x + panel * std::clamp(across, 0.0, 1.0),
                     top_edge + panel * (1.0 - std::clamp(up, 0.0, 1.0)));
}

/// The share of all draws that is below each value.
std::string distribution_curve(const EnsembleSample& sample, const Axis& axis, std::size_t setup) {
  const double with =
      static_cast<double>(sample.values.size()) / static_cast<double>(sample.size());
  std::string path;
  for (int place = 0; place <= curve_points; ++place) {
    const double part = static_cast<double>(place) / curve_points;
    path += (place == 0 ? "M" : "L") +
            point(left_edge, axis.part(nearest_value(sample.values, part)), part * with);
  }
  return fmt::format("<path d=\"{}\" {}/>\n", path, look_of(setup));
}

std::string quantile_curve(const EnsembleSample& first, const EnsembleSample& sample,
                           const Axis& axis, std::size_t setup) {
  std::string path;
  for (int place = 1; place < 100; ++place) {
    const double part = place / 100.0;
    path += (place == 1 ? "M" : "L") + point(left_edge + panel + between,
                                             axis.part(nearest_value(first.values, part)),
                                             axis.part(nearest_value(sample.values, part)));
  }
  return fmt::format("<path d=\"{}\" {}/>\n", path, look_of(setup));
}

std::string legend_of(const std::vector<EnsembleSetup>& setups) {
  std::string out;
  double y = top_edge + panel + under + legend_line;
  for (std::size_t setup = 0; setup < setups.size(); ++setup) {
    out += legend_entry(left_edge, y - 4.0, look_of(setup), printable(setups[setup].name));
    y += legend_line;
  }
  return out;
}

}  // namespace

std::string distribution_svg(const EnsembleReport& report, std::size_t statistic) {
  const std::vector<EnsembleSetup>& setups = report.request.setups;
  const Statistic& shown = report.findings.statistics[statistic];
  const std::vector<EnsembleSample> samples = listed(
      report.result.draws, [&](const DrawTable& draws) { return sample_of(draws, statistic); });
  const Axis axis = axis_of(samples);
  const bool has_others =
      !samples[0].values.empty() &&
      std::any_of(samples.begin() + 1, samples.end(),
                  [](const EnsembleSample& sample) { return !sample.values.empty(); });
  const double right = left_edge + panel + between;
  const std::string title = statistic_title(shown);
  std::string curves;
  if (has_others) {
    curves = frame_at(right, axis, axis, "exact: " + title, "compared: " + title) +
             muted_text(right, top_edge - 10.0, "quantiles over those of exact", "start") +
             fmt::format("<path class=\"frame\" d=\"M{}L{}\"/>\n", point(right, 0, 0),
                         point(right, 1, 1));
  }
  for (std::size_t setup = 0; setup < samples.size(); ++setup) {
    if (!samples[setup].values.empty()) {
      curves += distribution_curve(samples[setup], axis, setup);
      if (setup > 0 && !samples[0].values.empty()) {
        curves += quantile_curve(samples[0], samples[setup], axis, setup);
      }
    }
  }
  const double width = (has_others ? right : left_edge) + panel + 24.0;
  const double height =
      top_edge + panel + under + legend_line * static_cast<double>(setups.size() + 1);
  return svg_sheet(
      {.width = width, .height = height, .left = left_edge, .title = title},
      muted_text(left_edge, top_edge - 10.0, "distribution functions", "start") +
          frame_at(left_edge, axis, {0.0, 1.0}, title, "share of the draws below [-]") + curves +
          legend_of(setups));
}

std::string distribution_csv(const EnsembleReport& report, std::size_t statistic) {
  const Statistic& shown = report.findings.statistics[statistic];
  std::string csv = csv_line({"setup", "share of the draws below", statistic_title(shown)});
  for (std::size_t setup = 0; setup < report.result.draws.size(); ++setup) {
    const EnsembleSample sample = sample_of(report.result.draws[setup], statistic);
    const double with =
        static_cast<double>(sample.values.size()) / static_cast<double>(sample.size());
    for (int place = 0; place <= curve_points && !sample.values.empty(); ++place) {
      const double part = static_cast<double>(place) / curve_points;
      csv += csv_line({printable(report.request.setups[setup].name),
                       fmt::format("{:.6g}", part * with),
                       fmt::format("{:.9g}", nearest_value(sample.values, part))});
    }
  }
  return csv;
}

}  // namespace tautline::bench
