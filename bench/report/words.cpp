#include "bench/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/report/report.hpp"
#include "tautline_bench_report_words.inc"

namespace tautline::bench {
namespace {

using namespace fmt::literals;

std::string shown_text(std::string_view text) { return printable(text, longest_sentence); }

std::string megabytes(double bytes) { return fmt::format("{:.0f} MB", bytes / 1e6); }

/// The smallest and the largest of some numbers.
struct Range {
  double smallest;
  double largest;
};

/// The median errors up to the horizon at the smallest step, of the control or of the others; none
/// without a number.
std::optional<Range> median_errors(const Report& report, bool of_control) {
  double step = std::numeric_limits<double>::infinity();
  for (const SummaryRow& row : report.summary) {
    step = std::min(step, row.key.step);
  }
  const auto place = place_of("horizon_position_error");
  std::optional<Range> result;
  for (const SummaryRow& row : report.summary) {
    const auto& error = row.metrics.at(place.value());
    if (row.key.step == step && (row.key.engine == control) == of_control && error &&
        error->median) {
      const double value = *error->median;
      result = result ? Range{std::min(result->smallest, value), std::max(result->largest, value)}
                      : Range{value, value};
    }
  }
  return result;
}

/// How the runs ended; what did not happen is not said.
std::string endings_sentence(const Report& report) {
  const auto count = [&](auto... statuses) {
    return std::count_if(report.runs.begin(), report.runs.end(),
                         [&](const RunRow& run) { return ((run.status == statuses) || ...); });
  };
  std::vector<std::string> parts = {fmt::format("{} ran to the end", count(Status::finished))};
  if (const auto stopped = count(Status::stopped); stopped > 0) {
    parts.push_back(fmt::format("{} stopped where the engine goes no further", stopped));
  }
  if (const auto bad = count(Status::failed, Status::diverged); bad > 0) {
    parts.push_back(fmt::format("{} failed or diverged", bad));
  }
  if (const auto refused = count(Status::unsupported); refused > 0) {
    parts.push_back(fmt::format("{} the engine does not support", refused));
  }
  return joined(parts, "and") + ".";
}

std::string errors_sentence(const Report& report) {
  const auto engines = median_errors(report, false);
  const auto exact = median_errors(report, true);
  if (!engines) {
    return "";
  }
  const std::string control_error =
      !exact ? ""
      : exact->largest == 0.0
          ? words::no_control_error
          : fmt::format(words::control_error, "error"_a = number_text(exact->largest, as_error));
  return fmt::format(words::errors, "least"_a = number_text(engines->smallest, as_error),
                     "most"_a = number_text(engines->largest, as_error),
                     "control"_a = control_error);
}

/// "2 cases on 3 engines with 7 models, at steps 0.01 and 0.001 s: 42 runs (40 of engines, 2 of the
/// control)".
std::string scope_words(const Report& report) {
  std::set<std::string> engines;
  std::set<std::pair<std::string, std::string>> models;
  for (const SummaryRow& row : report.summary) {
    engines.insert(row.key.engine);
    models.emplace(row.key.engine, row.key.model);
  }
  const std::vector<std::string> steps =
      listed(report.options.steps, [](double step) { return number_text(step, as_count); });
  const auto controls = std::count_if(report.runs.begin(), report.runs.end(),
                                      [](const RunRow& run) { return run.key.engine == control; });
  const auto all = static_cast<std::ptrdiff_t>(report.runs.size());
  return fmt::format(
      "{} on {} with {}, at {} of {} s: {}{}", counted(report.cases.size(), "case"),
      counted(engines.size(), "engine"), counted(models.size(), "model"),
      steps.size() == 1 ? "a step" : "steps", joined(steps, "and"),
      counted(report.runs.size(), "run"),
      controls == 0 || controls == all
          ? ""
          : fmt::format(" ({} of engines, {} of the control)", all - controls, controls));
}

}  // namespace

std::string in_words(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::vector<std::string> how_to_read(const Report& report) {
  std::vector<std::string> result = {
      words::about_control,
      fmt::format(words::about_position, "impacts"_a = report.options.early_impacts),
      words::about_horizon,
      fmt::format(words::about_impacts, "speed"_a = report.options.count_speed),
      words::about_settling,
      words::about_restitution,
      words::about_energy,
      words::about_cost,
      words::about_stops,
      fmt::format(words::about_verdicts, "verdicts"_a = verdict_words())};
  if (report.has_contacts()) {
    result.insert(std::find(result.begin(), result.end(), words::about_energy),
                  fmt::format(words::about_contacts, "speed"_a = report.options.count_speed));
  }
  return result;
}

std::string_view meaning_of(Word word) {
  constexpr std::array<std::string_view, all_words.size()> meanings = {
      words::sound, words::listed_problem, words::problem, words::too_few};
  return meanings.at(static_cast<std::size_t>(word));
}

std::string verdict_words() {
  std::string out;
  for (const Word word : all_words) {
    out += fmt::format("{}*{}*: {}.", out.empty() ? "" : " ", to_string(word), meaning_of(word));
  }
  return out;
}

std::string followed_text(const Following& following) {
  return following.ratio ? fmt::format(words::followed, "until"_a = following.until,
                                       "error"_a = following.error, "ratio"_a = *following.ratio)
                         : "position: cannot be told at this step";
}

std::string answer_text(const Report& report) {
  std::string text = fmt::format("{}, each compared with the exact motion of its case. {}",
                                 scope_words(report), endings_sentence(report));
  if (!report.complete) {
    text +=
        fmt::format(" **This report is incomplete: {} {} planned.**",
                    counted(report.planned_runs, "run"), report.planned_runs == 1 ? "was" : "were");
  }
  if (const std::string errors = errors_sentence(report); !errors.empty()) {
    text += " " + errors;
  }
  std::vector<std::string> missing;
  for (const EngineRow& engine : report.engines) {
    if (engine.problem) {
      missing.push_back(verbatim(engine.name));
    }
  }
  if (!missing.empty()) {
    text += " Not compared: " + joined(missing, "and") + ", for the reasons below.";
  }
  return text;
}

std::string lead_sentence(const Report& report) {
  std::set<std::string> engines;
  for (const RunRow& run : report.runs) {
    if (run.key.engine != control) {
      engines.insert(run.key.engine);
    }
  }
  const bool systems = std::any_of(report.cases.begin(), report.cases.end(),
                                   [](const CaseRow& one) { return one.system.has_value(); });
  return fmt::format(words::lead_in, "bodies"_a = systems ? "bodies" : "a body",
                     "engines"_a = counted(engines.size(), "physics engine"),
                     "simulate"_a = engines.size() == 1 ? "simulates" : "simulate",
                     "cases"_a = counted(report.cases.size(), "case"));
}

std::string evidence_text(const Finding& finding) {
  const std::string runs = counted(finding.runs, "run");
  return finding.impacts == 0 ? runs : counted(finding.impacts, "impact") + " of " + runs;
}

std::string stopped_sentence(const Report& report) {
  std::size_t count = 0;
  std::map<std::string, std::string> reasons;  // of each model
  for (const RunRow& run : report.runs) {
    if (run.status == Status::stopped) {
      ++count;
      reasons.emplace(printable(run.key.engine) + " " + printable(run.key.model),
                      printable(run.reason));
    }
  }
  if (count == 0) {
    return "";
  }
  const std::vector<std::string> models = listed(
      reasons, [](const auto& one) { return fmt::format("{} ({})", one.first, one.second); });
  return fmt::format(words::stopped, "count"_a = count,
                     "runs"_a = counted(report.runs.size(), "run"),
                     "models"_a = joined(models, "and"));
}

std::string systems_sentence(const Report& report) {
  if (std::none_of(report.cases.begin(), report.cases.end(),
                   [](const CaseRow& one) { return one.system.has_value(); })) {
    return "";
  }
  const auto left_out = [](const char* what, const std::vector<std::string>& models) {
    return models.empty()
               ? ""
               : fmt::format(" Models that run {}: {}.", what,
                             printable(fmt::format("{}", fmt::join(models, "; ")), 1024));
  };
  return words::systems +
         left_out("one body in the plane alone are left out", report.in_the_plane_alone) +
         left_out("inextensible cables alone are left out of systems with elastic ones",
                  report.inextensible_alone);
}

std::vector<Fact> context_facts(const Report& report) {
  const Context& context = report.context;
  std::vector<Fact> facts = {
      {"command", shown_text(context.command), true},
      {"started",
       fmt::format("{}, took {:.1f} s; {} of {} kept from before", shown_text(context.started),
                   context.elapsed, context.kept_runs, counted(report.planned_runs, "run"))},
      {"tautline", fmt::format("{}, commit {}", shown_text(report.version),
                               context.commit.empty() ? "unknown" : shown_text(context.commit))},
      {"built by",
       fmt::format("{}, {}", shown_text(context.compiler), shown_text(context.build_type))},
      {"flags", shown_text(context.flags), true},
      {"machine",
       fmt::format("{}, {}", shown_text(context.processor), counted(context.cores, "core"))},
      {"memory", fmt::format("at most {} in the program and {} in a worker",
                             megabytes(context.program_memory), megabytes(context.worker_memory))},
  };
  if (!context.shards.empty()) {
    facts.push_back({"merged", fmt::format("from {} of {}, whose times add up; costs are those of "
                                           "the machine that each run was on",
                                           counted(context.shards.size(), "shard"),
                                           context.shards.front().of)});
  }
  if (report.listed) {
    facts.push_back(
        {"listed problems", fmt::format("{}, version {}", shown_text(report.listed->file),
                                        shown_text(report.listed->version))});
  }
  std::erase_if(facts, [](const Fact& fact) { return fact.text.empty(); });
  return facts;
}

bool is_nondimensional(const CaseRow& the_case) {
  if (the_case.system) {
    const std::vector<double>& gravity = the_case.system->gravity;
    return std::inner_product(gravity.begin(), gravity.end(), gravity.begin(), 0.0) == 1.0;
  }
  return the_case.plane && the_case.plane->gravity.squaredNorm() == 1.0;  // exactly: written as one
}

bool is_nondimensional(const Report& report) {
  return !report.cases.empty() &&
         std::all_of(report.cases.begin(), report.cases.end(),
                     [](const CaseRow& the_case) { return is_nondimensional(the_case); });
}

std::string counted(std::size_t count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

const char* to_string(Status status) {
  constexpr std::array names = {"finished", "stopped", "diverged", "failed", "unsupported"};
  return names.at(static_cast<std::size_t>(status));
}

const char* to_string(Word word) {
  constexpr std::array names = {"sound", "listed problem", "problem", "too few to tell"};
  return names.at(static_cast<std::size_t>(word));
}

}  // namespace tautline::bench
