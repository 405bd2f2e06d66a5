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

#include "bench/base/document.hpp"
#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/statistics.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/judge/models.hpp"
#include "bench/plot/svg.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/words.hpp"
#include "tautline_bench_report_words.inc"

namespace tautline::bench {
namespace {

using namespace fmt::literals;

constexpr std::array makers_in_order = {Maker::engine, Maker::by_hand, Maker::tautline};

/// The shortest cable of each case [m].
std::map<std::string, double> shortest_cables(const Report& report) {
  std::map<std::string, double> result;
  for (const CaseRow& the_case : report.cases) {
    const auto note = [&](double length) {
      const auto [place, added] = result.try_emplace(the_case.name, length);
      place->second = std::min(place->second, length);
    };
    for (const CableRow& cable : the_case.geometry()) {
      note(cable.length);
    }
    for (const SystemCableRow& cable :
         the_case.system ? the_case.system->cables : std::vector<SystemCableRow>()) {
      note(cable.length);
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
  const CostRow* const found = find_by(report.context.costs, &CostRow::key, key);
  return found != nullptr ? std::optional(*found) : std::nullopt;
}

bool has_problem(const RunRow* run) { return run->verdict && !run->verdict->problems.empty(); }

/// The faults of a model, the gravest first: runs that fail, its rebounds, its course, what
/// else its impacts do, impacts that it misses, cables and energy.
std::vector<std::string> wrongs(const Report& report, const ModelCard& card, std::size_t failed) {
  std::vector<std::string> out;
  if (failed > 0) {
    out.push_back(fmt::format("{} fail{}", counted(failed, "run"), failed == 1 ? "s" : ""));
  }
  if (!card.judged) {
    return out;
  }
  const ModelJudgement& judged = *card.judged;
  if (judged.rebounds.wrong()) {
    out.push_back("restitution " + words_of(judged.rebounds));
  }
  if (judged.ratio && *judged.ratio > most_ratio && judged.course != Course::as_good) {
    out.push_back(words_of(judged.course, judged.ratio));
  }
  for (const Finding& finding : report.findings) {
    if (finding.engine == card.engine && finding.model == card.model && is_problem(finding.kind)) {
      out.push_back(finding.sentence);
    }
  }
  if (judged.impacts.missed > 0) {
    out.push_back(fmt::format("misses {} of {}", judged.impacts.missed,
                              counted(judged.impacts.due, "impact")));
  }
  if (judged.overstretch > most_overstretch) {
    out.push_back(
        fmt::format("overstretches by {:.2g} times what a step explains", judged.overstretch));
  }
  if (judged.energy > most_energy) {
    out.push_back(
        fmt::format("gains energy in flight, {:.2g} times what a step explains", judged.energy));
  }
  if (judged.flight > most_flight) {
    out.push_back(flight_text(judged.flight));
  }
  if (judged.rotation.value_or(0.0) > most_rotation) {
    out.push_back(rotation_text(*judged.rotation));
  }
  return out;
}

ModelCard model_card(const Report& report, const std::string& engine, const Model& model,
                     const std::map<std::string, double>& cables) {
  ModelCard card;
  card.engine = engine;
  card.model = model.name;
  card.maker = model.maker;
  std::map<double, Runs, std::greater<>> by_step;
  std::size_t failed = 0;
  card.unsupported = true;
  for (const RunRow& run : report.runs) {
    if (run.key.engine == engine && run.key.model == model.name) {
      by_step[run.key.step].push_back(&run);
      card.verdicts.add(run);
      failed += did_its_work(run.status) ? 0U : 1U;
      card.unsupported = card.unsupported && run.status == Status::unsupported;
      for (const Problem& problem : run.verdict ? run.verdict->problems : std::vector<Problem>()) {
        if (problem.listed && std::find(card.listed.begin(), card.listed.end(), problem.reason) ==
                                  card.listed.end()) {
          card.listed.push_back(problem.reason);
        }
      }
    }
  }
  for (const auto& [step, runs] : by_step) {
    card.setups.push_back(
        {model.name, step, median_off(runs, cables), cost_of(report, {engine, model.name, step})});
  }
  for (const ModelJudgement& judged : report.models) {
    if (judged.engine == engine && judged.model == model.name) {
      card.judged = judged;
    }
  }
  card.wrong = wrongs(report, card, failed);
  // what the finest step over all cases does not show
  for (const auto& [step, runs] : by_step) {
    for (const RunRow* run : runs) {
      if (card.wrong.empty() && has_problem(run)) {
        card.wrong.push_back(
            fmt::format("at {:g} s {}", step, run->verdict->problems.front().sentence));
      }
    }
  }
  return card;
}

/// The setup to use, of those of `models`.
std::optional<Setup> chosen(const std::vector<ModelCard>& models) {
  std::vector<Setup> setups;
  for (const ModelCard& model : models) {
    for (const Setup& setup : model.setups) {
      if (model.may_be_used() && setup.off && *setup.off <= good_enough) {
        setups.push_back(setup);
      }
    }
  }
  const auto less = [](const Setup& one, const Setup& two) {
    return one.step != two.step ? one.step > two.step : *one.off < *two.off;
  };
  const auto best = std::min_element(setups.begin(), setups.end(), less);
  return best != setups.end() ? std::optional(*best) : std::nullopt;
}

/// How grave it is: what is not listed before what is, and of these what is further off.
std::tuple<std::size_t, std::size_t, std::size_t, double> gravity_of(const ModelCard& card) {
  const double ratio = card.judged ? card.judged->ratio.value_or(0.0) : 0.0;
  return {card.verdicts.of(Word::problem), card.verdicts.of(Word::listed_problem),
          card.wrong.size(), ratio};
}

bool graver(const ModelCard& one, const ModelCard& two) {
  return gravity_of(one) > gravity_of(two);
}

/// "Use row at 0.001 s: 0.61 % of a cable off, 0.4 ms of processor time a second."
std::string use_sentence(const Scorecard& card) {
  if (!card.use) {
    const bool kept = std::any_of(card.models.begin(), card.models.end(),
                                  [](const ModelCard& model) { return model.may_be_used(); });
    return kept ? fmt::format(
                      "No model without a problem is within {:g} % of a cable at these steps.",
                      100.0 * good_enough)
                : "None of its models can be recommended from these runs.";
  }
  std::string out = fmt::format("Use {} at {:g} s", printable(card.use->model), card.use->step);
  constexpr double rounding = 1e-9;  // [-], of a cable
  out += *card.use->off < rounding
             ? ": exact to rounding"
             : fmt::format(": {} of a cable off", percent_text(*card.use->off));
  return out + (card.use->cost
                    ? fmt::format(", {:.2g} ms a second.", 1e3 * card.use->cost->second_cost)
                    : ".");
}

std::vector<Column> columns_of() {
  return {word_column("engine", "engine"),
          word_column("model", "model"),
          word_column("cable", "maker"),
          word_column("restitution", "restitution"),
          word_column("position, against a plain correct scheme", "position"),
          word_column("verdict", "verdict"),
          number_column("step", "s", "", "step"),
          number_column("off", "%", "", "off"),
          number_column("cost", "ms/s", "", "cost")};
}

std::optional<double> percent(const std::optional<double>& share) {
  return share ? std::optional(100.0 * *share) : std::nullopt;
}

/// Processor time of a simulated second [ms/s].
std::optional<double> cost_of(const Setup& setup) {
  return setup.cost ? std::optional(1e3 * setup.cost->second_cost) : std::nullopt;
}

/// A cell with a look: of what is wrong, of what is well, or of what cannot be told.
Cell told_cell(std::string text, bool wrong, bool well) {
  Cell cell = sentence_cell(text);
  const Word word = wrong ? Word::problem : well ? Word::sound : Word::too_few;
  cell.kind = "told " + word_look(word);
  cell.colour = colour_of(word);
  return cell;
}

Cell restitution_cell(const ModelCard& card) {
  if (!card.judged) {
    return dash;
  }
  const Rebounds& rebounds = card.judged->rebounds;
  return told_cell(words_of(rebounds), rebounds.wrong(), rebounds.well());
}

Cell position_cell(const ModelCard& card) {
  if (!card.judged) {
    return dash;
  }
  const Course course = card.judged->course;
  const bool well = course == Course::exact || course == Course::as_good;
  Cell cell =
      told_cell(words_of(course, card.judged->ratio), !well && course != Course::untold, well);
  if (card.judged->ratio) {
    cell.notes.push_back(fmt::format(
        "{:.2g} times at worst, {:.2g} m at {:.3g} s in {}; told in {} of {}", *card.judged->ratio,
        card.judged->error, card.judged->time, printable(card.judged->worst_case),
        card.judged->told, counted(card.judged->cases, "case")));
  }
  return cell;
}

/// The worst verdict, and why problems are listed.
Cell verdict_cell(const ModelCard& card) {
  Cell cell = tally_cell(card.verdicts);
  for (const std::string& reason : card.listed) {
    cell.notes.push_back(printable(reason, longest_sentence));
  }
  return cell;
}

Row row_of(const ModelCard& card) {
  const Setup& finest = card.setups.back();
  return {
      {word_cell(card.engine), word_cell(card.model), words_of(card.maker), restitution_cell(card),
       position_cell(card), verdict_cell(card), number_cell(finest.step, as_count),
       brief_cell(percent(finest.off)), brief_cell(cost_of(finest))},
      "",
      ""};
}

Table table_of(const std::vector<ModelCard>& models) {
  Table table(columns_of());
  for (const ModelCard& model : models) {
    table.add(row_of(model));
  }
  return table;
}

/// The models of all engines, those of an engine one after the other.
std::vector<ModelCard> models_of_all(const std::vector<Scorecard>& cards) {
  std::vector<ModelCard> models;
  for (const Scorecard& card : cards) {
    models.insert(models.end(), card.models.begin(), card.models.end());
  }
  return models;
}

// Both schemes in one file: what shows it decides. The colours are the page's.
constexpr const char* card_style =
    "<style>.b{fill:#fdfcf9;stroke:#d6d1c7}.i{fill:#1c1b19}.m{fill:#66625b}.sound{fill:#2c6144}"
    ".problem{fill:#9c3a14}.listed-problem{fill:#7a5200}.too-few-to-tell{fill:#66625b}"
    "text{font-family:'Helvetica Neue',Arial,'Liberation Sans',sans-serif}"
    "@media (prefers-color-scheme:dark){.b{fill:#17181a;stroke:#3d3e41}.i{fill:#e4e1da}"
    ".m{fill:#a09b91}.sound{fill:#86c5a0}.problem{fill:#eb9468}"
    ".listed-problem{fill:#e0b643}.too-few-to-tell{fill:#a09b91}}</style>\n";

constexpr std::size_t longest_name = 24;  // longer ones leave the card [bytes]
constexpr std::size_t card_line = 58;     // the same of a line of sentences
constexpr std::size_t card_lines = 5;

std::string name_of(const std::string& text) { return xml_text(printable(text, longest_name)); }

std::string line(int y, int size, const std::string& look, const std::string& xml) {
  return fmt::format("<text x=\"16\" y=\"{}\" font-size=\"{}\" class=\"{}\">{}</text>\n", y, size,
                     look, xml);
}

/// The word on an engine: that of the models that it ships, as its maintainer asks for them first;
/// of another, of all.
Word word_of(const Scorecard& card) {
  Tally shipped;
  for (const ModelCard& model : card.models) {
    if (model.maker == Maker::engine) {
      shipped.add(model.verdicts);
    }
  }
  return (shipped.runs() > 0 ? shipped : card.verdicts).worst();
}

std::string scope_line(const Report& report, std::size_t engines) {
  const std::vector<std::string> steps =
      listed(report.options.steps, [](double step) { return number_text(step, as_count); });
  return fmt::format(
      "{} on {}, at steps {} s, each run judged from the exact motion of its case by tautline "
      "{}{}.",
      counted(report.cases.size(), "case"), counted(engines, "engine"), joined(steps, "and"),
      markdown_text(printable(report.version)), report.complete ? "" : " (INCOMPLETE)");
}

}  // namespace

bool ModelCard::may_be_used() const {
  return wrong.empty() && judged && judged->rebounds.well() &&
         (judged->course == Course::exact || judged->course == Course::as_good);
}

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
    for (const Model& model : row->info->models) {
      if (model.maker == maker) {
        card.models.push_back(model_card(report, engine, model, cables));
      }
    }
  }
  // --models may have left some out
  std::erase_if(card.models, [](const ModelCard& model) { return model.setups.empty(); });
  for (const ModelCard& model : card.models) {
    card.verdicts.add(model.verdicts);
  }
  card.use = chosen(card.models);
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

std::vector<Scorecard> worst_first_scorecards(const Report& report) {
  std::vector<Scorecard> cards = scorecards(report);
  const auto worst_of = [](const Scorecard& card) {
    const auto worst = std::min_element(card.models.begin(), card.models.end(), graver);
    return worst != card.models.end() ? gravity_of(*worst) : decltype(gravity_of(*worst))();
  };
  std::stable_sort(cards.begin(), cards.end(), [&](const Scorecard& one, const Scorecard& two) {
    return worst_of(one) > worst_of(two);
  });
  return cards;
}

EngineWords words_of(const Scorecard& card) {
  std::vector<ModelCard> wrong;
  std::size_t kept = 0;
  std::size_t unsupported = 0;
  for (const ModelCard& model : card.models) {
    kept += model.may_be_used() ? 1U : 0U;
    unsupported += model.unsupported ? 1U : 0U;
    if (!model.wrong.empty()) {
      wrong.push_back(model);
    }
  }
  std::stable_sort(wrong.begin(), wrong.end(), graver);
  EngineWords out;
  out.advice = use_sentence(card);
  const Word worst = card.verdicts.worst();
  if (worst == Word::problem || worst == Word::listed_problem) {
    out.word = worst;
  }
  if (!wrong.empty()) {
    out.model = wrong.front().model;
    out.fault = fmt::format("{}: {}", printable(out.model),
                            printable(wrong.front().wrong.front(), longest_sentence));
    out.fault += wrong.size() > 1 ? fmt::format("; {} of {} models have a problem.", wrong.size(),
                                                card.models.size())
                                  : ".";
    return out;
  }
  out.model = card.use ? card.use->model : card.models.empty() ? "" : card.models.front().model;
  const std::size_t done = card.models.size() - unsupported;
  if (kept == done && kept > 0) {
    out.word = out.word == Word::too_few ? Word::sound : out.word;
    out.fault = fmt::format("No problem found in {}.", counted(kept, "model"));
  } else if (done > 0) {
    out.fault =
        fmt::format("Too few impacts to judge {} of {}.", done - kept, counted(done, "model"));
  }
  if (unsupported > 0) {
    out.fault +=
        fmt::format("{}{} not supported here.", done > 0 ? " " : "",
                    unsupported == 1 ? "1 model is" : fmt::format("{} models are", unsupported));
  }
  return out;
}

std::string sentence_of(const Scorecard& card) {
  const EngineWords words = words_of(card);
  return words.fault + " " + words.advice;
}

const char* words_of(Maker maker) {
  constexpr std::array words = {"as shipped", "made by hand", "tautline’s driver"};
  return words.at(static_cast<std::size_t>(maker));
}

const char* words_of(Origin origin) {
  constexpr std::array words = {"the engine’s default", "its demo’s", "ours"};
  return words.at(static_cast<std::size_t>(origin));
}

Cell brief_cell(const std::optional<double>& value) {
  Cell cell = number_cell(value, as_error);
  cell.text = value ? fmt::format("{:.2g}", *value) : cell.text;
  return cell;
}

Table models_table(const Report& report) { return table_of(models_of_all(scorecards(report))); }

std::string how_to_read_models() {
  return fmt::format(words::how_to_read_models, "good_enough"_a = 100.0 * good_enough);
}

std::string percent_text(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

std::string card_svg(const Report& report, const std::string& engine) {
  const Scorecard card = scorecard(report, engine);
  const Word word = word_of(card);
  const std::string sentence = sentence_of(card);
  std::string out = svg_start(
      400, 176, fmt::format(" aria-label=\"{}: {}\"", name_of(engine), xml_text(sentence)));
  out += card_style;
  out += "<rect class=\"b\" x=\"0.5\" y=\"0.5\" width=\"399\" height=\"175\" rx=\"4\"/>\n";
  out += line(32, 20, "i", name_of(engine));
  out += line(49, 12, "m", name_of(card.version) + ", " + name_of(card.precision));
  int y = 72;
  std::size_t lines = 0;
  const std::string folded = wrapped(sentence, card_line);
  for (std::size_t start = 0; start < folded.size() && lines < card_lines; ++lines) {
    const std::size_t end = std::min(folded.find('\n', start), folded.size());
    out += line(y, 13, lines == 0 ? word_look(word) : "i",
                xml_text(folded.substr(start, end - start)));
    y += 17;
    start = end + 1;
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
  const std::vector<Scorecard> cards = worst_first_scorecards(report);
  Document out;
  out.list(listed(cards, [](const Scorecard& card) {
    return fmt::format("**{}**: {}", verbatim(card.engine), markdown_text(sentence_of(card)));
  }));
  out.paragraph(scope_line(report, cards.size()));
  std::vector<ModelCard> models = models_of_all(cards);
  if (models.empty()) {
    return out.paragraph("No engine has a run.").markdown();
  }
  std::stable_sort(models.begin(), models.end(), graver);
  const std::size_t all = models.size();
  models.resize(std::min(all, most_summary_rows));
  out.table(table_of(models), "", "");
  if (all > most_summary_rows) {
    out.paragraph(fmt::format("and {}, in report.md and index.html.",
                              counted(all - most_summary_rows, "further model")));
  }
  return out.paragraph(how_to_read_models()).markdown();
}

}  // namespace tautline::bench
