#include "bench/report/scorecard/scorecard.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/statistics.hpp"
#include "bench/report/tables/columns.hpp"

namespace tautline::bench {
namespace {

constexpr std::array makers_in_order = {Maker::engine, Maker::by_hand, Maker::tautline};

bool is_about_rebounds(const Finding& finding) {
  const FindingKind* const kind = finding_kind(finding.kind);
  return kind != nullptr && kind->about == Aspect::rebound;
}

/// The shortest cable of each case [m].
std::map<std::string, double> shortest_cables(const Report& report) {
  std::map<std::string, double> result;
  for (const CaseRow& the_case : report.cases) {
    for (const CableRow& cable : the_case.geometry) {
      const auto [place, added] = result.try_emplace(the_case.name, cable.length);
      place->second = std::min(place->second, cable.length);
    }
  }
  return result;
}

using Runs = std::vector<const RunRow*>;

/// The median of the early position errors over the shortest cables.
std::optional<double> median_off(const Runs& runs, const std::map<std::string, double>& cables) {
  const std::size_t early = place_of("early_position_error").value();
  std::vector<double> values;
  for (const RunRow* run : runs) {
    const auto cable = cables.find(run->key.the_case);
    const std::optional<double> error = run->metric(early);
    if (did_its_work(run->status) && error && cable != cables.end() && cable->second > 0.0) {
      values.push_back(*error / cable->second);
    }
  }
  return values.empty() ? std::nullopt : std::optional(median(std::move(values)));
}

std::optional<CostRow> cost_of(const Report& report, const SetupKey& key) {
  const auto& costs = report.context.costs;
  const CostRow* const found = find_by(costs, &CostRow::key, key);
  return found != nullptr ? std::optional(*found) : std::nullopt;
}

/// The size of e got less e asked over all the impacts that were audited in `runs`.
void audit(ModelCard& card, const Runs& runs) {
  double squares = 0.0;
  for (const RunRow* run : runs) {
    if (run->scatter) {
      const Scatter& found = *run->scatter;
      const auto count = static_cast<double>(found.count);
      card.impacts += found.count;
      squares +=
          count * (found.mean * found.mean + found.standard_deviation * found.standard_deviation);
    }
  }
  if (card.impacts > 0) {
    card.rebound_off = std::sqrt(squares / static_cast<double>(card.impacts));
  }
}

ModelCard model_card(const Report& report, const std::string& engine, const Model& model,
                     const std::map<std::string, double>& cables) {
  ModelCard card;
  card.model = model.name;
  card.maker = model.maker;
  std::map<double, Runs, std::greater<>> by_step;
  for (const RunRow& run : report.runs) {
    if (run.key.engine == engine && run.key.model == model.name) {
      by_step[run.key.step].push_back(&run);
      card.verdicts.add(run);
    }
  }
  for (const auto& [step, runs] : by_step) {
    card.setups.push_back(
        {model.name, step, median_off(runs, cables), cost_of(report, {engine, model.name, step})});
  }
  if (!by_step.empty()) {
    audit(card, by_step.rbegin()->second);
  }
  for (const Finding& finding : report.findings) {
    if (finding.engine == engine && finding.model == model.name && is_about_rebounds(finding)) {
      card.wrong.push_back(finding.kind);
    }
  }
  return card;
}

bool any_failed(const Report& report, const std::string& engine, const std::string& model) {
  return std::any_of(report.runs.begin(), report.runs.end(), [&](const RunRow& run) {
    return run.key.engine == engine && run.key.model == model && !did_its_work(run.status);
  });
}

/// The setup to use of `setups`, all of which have an error.
std::optional<Setup> chosen(std::vector<Setup> setups) {
  const auto less = [](const Setup& one, const Setup& two) {
    const bool fits = *one.off <= good_enough;
    if (fits != (*two.off <= good_enough)) {
      return fits;
    }
    if (fits && one.step != two.step) {
      return one.step > two.step;
    }
    return *one.off < *two.off;
  };
  const auto best = std::min_element(setups.begin(), setups.end(), less);
  return best != setups.end() ? std::optional(*best) : std::nullopt;
}

MakerCard maker_card(const Report& report, const std::string& engine, Maker maker,
                     std::vector<ModelCard> models) {
  MakerCard card;
  card.maker = maker;
  std::vector<Setup> right;
  std::vector<Setup> all;
  for (const ModelCard& model : models) {
    card.verdicts.add(model.verdicts);
    const bool usable = model.rebounds_rightly() && !any_failed(report, engine, model.model);
    for (const Setup& setup : model.setups) {
      if (setup.off) {
        all.push_back(setup);
        if (usable) {
          right.push_back(setup);
        }
      }
    }
  }
  card.use_is_right = !right.empty();
  card.use = chosen(right.empty() ? std::move(all) : std::move(right));
  card.models = std::move(models);
  return card;
}

}  // namespace

Scorecard scorecard(const Report& report, const std::string& engine) {
  Scorecard card;
  card.engine = engine;
  const EngineRow* const row = find_by(report.engines, &EngineRow::name, engine);
  if (row == nullptr || !row->info) {
    return card;
  }
  card.version = row->info->version;
  card.precision = row->info->precision;
  const std::map<std::string, double> cables = shortest_cables(report);
  for (const Maker maker : makers_in_order) {
    std::vector<ModelCard> models;
    for (const Model& model : row->info->models) {
      if (model.maker == maker) {
        models.push_back(model_card(report, engine, model, cables));
      }
    }
    // --models may have left some out
    std::erase_if(models, [](const ModelCard& model) { return model.setups.empty(); });
    if (!models.empty()) {
      card.makers.push_back(maker_card(report, engine, maker, std::move(models)));
      card.verdicts.add(card.makers.back().verdicts);
    }
  }
  std::copy_if(report.findings.begin(), report.findings.end(), std::back_inserter(card.findings),
               [&](const Finding& finding) { return finding.engine == engine; });
  return card;
}

std::vector<Scorecard> scorecards(const Report& report) {
  std::set<std::string> names;
  for (const RunRow& run : report.runs) {
    if (run.key.engine != control) {
      names.insert(run.key.engine);
    }
  }
  return listed(names, [&](const std::string& name) { return scorecard(report, name); });
}

const char* words_of(Maker maker) {
  constexpr std::array words = {"as shipped", "made by hand", "tautline’s driver"};
  return words.at(static_cast<std::size_t>(maker));
}

}  // namespace tautline::bench
