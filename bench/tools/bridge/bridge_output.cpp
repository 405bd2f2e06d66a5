#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/base/document.hpp"
#include "bench/base/html.hpp"
#include "bench/base/text.hpp"
#include "bench/data/describer.hpp"
#include "bench/page/document.hpp"
#include "bench/plot/svg.hpp"
#include "bench/tools/bridge/bridge.hpp"

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, BridgeCable& cable) {
  visit("restitution", cable.restitution, in_range(0, 1, "of the inextensible cable"));
  visit("damping_ratio", cable.damping_ratio, at_least(0, "of the elastic one"));
}

template <class Visitor>
void fields(Visitor& visit, BridgeImpact& impact) {
  visit("time", impact.time, at_least(0, "in the inextensible motion"));
  visit("cable", impact.cable, "the only one that takes part");
}

template <class Visitor>
void fields(Visitor& visit, BridgeContact& contact) {
  visit("shift", contact.shift, "by how much its entry is later than the impact");
  visit("restitution_error", contact.restitution_error,
        "its exit speed over its entry speed, less the restitution");
}

template <class Visitor>
void fields(Visitor& visit, BridgeRow& row) {
  visit("stiffness", row.stiffness, above(0, "of every cable, in N/m"));
  visit("deviation", row.deviation, at_least(0, "the largest of all centres of mass"));
  visit("shift", row.shift, at_least(0, "the largest of all contacts"));
  visit("restitution_error", row.restitution_error, at_least(0, "the largest of all contacts"));
  visit("contacts", row.contacts, Says("one for each impact").not_empty());
}

template <class Visitor>
void fields(Visitor& visit, Bridge& bridge) {
  schema_field(visit, 1);
  visit("case", printable(bridge.name));
  visit("cables", bridge.cables);
  visit("impacts", bridge.impacts, Says("those that are compared").not_empty());
  visit("until", bridge.until, above(0, "the deviations are those up to here"));
  visit("why_no_more", bridge.why,
        "a sentence: why no more impacts are compared; empty: no more were asked for, or "
        "there are none");
  visit("rows", bridge.rows, Says("by rising stiffness").not_empty());
  visit.group("slopes",
              "exponents of the stiffness, by least squares; null where a difference is 0, and of "
              "the shift of a single impact",
              [&](auto& inside) {
                inside("deviation", bridge.deviation_slope);
                inside("shift", bridge.shift_slope);
              });
}

namespace {

/// The exponent from one row to the next; "" of the first, and where one of both is 0.
std::string exponent_text(const std::vector<BridgeRow>& rows, std::size_t index,
                          double BridgeRow::*member) {
  if (index == 0) {
    return "";
  }
  const BridgeRow& before = rows[index - 1];
  const BridgeRow& row = rows[index];
  const double exponent =
      std::log(row.*member / before.*member) / std::log(row.stiffness / before.stiffness);
  return std::isfinite(exponent) ? fmt::format("{:.3f}", exponent) : "";
}

/// "1e5", "2.5e4".
std::string stiffness_text(double stiffness) {
  const double power = std::floor(std::log10(stiffness));
  return fmt::format("{:.4g}e{:g}", stiffness / std::pow(10.0, power), power);
}

Table rows_table(const Bridge& bridge) {
  Table table({"k [N/m]", "deviation [m]", "exponent", "shift [s]", "exponent", "error of e"}, 0);
  for (std::size_t index = 0; index < bridge.rows.size(); ++index) {
    const BridgeRow& row = bridge.rows[index];
    table.add({stiffness_text(row.stiffness), number_cell(row.deviation, as_error),
               exponent_text(bridge.rows, index, &BridgeRow::deviation),
               number_cell(row.shift, as_error),
               exponent_text(bridge.rows, index, &BridgeRow::shift),
               number_cell(row.restitution_error, as_error)});
  }
  return table;
}

/// A row for each impact, a column for each stiffness.
Table shifts_table(const Bridge& bridge) {
  std::vector<std::string> headings = {"impact", "cable", "at t [s]"};
  for (const BridgeRow& row : bridge.rows) {
    headings.push_back("k = " + stiffness_text(row.stiffness));
  }
  Table table(headings, 0);
  for (std::size_t index = 0; index < bridge.impacts.size(); ++index) {
    const BridgeImpact& impact = bridge.impacts[index];
    std::vector<Cell> cells = {number_cell(static_cast<double>(index + 1), as_count),
                               number_cell(static_cast<double>(impact.cable), as_count),
                               number_cell(impact.time, fixed(6))};
    for (const BridgeRow& row : bridge.rows) {
      cells.push_back(number_cell(row.contacts[index].shift, as_error));
    }
    table.add(std::move(cells));
  }
  return table;
}

/// "0.9 (a damping ratio of 0.0342652)" of all cables, or of each.
std::string cable_sentence(const Bridge& bridge) {
  const auto words = [](const BridgeCable& cable) {
    return fmt::format("restitution {:g} is a damping ratio of {:.6g}", cable.restitution,
                       cable.damping_ratio);
  };
  const BridgeCable& first = bridge.cables.front();
  const bool alike =
      std::all_of(bridge.cables.begin(), bridge.cables.end(),
                  [&](const BridgeCable& one) { return one.restitution == first.restitution; });
  if (alike) {
    return "Each cable is a spring of stiffness k; its " + words(first) + ".";
  }
  std::string result = "Each cable is a spring of stiffness k.";
  for (std::size_t index = 0; index < bridge.cables.size(); ++index) {
    result += fmt::format(" Of cable {} {}.", index, words(bridge.cables[index]));
  }
  return result;
}

std::string compared_sentence(const Bridge& bridge) {
  const std::size_t count = bridge.impacts.size();
  const std::string impacts =
      count == 1 ? "The first impact is" : fmt::format("The first {} impacts are", count);
  return fmt::format("{} compared, and the motion until t = {:.6g} s{}.", impacts, bridge.until,
                     bridge.why.empty() ? "" : ": " + bridge.why);
}

/// "The deviation falls with k^-0.500.", or why it has no exponent.
std::string one_slope(const char* name, const std::optional<double>& slope) {
  return slope ? fmt::format("The {} falls with k^{:.3f}.", name, *slope)
               : fmt::format("The {} has no exponent: at a stiffness it is 0.", name);
}

/// A sentence for each slope, and one on what they are for large stiffnesses.
std::string slope_sentence(const Bridge& bridge) {
  std::string result = one_slope("deviation", bridge.deviation_slope) + " ";
  result += bridge.impacts.size() > 1
                ? one_slope("shift", bridge.shift_slope)
                : "The shift has no exponent: the first contact begins with its impact.";
  if (bridge.deviation_slope || bridge.shift_slope) {
    const char* const fall = !bridge.shift_slope      ? "the deviation falls"
                             : bridge.deviation_slope ? "both fall"
                                                      : "the shift falls";
    result += fmt::format(" For large k {} with k^{:g}.", fall, expected_slope);
  }
  const auto is_off = [](const std::optional<double>& slope) {
    return slope && std::abs(*slope - expected_slope) > slope_tolerance;
  };
  if (is_off(bridge.deviation_slope) || is_off(bridge.shift_slope)) {
    result +=
        " These stiffnesses are not all large enough for that: the exponents between the last ones "
        "are nearer to it, or the motion is so sensitive that only larger ones are.";
  }
  return result;
}

constexpr const char* how_to_read_rows =
    "k: stiffness of every cable. Deviation: the largest distance of a centre of mass from its "
    "place in the inextensible motion. Shift: the largest of the contacts below. Exponent: of k, "
    "from the "
    "row before. Error of e: the largest of exit speed over entry speed, less the restitution.";
constexpr const char* how_to_read_shifts =
    "By how many seconds each contact of an elastic cable begins later than the impact; below 0 it "
    "begins earlier.";

/// The numbers that fall with the stiffness, in a picture.
constexpr std::pair<const char*, double BridgeRow::*> falling[] = {
    {"deviation [m]", &BridgeRow::deviation},
    {"shift of contacts [s]", &BridgeRow::shift},
    {"error of the restitution [-]", &BridgeRow::restitution_error}};

/// Powers of ten along an axis of `length` [px].
class DecadeAxis {
 public:
  DecadeAxis(double least, double most, double length)
      : low(static_cast<int>(std::floor(std::log10(least)))),
        high(std::max(low + 1, static_cast<int>(std::ceil(std::log10(most))))),
        length_(length) {}
  [[nodiscard]] double at(double value) const {  // [px]
    return length_ * (std::log10(value) - low) / (high - low);
  }
  [[nodiscard]] double place(int power) const {  // [px]
    return length_ * (power - low) / (high - low);
  }

  const int low;
  const int high;

 private:
  double length_;
};

/// Deviation, shift and error of the restitution over the stiffness, on axes of powers of ten.
std::string bridge_svg(const Bridge& bridge) {
  constexpr double panel_top = 64.0;
  constexpr double panel_height = 300.0;
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const BridgeRow& row : bridge.rows) {
    for (const auto& [name, member] : falling) {
      least = row.*member > 0.0 ? std::min(least, row.*member) : least;
      most = std::max(most, row.*member);
    }
  }
  const DecadeAxis across(bridge.rows.front().stiffness, bridge.rows.back().stiffness, panel_width);
  const DecadeAxis up(most > 0.0 ? least : 0.1, most > 0.0 ? most : 1.0, panel_height);
  const double bottom = panel_top + panel_height;
  std::string drawn;
  for (int power = across.low; power <= across.high; ++power) {
    const double x = panel_left + across.place(power);
    drawn += grid_down(x, panel_top, panel_height) + "\n" +
             muted_text(x, bottom + 18.0, fmt::format("1e{}", power), "middle");
  }
  for (int power = up.low; power <= up.high; ++power) {
    drawn +=
        grid_across(panel_left, bottom - up.place(power), panel_width, fmt::format("1e{}", power));
  }
  drawn += rectangle(frame_look, panel_left, panel_top, panel_width, panel_height) + "\n" +
           muted_text(panel_left + panel_width / 2.0, bottom + 38.0, "stiffness k [N/m]", "middle");
  LegendRows legend(bottom + 46.0);
  std::size_t place = 0;
  for (const auto& [name, member] : falling) {
    const std::string look = line_look(place, place) + " stroke-width=\"1.8\"";
    ++place;
    std::string line;
    for (const BridgeRow& row : bridge.rows) {
      if (row.*member > 0.0) {
        add_point(line, panel_left + across.at(row.stiffness), bottom - up.at(row.*member));
      }
    }
    drawn += "<path d=\"" + line + "\" " + look + "/>\n";
    legend.add("<path d=\"M0 0h26\" " + look + "/>", name);
  }
  return svg_sheet({.width = panel_left + panel_width + 24.0,
                    .height = legend.bottom() + 20.0,
                    .left = panel_left,
                    .title = "Elastic cables against inextensible ones",
                    .description = "What is between both falls with the stiffness."},
                   drawn + legend.drawn());
}

std::string bridge_csv(const Bridge& bridge) {
  std::string csv =
      csv_line({"stiffness [N/m]", falling[0].first, falling[1].first, falling[2].first});
  for (const BridgeRow& row : bridge.rows) {
    csv += csv_line({shortest(row.stiffness), shortest(row.deviation), shortest(row.shift),
                     shortest(row.restitution_error)});
  }
  return csv;
}

Document document_of(const Bridge& bridge) {
  return Document()
      .paragraph(cable_sentence(bridge))
      .paragraph(markdown_text(compared_sentence(bridge)))
      .html(figure_html({"tautline-bridge", "Differences over the stiffness", bridge_svg(bridge),
                         bridge_csv(bridge)}))
      .table(rows_table(bridge), "bridge-rows", "What is between both motions, by stiffness.")
      .paragraph(how_to_read_rows, "note")
      .table(shifts_table(bridge), "bridge-shifts", "Shift of each contact [s], by stiffness.")
      .paragraph(how_to_read_shifts, "note")
      .paragraph(markdown_text(slope_sentence(bridge)), "answer");
}

std::string title_of(const Bridge& bridge) {
  return printable(bridge.name) + " on elastic cables, and on inextensible ones";
}

}  // namespace

std::string bridge_text(const Bridge& bridge, const TerminalStyle& style) {
  return wrapped(title_of(bridge), style.text) + "\n" + document_of(bridge).plain(style);
}

std::string bridge_html(const Bridge& bridge, const PageAssets& assets) {
  PageAssets style_alone;
  style_alone.style = assets.style;
  return html_document(
      {.title = title_of(bridge),
       .content = fmt::format("<header>\n<h1>{}</h1>\n</header>\n<main>\n{}</main>\n",
                              html_text(title_of(bridge)), document_of(bridge).html()),
       .command = "tautline bridge",
       .data_id = "bridge-data",
       .data = html_json(bridge_json(bridge)),
       .scripts = assets.figure_scripts},
      style_alone);
}

std::string bridge_json(const Bridge& bridge) { return text_of(json_of(bridge)); }

std::string bridge_schema_json() {
  return text_of(headed("What `tautline bridge --json` writes",
                        "How far the motion on elastic cables is from that on inextensible ones, "
                        "by the stiffness. Lengths in m, times in s.",
                        schema_of(Bridge())));
}

}  // namespace tautline::bench
