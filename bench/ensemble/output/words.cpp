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
    return fmt::format("{}: too few draws with values to be compared; {} are needed.", name,
                       least_sample);
  }
  std::vector<const Comparison*> different;
  std::copy_if(all.begin(), all.end(), std::back_inserter(different),
               [](const Comparison* one) { return one->differs(); });
  if (different.empty()) {
    const Comparison& first = *all.front();
    const Statistic& statistic = findings.statistics[first.statistic];
    if (first.says_nothing()) {
      return fmt::format(
          "{} was compared with exact in {} statistics at n = {}. {}; more draws see smaller ones.",
          name, all.size(), first.draws, too_small_words(first, "This n is too small"));
    }
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

/// "46 of 96 draws have"; "1 of 96 draws has"; "1 of 1 draw has".
std::string part_of_draws(std::size_t part, std::size_t draws) {
  return fmt::format("{} of {} {} {}", part, draws, draws == 1 ? "draw" : "draws",
                     part == 1 ? "has" : "have");
}

/// Of the setups, in order, those with draws without values, and those whose motions have not
/// locked.
void add_incomplete(std::vector<std::string>& sentences, const EnsembleReport& report) {
  const Findings& findings = report.findings;
  const std::size_t lock = place_of_statistic(findings.statistics, "lock");
  for (std::size_t setup = 0; setup < report.request.setups.size(); ++setup) {
    const std::string name = printable(report.request.setups[setup].name);
    if (const std::size_t count = findings.problems[setup]; count > 0) {
      sentences.push_back(fmt::format("{}: {} no values, the first one as: {}.", name,
                                      part_of_draws(count, report.result.draws[setup].ended()),
                                      printable(findings.first_problems[setup])));
    }
    const Summary& locks = findings.summaries[setup][lock];
    if (tells(report.request.setups[setup], findings.statistics[lock], locks) &&
        locks.without > 0) {
      sentences.push_back(fmt::format(
          "{}: {} not locked by {:g} s: later impacts than the last ones until then may "
          "follow.",
          name, part_of_draws(locks.without, locks.count + locks.without),
          duration_of(report.request.spec.the_case)));
    }
  }
}

/// The engines that have none of the models asked for.
void add_left_out(std::vector<std::string>& sentences, const EnsembleRequest& request) {
  for (std::size_t place = 0; place < request.engines.size(); ++place) {
    const bool has_part =
        std::any_of(request.setups.begin(), request.setups.end(),
                    [&](const EnsembleSetup& one) { return one.engine == place; });
    const RegisteredEngine& engine = request.engines[place];
    if (!has_part && engine.info && !engine.info->models.empty()) {
      const auto names = listed<std::string>(
          engine.info->models, [](const Model& model) { return printable(model.name); });
      sentences.push_back(fmt::format("{} has no part: it has no model {}; it has {}.",
                                      printable(engine.name), joined(request.spec.models, "or"),
                                      joined(names, "and")));
    }
  }
}

/// "The same in all draws: captured (1) and first cable (0)."; empty where nothing is.
std::string constant_words(const EnsembleReport& report) {
  std::vector<std::string> words;
  for (std::size_t place = 0; place < report.findings.statistics.size(); ++place) {
    if (const std::optional<double> value = common_value(report, place)) {
      words.push_back(fmt::format("{} ({:g})", report.findings.statistics[place].heading, *value));
    }
  }
  return words.empty() ? "" : "The same in all draws: " + joined(words, "and") + ".";
}

}  // namespace

std::string too_small_words(const Comparison& one, std::string_view what) {
  return fmt::format("{}: differences below D = {:.2f} cannot be seen", what, one.visible);
}

std::optional<double> common_value(const EnsembleReport& report, std::size_t statistic) {
  const Findings& findings = report.findings;
  std::optional<double> value;
  for (std::size_t setup = 0; setup < report.request.setups.size(); ++setup) {
    if (!tells(report.request.setups[setup], findings.statistics[statistic],
               findings.summaries[setup][statistic])) {
      continue;
    }
    const DrawTable& draws = report.result.draws[setup];
    if (findings.summaries[setup][statistic].without > 0 ||
        (!draws.holds_all() && draws.counts(statistic).values().size() > 1)) {
      return std::nullopt;
    }
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
      const std::optional<double> one = draws.value(draw, statistic);
      value = value ? value : one;
      if (one && *one != *value) {  // exactly: the same number
        return std::nullopt;
      }
    }
  }
  return value;
}

std::string statistic_title(const Statistic& statistic) {
  return statistic.heading + (statistic.unit.empty() ? "" : " [" + statistic.unit + "]");
}

std::string ensemble_title(const EnsembleReport& report) {
  const EnsembleSpec& spec = report.request.spec;
  const std::size_t points = grid_points(spec);
  const std::size_t draws = draw_count(spec);
  return fmt::format("{} to {:g} s, {} {}{}, seed {}", printable(name_of(spec.the_case)),
                     duration_of(spec.the_case), draws, draws == 1 ? "draw" : "draws",
                     points > 1 ? fmt::format(" ({} points of a grid)", points) : "", spec.seed);
}

std::vector<std::string> ensemble_sentences(const EnsembleReport& report) {
  std::vector<std::string> sentences;
  if (report.result.goes_on) {
    sentences.emplace_back("Not all draws: these are the ones done when this was written.");
  } else if (report.result.interrupted) {
    sentences.emplace_back("Interrupted: these are the draws that are finished.");
  }
  for (std::size_t setup = 1; setup < report.request.setups.size(); ++setup) {
    sentences.push_back(verdict_on(report, setup));
  }
  add_incomplete(sentences, report);
  add_left_out(sentences, report.request);
  if (std::string constant = constant_words(report); !constant.empty()) {
    sentences.push_back(std::move(constant));
  }
  if (const DrawTable& draws = report.result.draws.front(); !draws.holds_all()) {
    sentences.push_back(
        fmt::format("Tests and curves are of the first {} draws, the numbers of each distribution "
                    "of all, rounded to {} binary digits.",
                    draws.size(), counted_digits));
  }
  return sentences;
}

}  // namespace tautline::bench
