#include "bench/report/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/judge/models.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/scorecard.hpp"
#include "bench/report/tables.hpp"
#include "bench/report/words.hpp"
#include "tautline_bench_report_words.inc"

namespace tautline::bench {
namespace {

/// What the headings of the answers mean, a line each.
std::string legend(const Report& report, std::size_t width) {
  std::string out;
  for (const Metric& metric : metric_list()) {
    if (is_asked_first(metric)) {
      const char* over = metric.aggregate == Aggregate::typical ? "median" : "worst";
      out += wrapped(fmt::format("{} ({}): {}", metric.brief, over, metric.meaning), width);
    }
  }
  out += wrapped(
      "match, of: Impacts of the run that have an exact match, of the exact ones, up to "
      "the horizon.",
      width);
  if (report.listed) {
    for (const Word word : all_words) {
      out += wrapped(fmt::format("{}: {}.", to_string(word), meaning_of(word)), width);
    }
  }
  return out;
}

std::string number_and_unit(double value, const Digits& digits, const std::string& unit) {
  return number_text(value, digits) + (unit.empty() ? "" : " " + unit);
}

/// Metrics with value and unit: those that matter, or all.
Table metrics_of(const RunRow& run, bool all) {
  Table table({word_column("against the exact motion", ""), number_column("value", "", "", ""),
               word_column("unit", "")});
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    const Metric& metric = metric_list()[place];
    if (all || is_asked_first(metric)) {
      table.add({in_words(metric.name), number_cell(run.metric(place), metric.digits),
                 shown_unit(metric)});
    }
  }
  return table;
}

/// What the run is judged by, a sentence each, and what is wrong with it.
std::string judgement_text(const RunRow& run, const TerminalStyle& style) {
  std::string out;
  if (run.judgement) {
    out += wrapped("Restitution: " + words_of(run.judgement->rebounds) + ".", style.text);
    out += wrapped("Followed: " + followed_text(run.judgement->following) + ".", style.text);
  }
  for (const Problem& problem : run.verdict ? run.verdict->problems : std::vector<Problem>()) {
    out += wrapped(fmt::format("Problem, {}: {}.{}", in_words(problem.kind),
                               printable(problem.sentence, longest_sentence),
                               problem.listed ? " Listed: " + printable(problem.reason) + "." : ""),
                   style.text);
  }
  return out;
}

/// The impacts of each window and how far the run was compared.
Table windows_of(const RunDetails& details) {
  Table table({word_column("impacts up to", ""), number_column("t [s]", "", "", ""),
               number_column("compared [s]", "", "", ""), number_column("exact", "", "", ""),
               number_column("found", "", "", ""), number_column("matched", "", "", "")});
  for (const Window window : windows) {
    const RunDetails::OfWindow& of = details.in(window);
    const char* name = window == Window::early     ? "the first few"
                       : window == Window::horizon ? "the horizon"
                                                   : "the end";
    table.add({name, number_cell(of.until, as_instant), number_cell(of.covered, as_instant),
               count_cell(of.exact), count_cell(of.found), count_cell(of.matched)});
  }
  return table;
}

/// What the run found of a number, and what is exact.
std::string found_and_exact(const std::optional<double>& found, const std::optional<double>& exact,
                            const std::string& unit, int digits) {
  const auto text = [&](const std::optional<double>& value) {
    return value ? number_and_unit(*value, fixed(digits), unit) : std::string("none");
  };
  return fmt::format("{} (exact: {})", text(found), text(exact));
}

std::string swing_sentence(const SwingMatch& swing) {
  return fmt::format("Swing from {:.4f} to {:.4f} s: energy {}, amplitude {}.", swing.from,
                     swing.until, found_and_exact(swing.energy.found, swing.energy.exact, "J", 8),
                     found_and_exact(swing.amplitude.found, swing.amplitude.exact, "rad", 5));
}

/// The tensions and the first impulse, a sentence each where there is one.
std::vector<std::string> pull_sentences(const RunDetails& details) {
  std::vector<std::string> sentences;
  const auto add = [&](const char* name, const std::optional<ExactAndFound>& both,
                       const char* unit) {
    if (both) {
      sentences.push_back(
          fmt::format("{}: {}.", name, found_and_exact(both->found, both->exact, unit, 6)));
    }
  };
  add("Tension at rest", details.rest_tension, "N");
  add("Largest tension of a taut phase", details.largest_tension, "N");
  add("Impulse of the first impact", details.first_impulse, "N s");
  return sentences;
}

/// The contacts of elastic cables, a sentence each for their number and their worst errors.
std::vector<std::string> contact_sentences(const ContactMatch& contacts) {
  std::vector<std::string> sentences = {fmt::format(
      "Contacts of elastic cables up to the predictability horizon: {} of {} exact ones "
      "are matched, {} found.",
      contacts.matched, contacts.exact, contacts.found)};
  if (contacts.peak) {
    sentences.push_back(
        fmt::format("Largest tension of a contact: {}.",
                    found_and_exact(contacts.peak->found, contacts.peak->exact, "N", 6)));
  }
  std::vector<std::string> errors;
  const auto add = [&](const char* name, const std::optional<double>& error, const char* unit) {
    if (error) {
      errors.push_back(fmt::format("{} by {:.2g}{}", name, *error, unit));
    }
  };
  add("a largest tension", contacts.peak_error, " %");
  add("an impulse", contacts.impulse_error, " %");
  add("a duration", contacts.time_error, " %");
  add("a restitution", contacts.restitution_error, "");
  if (!errors.empty()) {
    sentences.push_back(fmt::format("Contacts are off at worst: {}.", fmt::join(errors, ", ")));
  }
  return sentences;
}

std::string restitution_sentence(const MeasuredRestitution& measured) {
  return fmt::format("Restitution of {}: {} in the mean, from {} to {}.",
                     counted(measured.count, "impact"), fixed_text(measured.mean, 4),
                     fixed_text(measured.smallest, 4), fixed_text(measured.largest, 4));
}

/// Settling, the swing, restitution and what was recorded, a sentence each.
std::string sentences_of(const RunDetails& details, bool all, std::size_t width) {
  const RunDetails::OfWindow& horizon = details.in(Window::horizon);
  std::vector<std::string> sentences = {
      fmt::format("Impacts up to the predictability horizon, t = {:.4f} s: {} of {} exact ones are "
                  "matched, {} found.",
                  horizon.until, horizon.matched, horizon.exact, horizon.found)};
  for (const LastImpactMatch& last : details.last_impacts) {
    if (!last.exact && !last.found) {
      continue;  // the exact motion does not lock, or beyond its horizon
    }
    sentences.push_back(fmt::format("Last impact faster than {:g} m/s: {}.", last.speed,
                                    found_and_exact(last.found, last.exact, "s", 4)));
  }
  if (details.swing) {
    sentences.push_back(swing_sentence(*details.swing));
  }
  if (details.restitution) {
    sentences.push_back(restitution_sentence(*details.restitution));
  }
  const std::vector<std::string> pulls = pull_sentences(details);
  sentences.insert(sentences.end(), pulls.begin(), pulls.end());
  if (details.contacts) {
    const std::vector<std::string> contacts = contact_sentences(*details.contacts);
    sentences.insert(sentences.end(), contacts.begin(), contacts.end());
  }
  if (all) {
    sentences.push_back(fmt::format("Recorded: {}.", counted(details.recorded_impacts, "impact")));
  }
  if (all && details.slow_impacts > 0) {
    sentences.push_back(
        fmt::format("Slower, and only counted: {}.", counted(details.slow_impacts, "impact")));
  }
  std::string out;
  for (const std::string& sentence : sentences) {
    out += wrapped(sentence, width);
  }
  return out;
}

/// "bullet64 3.24 (float64), model row, step 0.001 s"
std::string setup_text(const Report& report, const RunKey& key) {
  const EngineRow* const engine = find_by(report.engines, &EngineRow::name, key.engine);
  const bool known = engine != nullptr && engine->info;
  return printable(key.engine) +
         (known ? fmt::format(" {} ({})", printable(engine->info->version), engine->info->precision)
                : "") +
         fmt::format(", model {}, step {:g} s", printable(key.model), key.step);
}

/// What the run comes to, in a word.
std::string verdict_text(const RunRow& run, const TerminalStyle& style) {
  return run.verdict
             ? "verdict: " +
                   coloured(to_string(run.verdict->word), colour_of(run.verdict->word), style) +
                   "\n"
             : "";
}

/// Processor time, where the run was timed.
std::string cost_text(const Report& report, std::size_t width) {
  if (report.context.timing.empty()) {
    return "";
  }
  const TimingRow& timing = report.context.timing.front();
  return wrapped(fmt::format("Cost: {:.2g} s of processor time for a second of motion, {:.2g} "
                             "closed-form flights for a step.",
                             timing.second_cost, timing.cost_ratio),
                 width);
}

}  // namespace

std::string report_summary(const Report& report, bool all, const TerminalStyle& style) {
  const std::vector<Scorecard> cards = worst_first_scorecards(report);
  std::size_t widest = 0;
  for (const Scorecard& card : cards) {
    widest = std::max(widest, printable(card.engine).size());
  }
  std::string out;
  for (const Scorecard& card : cards) {
    out += fmt::format("{:<{}}  {}\n", printable(card.engine), widest, sentence_of(card));
  }
  if (const std::string systems = systems_sentence(report); !systems.empty()) {
    out += "\n" + wrapped(systems, style.text);
  }
  if (all) {
    out += "\n" + answers_table(report).plain(style) + "\n" + legend(report, style.text);
    if (const std::string stopped = stopped_sentence(report); !stopped.empty()) {
      out += wrapped(stopped, style.text);
    }
    if (report.distributions) {
      out += "\n" + distributions_table(report).plain(style) + "\n" +
             wrapped(distributions_paragraph(report), style.text) +
             wrapped(words::how_to_read_distributions, style.text);
    }
  }
  const Table failures = failures_table(report);
  return failures.empty() ? out : out + "\n" + failures.plain(style);
}

std::string run_card(const Report& report, bool all_metrics, const TerminalStyle& style) {
  const RunRow& run = report.runs.front();
  std::string out =
      wrapped(printable(run.key.the_case) + " on " + setup_text(report, run.key), style.text) +
      wrapped_lines(fmt::format("run: {}{}", to_string(run.status),
                                run.reason.empty() ? "" : ", " + printable(run.reason)),
                    style.text, 2) +
      verdict_text(run, style) + judgement_text(run, style);
  if (!run.metrics || !run.details) {
    return out;
  }
  out += "\n" + metrics_of(run, all_metrics).plain(style) + "\n";
  if (all_metrics) {
    out += windows_of(*run.details).plain(style) + "\n";
  }
  out += sentences_of(*run.details, all_metrics, style.text);
  for (const Finding& finding : report.findings) {
    out += wrapped("Found: " + printable(finding.sentence, longest_sentence) + ".", style.text);
  }
  out += cost_text(report, style.text);
  return all_metrics
             ? out
             : out + "\n" +
                   wrapped(
                       fmt::format(
                           "--all prints all {} metrics; --json FILE writes the run for scripts.",
                           metric_list().size()),
                       style.text);
}

}  // namespace tautline::bench
