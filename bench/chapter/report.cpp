#include "bench/chapter/report.hpp"

#include <fmt/format.h>

#include <sstream>

#include "bench/base/table.hpp"
#include "bench/chapter/checks.hpp"
#include "bench/chapter/tables.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The headings of a CSV file, one by one; none of them holds a comma.
std::vector<std::string> csv_columns(const std::string& csv) {
  std::istringstream line(csv.substr(0, csv.find('\n')));
  std::vector<std::string> result;
  for (std::string field; std::getline(line, field, ',');) {
    result.push_back(field);
  }
  return result;
}

ordered_json figure_json(const ChapterFigure& figure) {
  ordered_json result = {{"name", figure.number},
                         {"title", figure.title},
                         {"file", figure.file},
                         {"columns", csv_columns(figure.csv)},
                         {"x", figure.x},
                         {"y", figure.y},
                         {"cases", ordered_json::array({figure.case_number})},
                         {"marks", figure.marks},
                         {"chapter", figure.chapter},
                         {"truth", figure.truth}};
  if (!figure.boundary_file.empty()) {
    result["boundary"] = {{"file", figure.boundary_file},
                          {"columns", csv_columns(figure.boundary_csv)}};
  }
  return result;
}

ordered_json correction_json(const Correction& correction) {
  return {{"where", correction.where},     {"holds", correction.holds},
          {"chapter", correction.chapter}, {"right", correction.right},
          {"shown", correction.shown},     {"numbers", correction.numbers}};
}

std::string tables_section(const ChapterReport& report) {
  std::string out;
  for (const ChapterTable& table : report.tables) {
    out += fmt::format("\n## {}\n\n{} Data: [{}](chapter/{}).\n\n{}\n", table.name, table.title,
                       table.file, table.file, table_markdown(table));
    for (const std::string& note : table.notes) {
      out += "- " + note + "\n";
    }
  }
  return out;
}

std::string figures_section(const ChapterReport& report) {
  std::string out =
      "\n## Figures 5.6 to 5.20\n\nFigures 5.1 to 5.5 are drawings of the geometry: there is "
      "nothing "
      "to compute in them.\n\n";
  Table files({"figure", "plots", "data", "boundaries"}, 4);
  for (const ChapterFigure& figure : report.figures) {
    files.add({figure.number, figure.title, figure.file,
               figure.boundary_file.empty() ? "–" : figure.boundary_file});
  }
  out += files.markdown();
  out += fmt::format(
      "\nThe data are in the folder `chapter`: the whole state each {:g} time units, and two rows "
      "at "
      "each event, before and after it. Of the impacts there is one row each, with both "
      "velocities. "
      "Boundaries are those of the centre of mass at angle 0; with the angle they move, and the "
      "chapter draws none for a body with dimensions.\n",
      figure_step);
  std::string_view said;
  for (const ChapterFigure& figure : report.figures) {
    if (figure.chapter != said) {
      out += "\n" + figure.chapter + " In truth:\n\n";
      said = figure.chapter;
    }
    out += fmt::format("- Fig. {}, case {}. {}\n", figure.number, figure.case_number, figure.truth);
  }
  return out;
}

std::string corrections_section(const ChapterReport& report, bool holds) {
  std::string out;
  int count = 0;
  for (const Correction& one : report.corrections) {
    if (one.holds == holds) {
      out += fmt::format("{}. **{}.** {}\n   - {}: {}\n   - Shown: {}\n", ++count, one.where,
                         one.chapter, holds ? "Checked" : "Right", one.right, one.shown);
    }
  }
  return out;
}

}  // namespace

ChapterReport chapter_report(const ChapterStudy& study) {
  return {chapter_tables(study), chapter_figures(study), chapter_corrections(study)};
}

ordered_json chapter_json(const ChapterReport& report) {
  ordered_json result = {{"schema", chapter_schema},
                         {"options",
                          {{"digits", chapter_digits},
                           {"law", "simultaneous"},
                           {"counted_speed", counted_speed},
                           {"figure_step", figure_step},
                           {"seed", chapter_seed}}}};
  for (const char* list : {"tables", "figures", "corrections"}) {
    result[list] = ordered_json::array();
  }
  for (const ChapterTable& table : report.tables) {
    result["tables"].push_back(table_json(table));
  }
  for (const ChapterFigure& figure : report.figures) {
    result["figures"].push_back(figure_json(figure));
  }
  for (const Correction& correction : report.corrections) {
    result["corrections"].push_back(correction_json(correction));
  }
  return result;
}

std::string chapter_markdown(const ChapterReport& report) {
  std::string out = fmt::format(
      "# The source chapter, computed again\n\n"
      "Chapter 5, *Free Motions of a Rigid-Body Breakwater*, solved case by case with a fixed time "
      "step of 0.01 and impacts located to 1e-6. Here are its tables and the data of its figures "
      "from the exact motion, and what the exact motion says of its claims.\n\n"
      "- Lengths are in S, half the distance of the anchors; times in sqrt(S/g), speeds in "
      "sqrt(gS), "
      "energies in mgS from the equilibrium, angles in radians. g1 = 0 is the right cable (cable "
      "1), "
      "g2 = 0 the left (cable 0).\n"
      "- The motions are solved in {} decimal digits, as a neighbouring start may end elsewhere. "
      "Impacts on several cables follow the simultaneous law.\n"
      "- Everything below is computed by `tautline reproduce`; only the chapter's own digits are "
      "copied.\n",
      chapter_digits);
  out += tables_section(report);
  out += figures_section(report);
  out += "\n## What the chapter got wrong\n\n" + corrections_section(report, false);
  out += "\n## What was checked and holds\n\n" + corrections_section(report, true);
  return out;
}

std::string corrections_csv(const std::vector<Correction>& corrections) {
  std::string csv = "where,holds,chapter,right,shown\n";
  for (const Correction& one : corrections) {
    csv += fmt::format("{},{},{},{},{}\n", csv_field(one.where), one.holds ? "yes" : "no",
                       csv_field(one.chapter), csv_field(one.right), csv_field(one.shown));
  }
  return csv;
}

}  // namespace tautline::bench
