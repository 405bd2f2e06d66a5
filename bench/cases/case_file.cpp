#include "tautline/case_file.hpp"

#include <algorithm>
#include <charconv>

#include "bench/base/input_file.hpp"
#include "bench/base/toml/problems.hpp"
#include "bench/base/toml/strict_table.hpp"
#include "bench/base/toml/value.hpp"

namespace tautline::bench {
namespace {

Cable read_cable(StrictTable& table) {
  Cable cable;
  cable.anchor = table.pair("anchor", "[m]");
  cable.attachment = table.pair("attachment", "[m]");
  cable.length = table.number("length", above_zero, "[m]");
  cable.restitution = table.number("restitution", zero_to_one, "");
  cable.capture_speed =
      table.optional_number("capture_speed", zero_or_above, "[m/s]").value_or(0.0);
  for (const Vec2& point : table.pairs("restitution_table", "[speed, restitution]", "[m/s, -]")) {
    cable.restitution_table.push_back({point.x(), point.y()});
  }
  table.refuse_unknown_keys();
  return cable;
}

Body read_body(StrictTable table) {
  Body body;
  body.mass = table.number("mass", above_zero, "[kg]");
  body.inertia = table.number("inertia", zero_or_above, "[kg m^2]");
  table.refuse_unknown_keys();
  return body;
}

State read_initial(StrictTable table) {
  State state;
  state.position = table.pair("position", "[m]");
  state.angle = table.optional_number("angle", any_number, "[rad]").value_or(0.0);
  state.velocity = table.optional_pair("velocity", "[m/s]").value_or(Vec2(Vec2::Zero()));
  state.spin = table.optional_number("spin", any_number, "[rad/s]").value_or(0.0);
  table.refuse_unknown_keys();
  return state;
}

Case read_tables(const toml::table& file, FileProblems& wrong) {
  const std::string cables_right =
      "must be 1 to " + std::to_string(max_cables) +
      " tables [[cables]], each with anchor, attachment, length and restitution";
  StrictTable root(&file, "", wrong);
  Case result;
  result.name = root.text("name");
  result.duration = root.number("duration", above_zero, "[s]");
  result.gravity = root.pair("gravity", "[m/s^2]");
  result.angle_limit = root.optional_number("angle_limit", above_zero, "[rad]");
  result.ceiling = root.optional_number("ceiling", any_number, "[m]");
  result.body = read_body(root.table("body"));
  for (StrictTable& table : root.tables("cables", max_cables, cables_right)) {
    result.cables.push_back(read_cable(table));
  }
  result.initial = read_initial(root.table("initial"));
  root.refuse_unknown_keys();
  return result;
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
}  // namespace tautline::bench

namespace tautline {

CaseReading read_case(const std::filesystem::path& path) {
  const bench::InputFile file = bench::read_input_file(path, longest_case_file);
  if (file.problem) {
    bench::FileProblems wrong(path.native());
    wrong.add(0, *file.problem);
    return {std::nullopt, wrong.sentences()};
  }
  return read_case_text(file.content, path.native());
}

CaseReading read_case_text(std::string_view text, const std::string& source_name) {
  bench::FileProblems wrong(source_name);
  const std::optional<toml::table> file = bench::parse_toml(text, wrong);
  if (!file) {
    return {std::nullopt, wrong.sentences()};
  }
  Case the_case = bench::read_tables(*file, wrong);
  if (wrong.empty()) {  // rules that tie several keys together
    for (const std::string& sentence : problems(the_case)) {
      wrong.add(bench::line_of_problem(*file, sentence), sentence);
    }
  }
  if (!wrong.empty()) {
    return {std::nullopt, wrong.sentences()};
  }
  return {std::move(the_case), {}};
}

}  // namespace tautline
