#include "bench/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {
namespace {

std::string shown_text(std::string_view text) { return printable(text, longest_sentence); }

std::string megabytes(double bytes) { return fmt::format("{:.0f} MB", bytes / 1e6); }

constexpr const char* about_control =
    "The **exact** engine is the control: the exact motion goes through the same loop and the same "
    "comparison as every engine. Its `event` model names its impacts, as the engines' `event` "
    "models do. Its `sampled` model gives only the state and the impulses of each step, as models "
    "with fixed steps do. What `sampled` misses, no comparison at that step can see, and its e "
    "error is what gravity does within a step to velocities that are exact.";

constexpr const char* about_horizon =
    "The **horizon** is the instant at which an error of 1e-12 at the start of the exact motion "
    "can have grown to 1e-3. It follows, to first order, from the derivative of the state along "
    "the motion. Beyond the horizon a difference says nothing about an engine.";

constexpr const char* about_settling =
    "**Settling** has three definitions. *Last impact > v* is the instant of the last impact that "
    "closes faster than v. There is none where the exact motion does not lock before its horizon: "
    "beyond it one motion is a draw of many. A run has none if it stopped before. The *lock* is "
    "the instant at which the final set of cables becomes taut in the exact motion; *later "
    "impacts* are those of the run after it. The *swing* is the motion that is left. Its energy "
    "counts from the equilibrium; a run has a mean over the last period. Its amplitude is half the "
    "range of the angle; a run has it from its samples. A run without a whole period after the "
    "lock has no swing.";

constexpr const char* about_restitution =
    "**Restitution** is the rebound rate of a cable over its closing rate. It is measured at each "
    "counted impact of a single step, up to the exact lock. Both rates are of the engine's "
    "velocities, before and after the step, at the pose before it. The *e error* is the largest "
    "distance from the cable's own restitution.";

constexpr const char* about_energy =
    "**Overstretch** is the largest length of a cable beyond its own, and **energy gain** the "
    "largest rise of the energy above the start. Both are taken over every step of a run; a model "
    "with fixed steps is also looked at after the exact motion has ended. A scheme whose "
    "velocities belong to the middle of a step shows an offset of half a step of gravity here, "
    "even if it gains nothing.";

constexpr const char* about_cost =
    "**Cost** is the processor time of one step, in units of one closed-form flight with its gaps. "
    "Both are measured side by side in the same process, over the first second of the motion, "
    "which "
    "is repeated; the median counts. The start of a simulation does not.";

constexpr const char* about_stops =
    "A run *stopped* if its own simulation ended it; the simulation says why. Some engines do not "
    "follow the motion on taut cables, others can go no further. Such a run is compared up to its "
    "stop. It is a failure only if it stopped well before both the horizon and the first taut "
    "cable "
    "of the exact motion.";

constexpr const char* about_verdicts =
    "A **verdict** says what is wrong with one run, from the exact motion of its own case: no "
    "table "
    "of limits by case, engine or model has a part in it. Over all cases the worst verdict is "
    "shown, and how many runs have it.";

}  // namespace

std::string in_words(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::vector<std::string> how_to_read(const Report& report) {
  return {
      about_control,
      fmt::format("A **position error** is the largest distance from the exact position. *Early* "
                  "goes up to impact {} of the exact motion and ends before the next, *to the "
                  "horizon* up to the predictability horizon. Over all cases the tables give the "
                  "median and the worst.",
                  report.options.early_impacts),
      about_horizon,
      fmt::format("**Impacts** are counted if they are faster than {:g} m/s. An impact of the run "
                  "and an exact one are *matched* if they are on the same cable and each is the "
                  "other's nearest in time.",
                  report.options.count_speed),
      about_settling,
      about_restitution,
      about_energy,
      about_cost,
      about_stops,
      about_verdicts + (" " + verdict_words()),
  };
}

std::string_view meaning_of(Word word) {
  constexpr std::array meanings = {
      "three impacts or more could be read and all keep the restitution, the position is as good "
      "as "
      "the step allows, and nothing else is wrong",
      "something is wrong, and a person has listed it with the reason",
      "something is wrong, and it is not listed",
      "nothing is wrong, but too few impacts could be read, or the position could not be judged, "
      "to "
      "say more"};
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
  return following.ratio
             ? fmt::format(
                   "position up to {:.3g} s: {:.2g} m off at worst, {:.2g} times what a plain "
                   "scheme of this step may be",
                   following.until, following.error, *following.ratio)
             : "position: cannot be told at this step";
}

std::string how_to_read_causes() {
  return "The exact motion is restarted from the run's own state before and after each flight, "
         "impact and stretch on taut cables. The difference is what the run did wrong in between. "
         "The exact motion carries all differences to one instant. There each is a part of the "
         "deviation, and along the deviation the parts add up to it. Instants are tried after "
         "impacts 1, 2, 4, 8 and 16 of the exact motion, up to the horizon, and at the end of a "
         "run with fewer impacts. Taken is the last at which amplification is no more than a tenth "
         "of all parts, or, if there is none, the first at which it is no more than half. A share "
         "is the size of a part over the sum of the sizes of all, and in the table the mean over "
         "the "
         "cases, so that a row adds up to 1. *Covered* is the instant as a part of the "
         "predictability "
         "horizon, the median over the cases: what happens later, such as slow impacts that are "
         "lost "
         "to a threshold, has no share.";
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
  return fmt::format(
      "{} of {} stopped before the end. This is no failure, and such a run is compared up to "
      "there. "
      "Stopped: {}.",
      count, counted(report.runs.size(), "run"), joined(models, "and"));
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
  return the_case.gravity.squaredNorm() == 1.0;  // exactly: what is written as one
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
