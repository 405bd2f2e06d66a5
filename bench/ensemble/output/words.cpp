#include "bench/ensemble/output/words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// Of a setup, its comparisons.
std::vector<const Comparison*> comparisons_of(const Findings& findings, std::size_t setup) {
  std::vector<const Comparison*> result;
  for (const Comparison& one : findings.comparisons) {
    if (one.setup == setup) {
      result.push_back(&one);
    }
  }
  return result;
}

/// "0.08 (a shift of 0.05 s)".
std::string visible_words(const Comparison& one, const Statistic& statistic) {
  std::string words = fmt::format("{:.2g}", one.visible);
  if (one.visible_shift) {
    words += fmt::format(", as a shift of {:.2g}{}{} would make", *one.visible_shift,
                         statistic.unit.empty() ? "" : " ", statistic.unit);
  }
  return words;
}

std::string verdict_on(const EnsembleReport& report, std::size_t setup) {
  const Findings& findings = report.findings;
  const std::string name = printable(report.request.setups[setup].name);
  const std::vector<const Comparison*> all = comparisons_of(findings, setup);
  if (all.empty()) {
    return fmt::format("{}: too few draws to be compared; {} are needed.", name, least_sample);
  }
  std::vector<const Comparison*> different;
  std::copy_if(all.begin(), all.end(), std::back_inserter(different),
               [](const Comparison* one) { return one->differs(); });
  if (different.empty()) {
    const Comparison& first = *all.front();
    const Statistic& statistic = findings.statistics[first.statistic];
    return fmt::format(
        "{} cannot be told apart from exact in any of {} statistics at n = {}. The smallest "
        "difference that could be seen is D = {}, in {}.",
        name, all.size(), first.draws, visible_words(first, statistic), statistic.heading);
  }
  std::stable_sort(different.begin(), different.end(),
                   [](const Comparison* one, const Comparison* other) {
                     return one->kolmogorov.effect > other->kolmogorov.effect;
                   });
  const std::vector<std::string> words = listed(different, [&](const Comparison* one) {
    return fmt::format("{} (D = {:.2f})", findings.statistics[one->statistic].heading,
                       one->kolmogorov.effect);
  });
  return fmt::format("{} differs from exact in {} of {} statistics: {}.", name, different.size(),
                     all.size(), joined(words, "and"));
}

/// "The same in all draws: captured (1) and first cable (0)."; empty where nothing is.
std::string constant_words(const EnsembleReport& report) {
  std::vector<std::string> words;
  for (std::size_t place = 0; place < report.findings.statistics.size(); ++place) {
    const Summary& summary = report.findings.summaries.front()[place];
    if (is_constant(report, place) && summary.count > 0) {
      words.push_back(
          fmt::format("{} ({:g})", report.findings.statistics[place].heading, summary.mean));
    }
  }
  return words.empty() ? "" : "The same in all draws: " + joined(words, "and") + ".";
}

}  // namespace

bool is_constant(const EnsembleReport& report, std::size_t statistic) {
  std::optional<double> value;
  for (const DrawTable& draws : report.result.draws) {
    if (!draws.holds_all() && draws.counts(statistic).values().size() > 1) {
      return false;
    }
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
      const std::optional<double> one = draws.value(draw, statistic);
      value = value ? value : one;
      if (one && *one != *value) {  // exactly: the same number
        return false;
      }
    }
  }
  return true;
}

std::string statistic_title(const Statistic& statistic) {
  return statistic.heading + (statistic.unit.empty() ? "" : " [" + statistic.unit + "]");
}

std::string ensemble_title(const EnsembleReport& report) {
  const EnsembleSpec& spec = report.request.spec;
  const std::size_t points = grid_points(spec);
  return fmt::format("{} to {:g} s, {} draws{}, seed {}", printable(spec.the_case.name),
                     spec.the_case.duration, draw_count(spec),
                     points > 1 ? fmt::format(" ({} points of a grid)", points) : "", spec.seed);
}

std::vector<std::string> ensemble_sentences(const EnsembleReport& report) {
  std::vector<std::string> sentences;
  const std::vector<EnsembleSetup>& setups = report.request.setups;
  for (std::size_t setup = 1; setup < setups.size(); ++setup) {
    sentences.push_back(verdict_on(report, setup));
  }
  for (std::size_t setup = 0; setup < setups.size(); ++setup) {
    if (const std::size_t count = report.findings.problems[setup]; count > 0) {
      sentences.push_back(fmt::format("{}: {} of {} draws have no values, the first one as: {}.",
                                      printable(setups[setup].name), count,
                                      report.result.draws[setup].ended(),
                                      printable(report.findings.first_problems[setup])));
    }
  }
  if (std::string constant = constant_words(report); !constant.empty()) {
    sentences.push_back(std::move(constant));
  }
  if (const DrawTable& draws = report.result.draws.front(); !draws.holds_all()) {
    sentences.push_back(
        fmt::format("Tests and curves are of the first {} draws, the numbers of each distribution "
                    "of all, rounded to {} binary digits.",
                    draws.size(), counted_digits));
  }
  if (report.result.interrupted) {
    sentences.emplace_back("Interrupted: these are the draws that are finished.");
  }
  return sentences;
}

}  // namespace tautline::bench
