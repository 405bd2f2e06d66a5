#include "bench/chapter/output.hpp"

#include <fmt/format.h>

#include "bench/base/listed.hpp"
#include "bench/base/table.hpp"
#include "bench/chapter/source.hpp"

namespace tautline::bench {
namespace {

std::string table_markdown(const ChapterTable& table) {
  const std::vector<std::string> headings = listed(table.columns, &ChapterColumn::name);
  Table text(headings, table.left);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t index = 0; index < row.size(); ++index) {
      cells.push_back(cell_text(row[index], table.columns[index]));
    }
    text.add(cells);
  }
  return text.markdown();
}

std::string tables_markdown(const ChapterReport& report) {
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

std::string figures_markdown(const ChapterReport& report) {
  std::string out =
      "\n## Figures 5.6 to 5.20\n\nFigures 5.1 to 5.5 are drawings of the geometry: there is "
      "nothing to compute in them.\n\n";
  Table files({"figure", "plots", "data", "boundaries"}, 4);
  for (const ChapterFigure& figure : report.figures) {
    files.add(
        {figure.number, figure.title, figure.file, figure.boundary ? figure.boundary->file : "–"});
  }
  out += files.markdown();
  out += fmt::format(
      "\nThe data are in the folder `chapter`: the whole state each {:g} time units, and two rows "
      "at each event, before and after it. Of the impacts there is one row each, with both "
      "velocities. Boundaries are those of the centre of mass at angle 0; with the angle they "
      "move, and the "
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

std::string case_number_section() {
  std::string out = fmt::format(
      "\n## Case numbers\n\nA case number spells its case, digit by digit. That of the standard "
      "case:\n\n{}\n",
      case_number_table().markdown());
  for (const std::string& rule : case_number_rules()) {
    out += "- " + rule + "\n";
  }
  return out;
}

}  // namespace

std::string chapter_markdown(const ChapterReport& report) {
  std::string out = "# The source chapter, computed again\n\n" + report.introduction + "\n\n";
  for (const std::string& convention : report.conventions) {
    out += "- " + convention + "\n";
  }
  out += case_number_section();
  out += tables_markdown(report);
  out += figures_markdown(report);
  out += "\n## What the chapter got wrong\n\n" + corrections_section(report, false);
  out += "\n## What was checked and holds\n\n" + corrections_section(report, true);
  return out;
}

}  // namespace tautline::bench
