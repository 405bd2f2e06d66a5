#include "bench/report/scorecard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/statistics.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/plot/svg.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/words.hpp"

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

std::vector<Column> columns_of() {
  return {word_column("engine", "engine"),
          word_column("version", ""),
          word_column("cable", "maker"),
          word_column("restitution at impacts", "restitution"),
          word_column("verdict", "verdict"),
          word_column("use", "use"),
          number_column("step", "s", "", "step"),
          number_column("off", "%", "", "off"),
          number_column("cost", "ms/s", "", "cost"),
          word_column("found", "")};
}

std::optional<double> percent(const std::optional<Setup>& use) {
  return use && use->off ? std::optional(100.0 * *use->off) : std::nullopt;
}

/// Processor time of a simulated second [ms/s].
std::optional<double> cost_of(const std::optional<Setup>& use) {
  return use && use->cost ? std::optional(1e3 * use->cost->second_cost) : std::nullopt;
}

/// The model to use; where none rebounds rightly, that, and which is nearest.
Cell use_cell(const MakerCard& of) {
  if (!of.use) {
    return "none";
  }
  return word_cell((of.use_is_right ? "" : "none; nearest: ") + of.use->model);
}

Row row_of(const Scorecard& card, const MakerCard& of) {
  Cell found = sentence_cell(fmt::format("{}", fmt::join(findings_texts(card, of), "; ")));
  if (found.text.empty()) {
    found.text = "nothing";
  }
  return {{word_cell(card.engine), word_cell(card.version + ", " + card.precision),
           words_of(of.maker), sentence_cell(rebounds_text(of)), tally_cell(of.verdicts),
           use_cell(of), number_cell(of.use ? std::optional(of.use->step) : std::nullopt, as_count),
           brief_cell(percent(of.use)), brief_cell(cost_of(of.use)), std::move(found)},
          "",
          ""};
}

// Both schemes in one file: what shows it decides. The colours are the page's.
constexpr const char* card_style =
    "<style>.b{fill:#fdfcf9;stroke:#d6d1c7}.i{fill:#1c1b19}.m{fill:#66625b}.pass{fill:#2c6144}"
    ".breaks-a-limit{fill:#9c3a14}.known-deviation{fill:#7a5200}.not-judged{fill:#66625b}"
    "text{font-family:'Helvetica Neue',Arial,'Liberation Sans',sans-serif}"
    "@media (prefers-color-scheme:dark){.b{fill:#17181a;stroke:#3d3e41}.i{fill:#e4e1da}"
    ".m{fill:#a09b91}.pass{fill:#86c5a0}.breaks-a-limit{fill:#eb9468}"
    ".known-deviation{fill:#e0b643}.not-judged{fill:#a09b91}}</style>\n";

/// Names longer than this leave the card [bytes].
constexpr std::size_t longest_name = 24;
constexpr std::size_t longest_model = 21;

std::string name_of(const std::string& text) { return xml_text(printable(text, longest_name)); }

std::string line(int y, int size, const char* look, const std::string& xml, int x = 16) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" class=\"{}\">{}</text>\n", x, y,
                     size, look, xml);
}

/// A number with its meaning in two lines below, in one of three columns.
std::string number(int column, const std::string& value, const std::string& meaning,
                   const std::string& more) {
  const int x = 16 + 128 * column;
  return line(112, 20, "i", value, x) + line(132, 11, "m", meaning, x) +
         line(147, 11, "m", more, x);
}

/// What the card speaks of: what is shipped, or else what comes first.
const MakerCard* spoken_of(const Scorecard& card) {
  return card.makers.empty() ? nullptr : &card.makers.front();
}

std::string numbers(const Report& report, const MakerCard& card) {
  const auto right = std::count_if(card.models.begin(), card.models.end(),
                                   [](const ModelCard& model) { return model.rebounds_rightly(); });
  std::string out = number(0, fmt::format("{} of {}", right, card.models.size()), "models rebound",
                           std::string("rightly, ") + words_of(card.maker));
  const std::string unit = is_nondimensional(report) ? "unit of time" : "simulated s";
  if (!card.use || !card.use->off) {
    return out + number(1, dash, "no error", "was measured");
  }
  const Setup& use = *card.use;
  out += number(1, percent_text(*use.off), "of a cable’s length off,",
                fmt::format("step {:g}", use.step));
  return out + number(2, use.cost ? fmt::format("{:.2g} ms", 1e3 * use.cost->second_cost) : dash,
                      "a " + unit + ", with", xml_text(printable(use.model, longest_model)));
}

/// A model and the engine it is of.
struct ModelRow {
  std::string engine;
  ModelCard card;
};

/// Those that break a limit first, then known deviations; within these what was found first.
std::vector<ModelRow> models_of(const std::vector<Scorecard>& cards) {
  std::vector<ModelRow> rows;
  for (const Scorecard& card : cards) {
    for (const MakerCard& maker : card.makers) {
      for (const ModelCard& model : maker.models) {
        rows.push_back({card.engine, model});
      }
    }
  }
  const auto urgency = [](const ModelRow& row) {
    const Tally& tally = row.card.verdicts;
    return std::tuple(tally.of(Word::breaks_limit), tally.of(Word::known_deviation),
                      row.card.wrong.size(), tally.of(Word::not_judged));
  };
  std::stable_sort(rows.begin(), rows.end(), [&](const ModelRow& one, const ModelRow& two) {
    return urgency(one) > urgency(two);
  });
  return rows;
}

std::string rebound_text(const ModelCard& card) {
  if (!card.wrong.empty()) {
    return fmt::format("wrong: {}", fmt::join(listed(card.wrong, kind_in_words), ", "));
  }
  return card.impacts == 0 ? "not measured" : "right";
}

/// At the smallest step, where the model is at its best.
Row row_of(const ModelRow& row) {
  const Setup& setup = row.card.setups.back();
  const auto cost = setup.cost ? std::optional(1e3 * setup.cost->second_cost) : std::nullopt;
  return {
      {word_cell(row.engine), word_cell(row.card.model), words_of(row.card.maker),
       tally_text(row.card.verdicts), sentence_cell(rebound_text(row.card)),
       number_cell(setup.step, as_count),
       brief_cell(setup.off ? std::optional(100.0 * *setup.off) : std::nullopt), brief_cell(cost)},
      "",
      ""};
}

Table table_of(const std::vector<ModelRow>& rows) {
  Table table({word_column("engine", ""), word_column("model", ""), word_column("cable", ""),
               word_column("verdict", ""), word_column("restitution", ""),
               number_column("step", "s", "", ""), number_column("off", "%", "", ""),
               number_column("cost", "ms/s", "", "")});
  for (std::size_t index = 0; index < std::min(rows.size(), most_summary_rows); ++index) {
    table.add(row_of(rows[index]));
  }
  return table;
}

std::string verdict_line(const std::vector<Scorecard>& cards) {
  Tally all;
  for (const Scorecard& card : cards) {
    all.add(card.verdicts);
  }
  return fmt::format("**{}**: {}\n", to_string(all.worst()), sentence_of(all));
}

std::string scope_line(const Report& report, std::size_t engines) {
  const std::vector<std::string> steps =
      listed(report.options.steps, [](double step) { return number_text(step, as_count); });
  return fmt::format(
      "\n{} on {}, at steps {} s, each run compared with the exact motion by tautline {}{}.\n\n",
      counted(report.cases.size(), "case"), counted(engines, "engine"), joined(steps, "and"),
      markdown_text(printable(report.version)), report.complete ? "" : " (INCOMPLETE)");
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

const char* words_of(Origin origin) {
  constexpr std::array words = {"the engine’s default", "its demo’s", "ours"};
  return words.at(static_cast<std::size_t>(origin));
}

std::string kind_in_words(std::string kind) {
  std::replace(kind.begin(), kind.end(), '-', ' ');
  return kind;
}

Cell brief_cell(const std::optional<double>& value) {
  Cell cell = number_cell(value, as_error);
  cell.text = value ? fmt::format("{:.2g}", *value) : cell.text;
  return cell;
}

Table scorecards_table(const Report& report) {
  Table table(columns_of());
  for (const Scorecard& card : scorecards(report)) {
    for (const MakerCard& of : card.makers) {
      table.add(row_of(card, of));
    }
  }
  return table;
}

std::string how_to_read_scorecards() {
  return fmt::format(
      "Engines are in alphabetical order. *Cable*: whose it is. **As shipped** is a joint, a "
      "limit, a contact or a solver that the engine has; **made by hand** is built with the "
      "engine's parts; with **tautline's driver** the engine flies and solves, and tautline finds "
      "the instants. *Use*: the most accurate model at the largest step whose error is up to {:g} "
      "%, among those that rebound rightly and have no failed run. *Off*: its position error over "
      "the first impacts, of the shortest cable's length, median over the cases. *Cost*: processor "
      "time of a simulated second. *Verdict*: the worst of all runs, and how many have it.",
      100.0 * good_enough);
}

std::string rebounds_text(const MakerCard& card) {
  std::vector<std::string> right;
  std::vector<std::string> wrong;
  for (const ModelCard& model : card.models) {
    if (!model.wrong.empty()) {
      wrong.push_back(model.model);
    } else if (model.impacts > 0) {
      right.push_back(model.model);
    }
  }
  if (right.empty()) {
    return wrong.empty() ? "not measured" : "wrong";
  }
  return wrong.empty()
             ? "right"
             : fmt::format("right in {}; wrong in {}", joined(right, "and"), joined(wrong, "and"));
}

std::vector<std::string> findings_texts(const Scorecard& card, const MakerCard& of) {
  std::vector<std::string> texts;
  for (const ModelCard& model : of.models) {
    std::vector<std::string> kinds;
    for (const Finding& finding : card.findings) {
      if (finding.model == model.model) {
        kinds.push_back(kind_in_words(finding.kind));
      }
    }
    if (!kinds.empty()) {
      texts.push_back(fmt::format("{}: {}", model.model, fmt::join(kinds, ", ")));
    }
  }
  return texts;
}

std::string percent_text(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

std::string card_svg(const Report& report, const std::string& engine) {
  const Scorecard card = scorecard(report, engine);
  const std::string verdict = tally_text(card.verdicts);
  std::string out = svg_start(
      400, 176, fmt::format(" aria-label=\"{}: {}\"", name_of(engine), xml_text(verdict)));
  out += card_style;
  out += "<rect class=\"b\" x=\"0.5\" y=\"0.5\" width=\"399\" height=\"175\" rx=\"4\"/>\n";
  out += line(34, 22, "i", name_of(engine));
  out += line(52, 12, "m", name_of(card.version) + ", " + name_of(card.precision));
  const bool all = card.verdicts.of(card.verdicts.worst()) == card.verdicts.runs();
  out += line(76, 15, word_look(card.verdicts.worst()).c_str(),
              xml_text(verdict) + (all ? "" : " runs"));
  if (const MakerCard* const of = spoken_of(card)) {
    out += numbers(report, *of);
  }
  out += line(167, 10, "m",
              fmt::format("slack cables, {}, against the exact motion by tautline {}",
                          counted(report.cases.size(), "case"), name_of(report.version)));
  return out + "</svg>\n";
}

std::string card_name(const std::string& engine) {
  std::string name = folder_name(engine).string();
  std::replace(name.begin(), name.end(), '/', '-');
  return "card-" + name + ".svg";
}

std::string summary_markdown(const Report& report) {
  const std::vector<Scorecard> cards = scorecards(report);
  const std::vector<ModelRow> rows = models_of(cards);
  std::string out = verdict_line(cards) + scope_line(report, cards.size());
  if (rows.empty()) {
    return out + "No engine has a run.\n";
  }
  out += table_of(rows).markdown();
  if (rows.size() > most_summary_rows) {
    out += fmt::format("\nand {}, in report.md and index.html.\n",
                       counted(rows.size() - most_summary_rows, "further model"));
  }
  out +=
      "\n*off*: position error over the first impacts, of the shortest cable's length, median "
      "over the cases; *cost*: processor time of a simulated second; both at the smallest "
      "step.\n";
  return out;
}

}  // namespace tautline::bench
