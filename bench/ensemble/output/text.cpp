#include "bench/ensemble/output/output.hpp"

#include "bench/base/table.hpp"

namespace tautline::bench {

std::string ensemble_text(const EnsembleReport& report, const TerminalStyle& style) {
  std::string out = wrapped(ensemble_title(report), style.text) + "\n" +
                    summary_table(report).plain(style) + "\n";
  const Table comparisons = comparison_table(report);
  if (!comparisons.empty()) {
    out += comparisons.plain(style) + "\n";
  }
  for (const std::string& sentence : ensemble_sentences(report)) {
    out += wrapped(sentence, style.text);
  }
  return out;
}

std::string ensemble_markdown(const EnsembleReport& report) {
  std::string out = "# Ensemble\n\n" + markdown_text(ensemble_title(report)) + "\n\n";
  for (const std::string& sentence : ensemble_sentences(report)) {
    out += "- " + markdown_text(sentence) + "\n";
  }
  const Table comparisons = comparison_table(report);
  if (!comparisons.empty()) {
    out += "\n## Held against exact\n\n" + comparisons.markdown() + "\n" + how_to_read_comparisons +
           "\n";
  }
  return out + "\n## Distributions\n\n" + summary_table(report).markdown() + "\n" +
         how_to_read_summaries + "\n";
}

}  // namespace tautline::bench
