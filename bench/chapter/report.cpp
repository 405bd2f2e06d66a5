#include "bench/chapter/report.hpp"

#include <fmt/format.h>

#include "bench/chapter/corrections/corrections.hpp"
#include "bench/chapter/source.hpp"
#include "bench/chapter/tables/tables.hpp"

namespace tautline::bench {
namespace {

std::string introduction() {
  return fmt::format(
      "The source is {}. It solves its cases with a fixed time step of 0.01 and impacts located to "
      "1e-6. Here are its tables and the data of its figures from the exact motion, and what the "
      "exact motion says of its claims.",
      source_chapter);
}

std::vector<std::string> conventions() {
  return {
      "Lengths are in S, half the distance of the anchors; times in sqrt(S/g), speeds in sqrt(gS), "
      "energies in mgS from the equilibrium, angles in radians. g1 = 0 is the right cable (cable "
      "1), g2 = 0 the left (cable 0).",
      fmt::format("The motions are solved in {} decimal digits, as a neighbouring start may end "
                  "elsewhere. Impacts on several cables follow the simultaneous law.",
                  chapter_digits),
      "Everything here is computed by `tautline reproduce`; only the chapter's own digits are "
      "copied."};
}

}  // namespace

ChapterReport chapter_report(const ChapterStudy& study) {
  return {introduction(), conventions(), chapter_tables(study), chapter_figures(study),
          chapter_corrections(study)};
}

}  // namespace tautline::bench
