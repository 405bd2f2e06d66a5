#include "tautline/case_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "bench/base/problems.hpp"
#include "bench/base/strict_table.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "bench/cases/case_form.hpp"
#include "bench/cases/case_json.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// A cable, and whether it starts taut.
std::pair<Cable, bool> read_cable(StrictTable& table) {
  Cable cable;
  cable.anchor = table.pair({"anchor", "the end in the world, x and y"}, "[m]");
  cable.attachment = table.pair(
      {"attachment", "the end on the body, from its centre of mass, in the body's frame"}, "[m]");
  cable.length =
      table.number({"length", "the length at which the cable is taut"}, above_zero, "[m]");
  cable.restitution = table.number(
      {"restitution", "the share of its closing rate with which the cable opens after an impact"},
      zero_to_one, "");
  cable.capture_speed =
      table
          .optional_number(
              {"capture_speed", "an impact slower than this has no rebound; default 0"},
              zero_or_above, "[m/s]")
          .value_or(0.0);
  const Key by_speed = {"restitution_table",
                        "replaces restitution: pairs of speed and restitution, in rising speed"};
  for (const Vec2& point : table.pairs(by_speed, "[speed, restitution]", "[m/s, -]")) {
    cable.restitution_table.push_back({point.x(), point.y()});
  }
  const bool taut = table.flag(
      {"taut", "true moves the body by the little that the typed digits leave to a taut cable"});
  table.refuse_unknown_keys();
  return {std::move(cable), taut};
}

Body read_body(StrictTable table) {
  Body body;
  body.mass = table.number({"mass", "the mass"}, above_zero, "[kg]");
  body.inertia = table.number({"inertia", "about the centre of mass; 0 makes a point mass"},
                              zero_or_above, "[kg m^2]");
  table.refuse_unknown_keys();
  return body;
}

State read_initial(StrictTable table) {
  State state;
  state.position = table.pair({"position", "of the centre of mass, x and y"}, "[m]");
  state.angle = table.optional_number({"angle", "anticlockwise; default 0"}, any_number, "[rad]")
                    .value_or(0.0);
  state.velocity =
      table.optional_pair({"velocity", "of the centre of mass, x and y; default 0"}, "[m/s]")
          .value_or(Vec2(Vec2::Zero()));
  state.spin = table.optional_number({"spin", "anticlockwise; default 0"}, any_number, "[rad/s]")
                   .value_or(0.0);
  table.refuse_unknown_keys();
  return state;
}

/// A case; adds its cables that start taut to `taut`.
Case read_tables(StrictTable root, CableSet& taut) {
  const std::string cables_right =
      "must be 1 to " + std::to_string(max_cables) +
      " tables [[cables]], each with anchor, attachment, length and restitution";
  Case result;
  result.name = root.text({"name", "the name in tables and files"});
  result.duration = root.number({"duration", "the run ends at this time"}, above_zero, "[s]");
  result.gravity = root.pair({"gravity", "the acceleration, x and y"}, "[m/s^2]");
  result.angle_limit = root.optional_number(
      {"angle_limit", "the run ends when the body has turned to this angle, to either side"},
      above_zero, "[rad]");
  result.ceiling = root.optional_number(
      {"ceiling", "the run ends when an attachment rises to this height"}, any_number, "[m]");
  result.body = read_body(root.table({"body", "the rigid body"}));
  const Key cables = {"cables", "1 to 8 cables without mass, slack or taut"};
  for (StrictTable& table : root.tables(cables, max_cables, cables_right)) {
    auto [cable, starts_taut] = read_cable(table);
    if (starts_taut) {
      taut.insert(result.cables.size());
    }
    result.cables.push_back(std::move(cable));
  }
  result.initial = read_initial(root.table({"initial", "the start, at t = 0"}));
  root.refuse_unknown_keys();
  return result;
}

/// `the_case` with `taut` cables long enough for its start: what else is wrong with it?
std::vector<std::string> other_problems(Case the_case, CableSet taut) {
  for (const std::size_t index : taut) {
    Cable& cable = the_case.cables[index];
    cable.length = std::max(cable.length, cable.length - gap(cable, the_case.initial));
  }
  return problems(the_case);
}

/// True where no cable is overstretched by more than `taut = true` takes up.
bool near_taut(const Case& the_case) {
  return std::all_of(the_case.cables.begin(), the_case.cables.end(), [&](const Cable& cable) {
    return gap(cable, the_case.initial) >= -most_taken_up * cable.length;
  });
}

/// How the start of a case was changed, in a sentence; none where it was not.
std::vector<std::string> note_of(const TautStart& found, CableSet taut) {
  std::string words;
  const auto add = [&](const char* what, double by, const char* unit) {
    if (by > 0.0) {
      std::array<char, 32> digits{};
      const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), by,
                                     std::chars_format::general, 2);
      words += std::string(words.empty() ? "" : ", ") + what + " by " +
               std::string(digits.data(), end.ptr) + " " + unit;
    }
  };
  add("position", found.moved, "m");
  add("angle", found.turned, "rad");
  add("velocity", found.slowed, "m/s");
  add("spin", found.spun, "rad/s");
  if (words.empty()) {
    return {};
  }
  std::vector<std::string> names;
  for (const std::size_t index : taut) {
    names.push_back(std::to_string(index));
  }
  const bool one = names.size() == 1;
  return {(one ? "cable " : "cables ") + joined(names, "and") + (one ? " starts" : " start") +
          " taut: the start changes its " + words};
}

/// The line a sentence of `tautline::problems` is about: "cable 2: ..." or "body: inertia ...".
std::size_t line_of_problem(const toml::table& file, const std::string& sentence) {
  if (sentence.starts_with("cable")) {
    const std::size_t digits = std::min(sentence.find_first_of("0123456789"), sentence.size());
    std::size_t index = 0;
    std::from_chars(sentence.data() + digits, sentence.data() + sentence.size(), index);
    return line_of(file["cables"][index].node());
  }
  const std::size_t colon = std::min(sentence.find(": "), sentence.size());
  const std::string table = sentence.substr(0, colon);
  const std::string rest = sentence.substr(std::min(colon + 2, sentence.size()));
  const toml::node* key = file[table][rest.substr(0, rest.find(' '))].node();
  return line_of(key != nullptr ? key : file[table].node());
}

}  // namespace

Form case_form() {
  Form form;
  CableSet taut;
  static_cast<void>(read_tables(StrictTable(form), taut));
  return form;
}

}  // namespace tautline::bench

namespace tautline {

StartChange start_taut(Case& the_case, CableSet taut) {
  StartChange result;
  for (const std::size_t index : taut) {
    if (index >= the_case.cables.size()) {
      const std::size_t count = the_case.cables.size();
      result.problems.push_back("cable " + std::to_string(index) +
                                " cannot start taut: the case has " + std::to_string(count) +
                                (count == 1 ? " cable" : " cables"));
    }
  }
  if (!taut.empty() && result.problems.empty()) {
    result.problems = bench::other_problems(the_case, taut);
  }
  if (taut.empty() || !result.problems.empty()) {
    return result;
  }
  TautStart found = taut_start(the_case, taut);
  result.problems = std::move(found.problems);
  if (found.start) {
    the_case.initial = *found.start;
    result.notes = bench::note_of(found, taut);
  }
  return result;
}

CaseReading read_case_text(std::string_view text, const std::string& source_name, CableSet taut) {
  bench::FileProblems wrong(source_name);
  const std::optional<toml::table> file =
      bench::is_json(text) ? bench::parse_json(text, wrong) : bench::parse_toml(text, wrong);
  if (!file) {
    return {std::nullopt, wrong.sentences()};
  }
  Case the_case = bench::read_tables(bench::StrictTable(&*file, "", wrong), taut);
  bench::FileProblems notes(source_name);
  if (wrong.empty()) {  // rules that tie several keys together
    StartChange change = start_taut(the_case, taut);
    for (const std::string& sentence : change.notes) {
      notes.add(bench::line_of((*file)["initial"].node()), sentence);
    }
    if (change.problems.empty()) {
      change.problems = problems(the_case);
    }
    for (const std::string& sentence : change.problems) {
      const bool typed =
          sentence.find(": overstretched") != std::string::npos && bench::near_taut(the_case);
      wrong.add(bench::line_of_problem(*file, sentence),
                sentence + (typed ? ", or taut = true, which moves the start" : ""));
    }
  }
  if (!wrong.empty()) {
    return {std::nullopt, wrong.sentences()};
  }
  return {std::move(the_case), {}, notes.sentences()};
}

}  // namespace tautline
