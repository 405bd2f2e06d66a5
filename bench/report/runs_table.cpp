#include "bench/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/judge/models.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

constexpr Digits as_energy = fixed(8);
constexpr Digits as_angle = fixed(5);
constexpr Digits as_restitution = fixed(4);

bool is_shown(const Metric& metric) { return metric.shown != Shown::nowhere; }

/// A report without elastic cables has none of them.
std::vector<Column> contact_columns() {
  const std::string contacts = "contacts to the horizon";
  const std::string peak = "largest tension of a contact";
  const std::string off = "contacts off by";
  return {number_column("matched", "", contacts, "contacts-matched"),
          number_column("exact", "", contacts, "contacts-exact"),
          number_column("found", "", contacts, "contacts-found"),
          number_column("exact", "N", peak, "contact-peak-exact"),
          number_column("found", "N", peak, "contact-peak-found"),
          number_column("largest tension", "%", off, "contact-peak-error"),
          number_column("impulse", "%", off, "contact-impulse-error"),
          number_column("duration", "%", off, "contact-time-error"),
          number_column("e", "", off, "contact-restitution-error")};
}

std::vector<Column> columns_of(const Report& report, bool with_case) {
  std::vector<Column> columns = setup_columns();
  if (with_case) {
    columns.insert(columns.begin(), {word_column("case", "case"), word_column("title", "title")});
  }
  if (report.listed) {
    columns.push_back(word_column("verdict", "verdict"));
  }
  for (const Metric& metric : metric_list()) {
    if (is_shown(metric)) {
      columns.push_back(number_column(std::string(metric.heading), shown_unit(metric),
                                      std::string(metric.group), column_key(metric)));
    }
  }
  const std::string impacts = "impacts to the horizon";
  const std::string last = last_impact_heading(report);
  const std::string energy = "swing energy";
  const std::string amplitude = "swing amplitude";
  const std::string restitution = "restitution e";
  const std::vector<Column> others = {
      number_column("matched", "", impacts, "matched"),
      number_column("exact", "", impacts, "exact"),
      number_column("found", "", impacts, "found"),
      number_column("exact", "s", last, "last-impact-exact"),
      number_column("found", "s", last, "last-impact-found"),
      number_column("exact", "J", energy, "swing-energy-exact"),
      number_column("found", "J", energy, "swing-energy-found"),
      number_column("exact", "rad", amplitude, "swing-amplitude-exact"),
      number_column("found", "rad", amplitude, "swing-amplitude-found"),
      number_column("asked", "", restitution, "restitution-asked"),
      number_column("mean", "", restitution, "restitution-mean"),
      number_column("smallest", "", restitution, "restitution-smallest"),
      number_column("largest", "", restitution, "restitution-largest"),
      number_column("cost", "flights", "", "cost"),
      word_column("how it ended", "status")};
  columns.insert(columns.end(), others.begin(), others.end());
  if (report.has_contacts()) {
    const std::vector<Column> contacts = contact_columns();
    columns.insert(columns.end() - 2, contacts.begin(), contacts.end());
  }
  return columns;
}

/// "position: off by ...", or "e none: ..."; "(listed)" after one that is, where another is not.
/// Why it is listed is in the table of models, once.
std::string problem_text(const Problem& problem, Word word) {
  const std::string what = problem.kind == "restitution"      ? "e "
                           : problem.kind == "missed-impacts" ? ""
                                                              : in_words(problem.kind) + ": ";
  return what + printable(problem.sentence, longest_sentence) +
         (problem.listed && word == Word::problem ? " (listed)" : "");
}

/// The word, and below it what is wrong, or what could be read.
Cell verdict_cell(const RunRow& run) {
  if (!run.verdict) {
    return dash;
  }
  Cell cell = to_string(run.verdict->word);
  cell.kind = verdict_kind(run.verdict->word);
  for (const Problem& problem : run.verdict->problems) {
    cell.notes.push_back(problem_text(problem, run.verdict->word));
  }
  if (run.verdict->problems.empty() && run.judgement) {
    // of thousands of runs: few words
    const Following& following = run.judgement->following;
    std::string rebounds = words_of(run.judgement->rebounds);
    if (const std::size_t at = rebounds.find(" impacts"); at != std::string::npos) {
      rebounds.erase(at, std::string_view(" impacts").size());
    }
    cell.notes.push_back("e " + rebounds);
    cell.notes.push_back(
        !following.ratio ? "position untold"
        : *following.ratio <= exact_ratio
            ? fmt::format("exact to {:.3g} s", following.until)
            : fmt::format("{:.2g} × plain to {:.3g} s", *following.ratio, following.until));
  }
  return cell;
}

/// "finished", or the word and why.
Cell ending_cell(const RunRow& run) {
  return sentence_cell(to_string(run.status) + (run.reason.empty() ? "" : ": " + run.reason));
}

void add_pair(std::vector<Cell>& cells, const std::optional<ExactAndFound>& pair, Digits digits) {
  cells.push_back(number_cell(pair ? std::optional(pair->exact) : std::nullopt, digits));
  cells.push_back(number_cell(pair ? std::optional(pair->found) : std::nullopt, digits));
}

void add_last_impact(std::vector<Cell>& cells, const RunDetails& details) {
  const LastImpactMatch last =
      details.last_impacts.empty() ? LastImpactMatch() : details.last_impacts.front();
  cells.push_back(number_cell(last.exact, as_instant));
  cells.push_back(number_cell(last.found, as_instant));
}

void add_restitution(std::vector<Cell>& cells, const std::optional<MeasuredRestitution>& measured) {
  for (const auto number : {&MeasuredRestitution::mean, &MeasuredRestitution::smallest,
                            &MeasuredRestitution::largest}) {
    cells.push_back(
        number_cell(measured ? std::optional((*measured).*number) : std::nullopt, as_restitution));
  }
}

/// What the rows of runs take from elsewhere in the report.
struct Lookup {
  std::map<std::string, std::optional<double>> restitution;  // by case
  std::map<std::string, std::string> title;                  // by case
  std::map<RunKey, double> cost;
  bool has_contacts = false;

  explicit Lookup(const Report& report) : has_contacts(report.has_contacts()) {
    for (const CaseRow& the_case : report.cases) {
      restitution.emplace(the_case.name, the_case.asked_restitution());
      title.emplace(the_case.name, the_case.title);
    }
    for (const TimingRow& timing : report.context.timing) {
      cost.emplace(timing.key, timing.cost_ratio);
    }
  }
  [[nodiscard]] std::optional<double> restitution_of(const RunKey& run) const {
    const auto found = restitution.find(run.the_case);
    return found != restitution.end() ? found->second : std::nullopt;
  }
  [[nodiscard]] std::string title_of(const RunKey& run) const {
    const auto found = title.find(run.the_case);
    return found != title.end() ? found->second : "";
  }
  [[nodiscard]] std::optional<double> cost_of(const RunKey& run) const {
    const auto found = cost.find(run);
    return found != cost.end() ? std::optional(found->second) : std::nullopt;
  }
};

void add_contacts(std::vector<Cell>& cells, const std::optional<ContactMatch>& contacts) {
  if (!contacts) {
    cells.insert(cells.end(), contact_columns().size(), Cell(dash));
    return;
  }
  for (const std::size_t count : {contacts->matched, contacts->exact, contacts->found}) {
    cells.push_back(count_cell(count));
  }
  add_pair(cells, contacts->peak, as_error);
  for (const auto number : {&ContactMatch::peak_error, &ContactMatch::impulse_error,
                            &ContactMatch::time_error, &ContactMatch::restitution_error}) {
    cells.push_back(number_cell((*contacts).*number, as_error));
  }
}

void add_numbers(std::vector<Cell>& cells, const RunRow& run, const Lookup& lookup) {
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    if (is_shown(metric_list()[place])) {
      cells.push_back(number_cell(run.metric(place), metric_list()[place].digits));
    }
  }
  const RunDetails& details = *run.details;
  const RunDetails::OfWindow& horizon = details.in(Window::horizon);
  for (const std::size_t count : {horizon.matched, horizon.exact, horizon.found}) {
    cells.push_back(count_cell(count));
  }
  add_last_impact(cells, details);
  const auto& swing = details.swing;
  add_pair(cells, swing ? std::optional(swing->energy) : std::nullopt, as_energy);
  add_pair(cells, swing ? std::optional(swing->amplitude) : std::nullopt, as_angle);
  cells.push_back(number_cell(lookup.restitution_of(run.key), as_count));
  add_restitution(cells, details.restitution);
  if (lookup.has_contacts) {
    add_contacts(cells, details.contacts);
  }
  cells.push_back(number_cell(lookup.cost_of(run.key), fixed(1)));
}

Row row_of(const Report& report, const RunRow& run, const Lookup& lookup, bool with_case) {
  Row row = {setup_cells(setup_of(run.key)), "", body_of(run.key.engine)};
  row.kind = run.status == Status::finished ? "" : to_string(run.status);
  if (with_case) {
    row.cells.insert(row.cells.begin(),
                     {word_cell(run.key.the_case), word_cell(lookup.title_of(run.key))});
  }
  if (report.listed) {
    row.cells.push_back(verdict_cell(run));
  }
  Cell ending = ending_cell(run);
  if (run.metrics) {
    add_numbers(row.cells, run, lookup);
  } else {
    ending.kind = "reason";
  }
  row.cells.push_back(std::move(ending));
  return row;
}

/// Of one case; of all without one.
Table table_of(const Report& report, const std::string* the_case) {
  const Lookup lookup(report);
  std::vector<Row> rows;
  for (const RunRow& run : report.runs) {
    if (the_case == nullptr || run.key.the_case == *the_case) {
      rows.push_back(row_of(report, run, lookup, the_case == nullptr));
    }
  }
  Table table(columns_of(report, the_case == nullptr));
  add_rows(table, std::move(rows), ControlPlace::after);
  return table;
}

}  // namespace

Table runs_table(const Report& report) { return table_of(report, nullptr); }

Table runs_table(const Report& report, const std::string& the_case) {
  return table_of(report, &the_case);
}

}  // namespace tautline::bench
