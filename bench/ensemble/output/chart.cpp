#include "bench/ensemble/output/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/solution/plot_style.hpp"

namespace tautline::bench {
namespace {

// of the sheet [px]
constexpr double panel = 330.0;
constexpr double left_edge = 64.0;
constexpr double top_edge = 64.0;
constexpr double between = 84.0;
constexpr double under = 46.0;
constexpr double legend_line = 20.0;  // of the legend

/// Points of a curve: closer ones are not seen.
constexpr int curve_points = 200;

/// Colours that are told apart by those who see fewer, too (Okabe and Ito 2008), on light and dark.
constexpr std::array setup_colours = {"#8a8a8a", "#0072b2", "#d55e00", "#009e73",
                                      "#cc79a7", "#e69f00", "#56b4e9", "#a6761d"};
constexpr std::array setup_dashes = {"none", "8 3", "2 3", "10 3 2 3", "5 5"};

/// How the line of a setup looks, as attributes.
std::string look(std::size_t setup) {
  // grey is the exact motion's alone
  const std::size_t colour = setup == 0 ? 0 : 1 + (setup - 1) % (setup_colours.size() - 1);
  return fmt::format(
      "stroke=\"{}\" stroke-dasharray=\"{}\" stroke-width=\"1.8\" "
      "style=\"fill:none\"",
      setup_colours[colour], setup_dashes[setup % setup_dashes.size()]);
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

std::string muted(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format(
      "<text class=\"muted\" text-anchor=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", anchor, x,
      y, xml_text(words));
}

/// A frame with both ends of each axis.
std::string frame_at(double x, const Axis& across, const Axis& up) {
  const double bottom = top_edge + panel;
  return fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                     x, top_edge, panel, panel) +
         muted(x, bottom + 16.0, "start", fmt::format("{:.4g}", across.low)) +
         muted(x + panel, bottom + 16.0, "end", fmt::format("{:.4g}", across.high)) +
         muted(x - 5.0, bottom, "end", fmt::format("{:.4g}", up.low)) +
         muted(x - 5.0, top_edge + 12.0, "end", fmt::format("{:.4g}", up.high));
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
  return fmt::format("<path d=\"{}\" {}/>\n", path, look(setup));
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
  return fmt::format("<path d=\"{}\" {}/>\n", path, look(setup));
}

std::string legend_of(const std::vector<EnsembleSetup>& setups) {
  std::string out;
  double y = top_edge + panel + under + legend_line;
  for (std::size_t setup = 0; setup < setups.size(); ++setup) {
    out += fmt::format("<path d=\"M{} {:.1f}h40\" {}/><text x=\"{}\" y=\"{:.1f}\">{}</text>\n",
                       left_edge, y - 4.0, look(setup), left_edge + 48.0, y,
                       xml_text(printable(setups[setup].name)));
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
  std::string curves;
  if (has_others) {
    curves = frame_at(right, axis, axis) +
             muted(right, top_edge - 10.0, "start", "quantiles over those of exact") +
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
  const std::string title = statistic_title(shown);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n{3}<rect "
             "class=\"paper\" width=\"100%\" height=\"100%\"/>\n<text class=\"title\" "
             "x=\"{4}\" y=\"26\">{2}</text>\n",
             width, height, xml_text(title), plot_style, left_edge) +
         muted(left_edge, top_edge - 10.0, "start", "share of the draws below") +
         frame_at(left_edge, axis, {0.0, 1.0}) + curves + legend_of(setups) + "</svg>\n";
}

}  // namespace tautline::bench
