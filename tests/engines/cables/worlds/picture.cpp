// Draws docs/guides/cables.svg: a load dropped into the slack of a drop-in cable, in fixed steps
// and by events, over the closed form. Takes the file to write.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

constexpr double restitution = 0.7;
constexpr double drop = 1.0;      // [m] above the end of the cable
constexpr double duration = 2.7;  // [s]

struct Sample {
  double time;    // [s]
  double height;  // above where the cable is taut [m]
};
using Samples = std::vector<Sample>;

/// Where the drop-in cable has the load after each step.
Samples played(bool by_events) {
  const double taut = 3.0;  // [m]
  Scene scene(gravity);
  scene.add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, taut + drop, 0), Vec3::Zero());
  scene.add_cable(
      {{0, Vec3::Zero()}, {-1, Vec3(0, taut + cable_length, 0)}, cable_length, restitution});
  Samples samples{{0.0, drop}};
  for (int step = 1; step * scene.dt() <= duration; ++step) {
    by_events ? static_cast<void>(scene.step_by_events()) : scene.step();
    samples.push_back({step * scene.dt(), scene.body(0).position.y() - taut});
  }
  return samples;
}

/// The top of the first rebound [m], by the parabola through the three highest samples.
double rebound_of(const Samples& samples) {
  std::size_t at = 1;
  while (samples[at].height < samples[at - 1].height) {
    ++at;  // falling
  }
  while (samples[at + 1].height > samples[at].height) {
    ++at;
  }
  const double before = samples[at - 1].height;
  const double after = samples[at + 1].height;
  const double bend = 2.0 * samples[at].height - before - after;
  return samples[at].height + 0.125 * (after - before) * (after - before) / bend;
}

/// A part of the sheet, and what it shows.
struct Panel {
  double left, top, wide, high;  // [px]
  double from, to;               // [s]
  double low, up;                // [m]

  [[nodiscard]] double x(double time) const { return left + wide * (time - from) / (to - from); }
  [[nodiscard]] double y(double height) const { return top + high * (up - height) / (up - low); }
};

/// A frame with its grid and numbers, `every_second` [s] and `every_metre` [m], of so many digits.
std::string frame(const Panel& panel, const std::string& title, double every_second,
                  double every_metre, int digits) {
  const double bottom = panel.top + panel.high;
  const double right = panel.left + panel.wide;
  std::string svg;
  const double rounding = 1e-9;
  const auto first = [rounding](double from, double every) {
    return static_cast<int>(std::ceil(from / every - rounding));
  };
  for (int line = first(panel.from, every_second); line * every_second <= panel.to + rounding;
       ++line) {
    const double x = panel.x(line * every_second);
    svg +=
        fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>\n", x, panel.top, bottom);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.{}f}</text>\n", x,
                       bottom + 16.0, line * every_second, digits);
  }
  for (int line = first(panel.low, every_metre); line * every_metre <= panel.up + rounding;
       ++line) {
    const double y = panel.y(line * every_metre);
    svg += fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n",
                       line == 0 ? "taut" : "grid", panel.left, y, right);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}{:.{}f}</text>\n",
                       panel.left - 6.0, y + 4.0, line < 0 ? "\u2212" : "",
                       std::abs(line * every_metre), digits);
  }
  svg += fmt::format(
      "<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
      panel.left, panel.top, panel.wide, panel.high);
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">time [s]</text>\n",
                     panel.left + 0.5 * panel.wide, bottom + 34.0);
  return svg + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", right,
                           panel.top - 8.0, title);
}

/// The closed form: parabolas, each e times as long as the one before.
std::string exact(const Panel& panel) {
  double speed = std::sqrt(2.0 * gravity * drop);
  double impact = speed / gravity;
  // a parabola is a quadratic Bezier curve with its tangents' crossing in the middle of its time
  std::string path =
      fmt::format("M{:.2f} {:.2f}Q{:.2f} {:.2f} {:.2f} {:.2f}", panel.x(0), panel.y(drop),
                  panel.x(0.5 * impact), panel.y(drop), panel.x(impact), panel.y(0));
  const double unseen = 0.01;  // [m/s]: the impacts accumulate
  while (restitution * speed > unseen) {
    speed *= restitution;
    const double flight = 2.0 * speed / gravity;
    path += fmt::format("Q{:.2f} {:.2f} {:.2f} {:.2f}", panel.x(impact + 0.5 * flight),
                        panel.y(0.5 * flight * speed), panel.x(impact + flight), panel.y(0));
    impact += flight;
  }
  return fmt::format("<path class=\"exact\" d=\"{}H{:.2f}\"/>\n", path, panel.x(duration));
}

std::string line(const Panel& panel, const Samples& samples, const std::string& kind) {
  std::string path;
  for (const Sample& sample : samples) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", panel.x(sample.time),
                        panel.y(sample.height));
  }
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, path);
}

std::string marks(const Panel& panel, const Samples& samples, const std::string& kind,
                  double radius) {
  std::string svg = fmt::format("<g class=\"{}\">\n", kind);
  for (const Sample& sample : samples) {
    if (sample.time >= panel.from && sample.time <= panel.to) {
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n",
                         panel.x(sample.time), panel.y(sample.height), radius);
    }
  }
  return svg + "</g>\n";
}

std::string curves(const Panel& panel, const Samples& fixed, const Samples& by_events,
                   const std::string& name, double radius) {
  return fmt::format(
             "<clipPath id=\"{}\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
             "height=\"{:.1f}\"/></clipPath>\n<g clip-path=\"url(#{})\">\n",
             name, panel.left, panel.top, panel.wide, panel.high, name) +
         exact(panel) + line(panel, fixed, "steps") + marks(panel, fixed, "fixed", radius) +
         marks(panel, by_events, "events", radius + 1.2) + "</g>\n";
}

std::string picture() {
  const Samples fixed = played(false);
  const Samples by_events = played(true);
  const Panel whole{60.0, 92.0, 500.0, 272.0, 0.0, duration, -0.1, 1.1};
  const Panel impact{640.0, 92.0, 200.0, 272.0, 0.395, 0.535, -0.06, 0.21};
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 860 412\" width=\"860\" "
      "height=\"412\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#333\">\n"
      "<style>.frame{fill:none;stroke:#888}.grid{stroke:#e6e6e6}.taut{stroke:#333;stroke-dasharray:"
      "5 3}"
      ".exact{fill:none;stroke:#bbb;stroke-width:4;stroke-linejoin:bevel}.steps{fill:none;stroke:#"
      "c8501e}"
      ".fixed{fill:#c8501e}.events{fill:none;stroke:#1660a8;stroke-width:1.2}"
      ".title{font-size:15px;font-weight:bold}</style>\n"
      "<rect width=\"860\" height=\"412\" fill=\"#fff\"/>\n";
  svg += fmt::format(
      "<text class=\"title\" x=\"60\" y=\"24\">A load falls {:g} m until its cable goes taut. "
      "Restitution {:g}, {:g} steps a second</text>\n",
      drop, restitution, 1.0 / Scene::step_length);
  // the legend, with what the first rebound should reach
  const auto entry = [](double x, const std::string& symbol, const std::string& words) {
    return fmt::format(
        "<g transform=\"translate({:.1f} 50)\">{}<text x=\"26\" y=\"4\">{}</text></g>\n", x, symbol,
        words);
  };
  svg += entry(60.0, "<path class=\"exact\" d=\"M0 0H20\"/>",
               fmt::format("closed form, rebounds to {:.3f} m", restitution * restitution * drop));
  svg += entry(
      320.0,
      "<path class=\"steps\" d=\"M0 0H20\"/><g class=\"fixed\"><circle cx=\"10\" r=\"2.6\"/></g>",
      fmt::format("stepSimulation, to {:.3f} m", rebound_of(fixed)));
  svg += entry(570.0, "<g class=\"events\"><circle cx=\"10\" r=\"3.8\"/></g>",
               fmt::format("btStepWithCables, to {:.3f} m", rebound_of(by_events)));
  svg += frame(whole, "height after every step", 0.5, 0.2, 1);
  svg += curves(whole, fixed, by_events, "whole", 1.3);
  svg += frame(impact, "the first impact", 0.05, 0.05, 2);
  svg += curves(impact, fixed, by_events, "impact", 2.6);
  svg += fmt::format(
      "<text x=\"18\" y=\"{0:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 18 "
      "{0:.1f})\">height above where the cable is taut [m]</text>\n",
      whole.top + 0.5 * whole.high);
  return svg + "</svg>\n";
}

void write(const std::string& file) {
  std::ofstream out(file);
  out << picture();
  out.close();
  if (!out) {
    throw std::runtime_error("cannot write " + file);
  }
}

}  // namespace
}  // namespace tautline::test

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "expected one file to write, got %d arguments\n", argc - 1);
    return 2;
  }
  try {
    tautline::test::write(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
