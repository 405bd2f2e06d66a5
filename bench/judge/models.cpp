#include "bench/judge/models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace tautline::bench {
namespace {

/// A ratio that grows by more than this as the step falls to a tenth of it does not belong to an
/// error that falls with the step [-]: of errors that stay the same it grows tenfold.
constexpr double growth_of_a_fault = 3.0;

using Runs = std::vector<const JudgedRun*>;

double finest(const Runs& runs) {
  return (*std::min_element(runs.begin(), runs.end(),
                            [](const auto* one, const auto* two) { return one->step < two->step; }))
      ->step;
}

/// The worst course of all cases; with one exact course in each of them, exact.
Course course_over_cases(const Runs& runs) {
  std::map<std::string, std::map<double, double, std::greater<>>> ratios;  // by case and step
  for (const JudgedRun* run : runs) {
    if (run->judgement->following.ratio) {
      ratios[run->the_case][run->step] = *run->judgement->following.ratio;
    }
  }
  constexpr std::array worst_first = {Course::does_not_converge, Course::off, Course::converges,
                                      Course::as_good, Course::exact};
  std::size_t worst = worst_first.size();
  for (const auto& [name, curve] : ratios) {
    std::vector<double> steps;
    std::vector<double> values;
    for (const auto& [step, ratio] : curve) {
      steps.push_back(step);
      values.push_back(ratio);
    }
    const auto place = static_cast<std::size_t>(
        std::find(worst_first.begin(), worst_first.end(), course_of(steps, values)) -
        worst_first.begin());
    worst = std::min(worst, place);
  }
  if (worst == worst_first.size()) {
    return Course::untold;
  }
  const bool located = std::all_of(runs.begin(), runs.end(), [](const JudgedRun* run) {
    return run->judgement->following.located || !run->judgement->following.ratio;
  });
  // a model whose steps meet no impact can be near, not exact
  return worst_first.at(worst) == Course::exact && !located ? Course::as_good
                                                            : worst_first.at(worst);
}

void add_run(const JudgedRun& run, ModelJudgement& model) {
  const Judgement& one = *run.judgement;
  ++model.cases;
  model.impacts.due += one.impacts.due;
  model.impacts.missed += one.impacts.missed;
  model.overstretch = std::max(model.overstretch, one.overstretch);
  model.energy = std::max(model.energy, one.energy.value_or(0.0));
  model.flight = std::max(model.flight, one.flight);
  if (one.rotation) {
    model.rotation = std::max(model.rotation.value_or(0.0), *one.rotation);
  }
  const Following& following = one.following;
  if (!following.ratio) {
    return;
  }
  ++model.told;
  if (!model.ratio || *following.ratio > *model.ratio) {
    model.ratio = following.ratio;
    model.worst_case = run.the_case;
    model.error = following.error;
    model.time = following.time;
  }
}

ModelJudgement model_of(const Runs& runs) {
  ModelJudgement model;
  model.engine = runs.front()->engine;
  model.model = runs.front()->model;
  model.step = finest(runs);
  std::vector<AuditedImpact> impacts;
  std::optional<StaysTaut> stuck;
  for (const JudgedRun* run : runs) {
    if (run->step != model.step) {
      continue;
    }
    add_run(*run, model);
    impacts.insert(impacts.end(), run->audit->impacts.begin(), run->audit->impacts.end());
    const Rebounds& rebounds = run->judgement->rebounds;
    if (rebounds.stays_taut && (!stuck || *rebounds.speed > stuck->speed)) {
      stuck = StaysTaut{*rebounds.speed};
    }
  }
  model.rebounds = rebounds_of(impacts, stuck);
  const auto elastic = [&](const JudgedRun* run) {
    return run->step != model.step || run->judgement->rebounds.word == Rebound::elastic;
  };
  if (std::all_of(runs.begin(), runs.end(), elastic)) {
    model.rebounds.word = Rebound::elastic;
  }
  // a fault of one case does not drown in the impacts of others, nor faults of several make a new
  // one
  const bool pooled = model.rebounds.wrong() && model.rebounds.word != Rebound::scatters;
  for (const JudgedRun* run : runs) {
    const Rebounds& of_run = run->judgement->rebounds;
    const bool plainer =
        !model.rebounds.wrong() ||
        (of_run.word != Rebound::scatters &&
         (model.rebounds.word == Rebound::scatters || of_run.off > model.rebounds.off));
    if (!pooled && run->step == model.step && of_run.wrong() && plainer) {
      model.rebounds = of_run;
    }
  }
  model.course = course_over_cases(runs);
  return model;
}

std::string impacts_text(std::size_t count) {
  return fmt::format("{} impact{}", count, count == 1 ? "" : "s");
}

/// "3 of 52 impacts", or of all "52 impacts".
std::string part_text(std::size_t part, std::size_t all) {
  return part == all ? impacts_text(all) : fmt::format("{} of {}", part, impacts_text(all));
}

std::string off_text(const Rebounds& rebounds) {
  const double deviation = rebounds.deviation.value_or(0.0);
  return fmt::format("{:.2g} too {} ({}){}", std::abs(deviation), deviation > 0.0 ? "high" : "low",
                     part_text(rebounds.off, rebounds.readable),
                     rebounds.speed ? fmt::format("; lost below {:.2g} m/s", *rebounds.speed) : "");
}

std::string word_text(const Rebounds& rebounds) {
  switch (rebounds.word) {
    case Rebound::kept:
      return fmt::format("kept ({}, from {:.2g} m/s on)", impacts_text(rebounds.readable),
                         rebounds.slowest.value_or(0.0));
    case Rebound::off:
      return off_text(rebounds);
    case Rebound::lost_below:
      return fmt::format("lost below {:.2g} m/s ({})", rebounds.speed.value_or(0.0),
                         part_text(rebounds.off, rebounds.readable));
    case Rebound::loses_some:
      return fmt::format("lost in {}", part_text(rebounds.off, rebounds.readable));
    case Rebound::scatters:
      return fmt::format("scatters: {} off", part_text(rebounds.off, rebounds.readable));
    case Rebound::none:
      return rebounds.stays_taut
                 ? fmt::format("none: stays taut after {:.3g} m/s", rebounds.speed.value_or(0.0))
                 : fmt::format("none: {} lost", part_text(rebounds.off, rebounds.readable));
    case Rebound::elastic:
      return "no impacts: elastic cables";
    case Rebound::too_few:
      break;
  }
  return fmt::format("too few to tell ({})", impacts_text(rebounds.readable));
}

}  // namespace

Course course_of(const std::vector<double>& steps, const std::vector<double>& ratios) {
  if (ratios.empty()) {
    return Course::untold;
  }
  if (*std::max_element(ratios.begin(), ratios.end()) <= exact_ratio) {
    return Course::exact;
  }
  if (ratios.back() <= most_ratio) {
    return Course::as_good;
  }
  if (ratios.size() == 1) {
    return Course::off;
  }
  const double decades = std::log10(steps.front() / steps.back());
  const double growth = std::pow(ratios.back() / ratios.front(), 1.0 / decades);
  return growth > growth_of_a_fault ? Course::does_not_converge : Course::converges;
}

std::vector<ModelJudgement> models_of(const std::vector<JudgedRun>& runs) {
  std::vector<ModelJudgement> models;
  for (const Runs& of_model : by_model(runs)) {
    models.push_back(model_of(of_model));
  }
  return models;
}

std::vector<Finding> rebound_findings(const std::vector<ModelJudgement>& models,
                                      const std::vector<JudgedRun>& runs) {
  std::vector<Finding> findings;
  for (const ModelJudgement& model : models) {
    if (!model.rebounds.wrong()) {
      continue;
    }
    Finding finding;
    finding.engine = model.engine;
    finding.model = model.model;
    finding.kind = to_string(model.rebounds.word);
    finding.sentence = "restitution " + words_of(model.rebounds);
    finding.value = model.rebounds.deviation;
    finding.impacts = model.rebounds.readable;
    for (const JudgedRun& run : runs) {
      if (run.engine == model.engine && run.model == model.model) {
        finding.runs += run.step == model.step ? 1U : 0U;
        if (run.judgement->rebounds.wrong()) {
          finding.shown_in.push_back({run.the_case, run.step});
        }
      }
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

const char* to_string(Rebound word) {
  constexpr std::array names = {"kept",     "off",  "lost-below", "loses-some",
                                "scatters", "none", "too-few",    "elastic"};
  return names.at(static_cast<std::size_t>(word));
}

const char* to_string(Course word) {
  constexpr std::array names = {"exact", "as-good", "converges", "does-not-converge",
                                "off",   "untold"};
  return names.at(static_cast<std::size_t>(word));
}

const char* to_string(Barrier barrier) {
  constexpr std::array names = {"end", "effort", "growth", "fork"};
  return names.at(static_cast<std::size_t>(barrier));
}

std::string words_of(const Rebounds& rebounds) {
  const std::string steps = rebounds.steps > 1.0 && rebounds.word != Rebound::none
                                ? fmt::format(", in {:.0f} steps", rebounds.steps)
                                : "";
  return word_text(rebounds) + steps;
}

std::string flight_text(double flight) {
  return fmt::format("accelerates wrong in flight, by {:.2g} %", 100.0 * flight);
}

std::string rotation_text(double rotation) {
  return fmt::format("turns wrong in flight, {:.2g} times what a step explains", rotation);
}

std::string words_of(Course course, const std::optional<double>& ratio) {
  const std::string times =
      fmt::format("{:.2g} times the error of a plain scheme", ratio.value_or(0.0));
  switch (course) {
    case Course::exact:
      return "exact to its events";
    case Course::as_good:
      return "as good as a step-by-step model can be";
    case Course::converges:
      return "converges, with " + times;
    case Course::does_not_converge:
      return "does not converge: " + times;
    case Course::off:
      return times;
    case Course::untold:
      break;
  }
  return "cannot be told";
}

}  // namespace tautline::bench
