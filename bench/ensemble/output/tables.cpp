#include "bench/ensemble/output/output.hpp"

#include <string>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

Column words_column(const std::string& heading) {
  Column column;
  column.heading = heading;
  column.numbers = false;
  return column;
}

/// A column of numbers; of those with a rank above 0 the highest goes first where room is short.
Column numbers(const std::string& heading, int rank = 0) {
  Column column;
  column.heading = heading;
  column.rank = rank;
  return column;
}

/// As many digits for a spread or a shift as for the values themselves.
Digits digits_between(const Statistic& statistic) {
  return statistic.digits.kind == Digits::Kind::shortest ? fixed(1) : statistic.digits;
}

Cell share_cell(double value) { return number_cell(value, fixed(3)); }

/// "0.05", or "< 0.0001" where so few digits would show 0.
Cell probability_cell(double value) {
  constexpr double least = 1e-4;
  Cell cell = number_cell(value, fixed(4));
  if (value < least) {
    cell.text = "< 0.0001";
  }
  return cell;
}

Cell verdict_cell(const Comparison& one, bool brief) {
  Cell cell(one.differs()         ? "differs"
            : !one.says_nothing() ? "not told apart"
            : brief               ? "n too small"
                                  : too_small_words(one));
  cell.kind = one.differs()        ? "verdict differs"
              : one.says_nothing() ? "verdict too-few-to-tell"
                                   : "verdict sound";
  cell.colour = one.differs() ? Colour::red : Colour::plain;
  return cell;
}

}  // namespace

Table summary_table(const EnsembleReport& report) {
  Table table({words_column("statistic"), words_column("setup"), numbers("n"), numbers("none", 3),
               numbers("median"), numbers("low"), numbers("high"), numbers("5 %", 2),
               numbers("95 %", 2), numbers("mean", 1), numbers("deviation", 1)});
  const Findings& findings = report.findings;
  for (std::size_t place = 0; place < findings.statistics.size(); ++place) {
    const Statistic& statistic = findings.statistics[place];
    if (common_value(report, place)) {
      continue;  // a sentence says so
    }
    bool is_first = true;
    for (std::size_t setup = 0; setup < report.request.setups.size(); ++setup) {
      const Summary& summary = findings.summaries[setup][place];
      if (!tells(report.request.setups[setup], statistic, summary)) {
        continue;
      }
      const auto some = [&](double value) {
        return number_cell(summary.count > 0 ? std::optional(value) : std::nullopt,
                           digits_between(statistic));
      };
      const Quantile& median = summary.quantiles[median_place];
      table.add({is_first ? Cell(statistic_title(statistic)) : Cell(""),
                 printable(report.request.setups[setup].name),
                 number_cell(static_cast<double>(summary.count), as_count),
                 number_cell(static_cast<double>(summary.without), as_count),
                 number_cell(median.value, statistic.digits),
                 number_cell(median.low, statistic.digits),
                 number_cell(median.high, statistic.digits),
                 number_cell(summary.quantiles.front().value, statistic.digits),
                 number_cell(summary.quantiles.back().value, statistic.digits), some(summary.mean),
                 some(summary.deviation)});
      is_first = false;
    }
  }
  return table;
}

Table comparison_table(const EnsembleReport& report, bool brief) {
  Table table({words_column("setup"), words_column("statistic"), numbers("D"), numbers("E"),
               numbers("p"), numbers("median change", 1), numbers("visible", 2),
               numbers("shift", 3), words_column("verdict")});
  const Findings& findings = report.findings;
  std::size_t last = 0;
  for (const Comparison& one : findings.comparisons) {
    const Statistic& statistic = findings.statistics[one.statistic];
    const Cell verdict = verdict_cell(one, brief);
    table.add(
        {one.setup != last ? Cell(printable(report.request.setups[one.setup].name)) : Cell(""),
         statistic_title(statistic), share_cell(one.kolmogorov.effect),
         number_cell(one.energy ? std::optional(one.energy->effect) : std::nullopt, fixed(3)),
         probability_cell(one.probability()),
         number_cell(one.median_change, digits_between(statistic)), share_cell(one.visible),
         number_cell(one.visible_shift, digits_between(statistic)), verdict});
    last = one.setup;
  }
  return table;
}

std::string ensemble_text(const EnsembleReport& report, const TerminalStyle& style) {
  std::string out = wrapped(ensemble_title(report), style.text) + "\n" +
                    summary_table(report).plain(style) + "\n";
  const Table comparisons = comparison_table(report, true);
  if (!comparisons.empty()) {
    out += comparisons.plain(style) + "\n";
  }
  for (const std::string& sentence : ensemble_sentences(report)) {
    out += wrapped(sentence, style.text);
  }
  return out;
}

}  // namespace tautline::bench
