#include "tautline/case_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "bench/base/problems.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "bench/cases/case_json.hpp"
#include "bench/cases/case_tables.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

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

/// The line that a sentence on a system is about: "cable 2: length: waves[0]: ...", "body 1: mass".
std::size_t line_of_system_problem(const toml::table& file, std::string_view sentence) {
  using Place = toml::node_view<const toml::node>;
  Place place(static_cast<const toml::node*>(&file));
  const auto entry = [](Place array, std::string_view name) {
    const std::size_t digits = std::min(name.find_first_of("0123456789"), name.size());
    std::size_t index = 0;
    std::from_chars(name.data() + digits, name.data() + name.size(), index);
    return array[index];
  };
  if (sentence.starts_with("cable")) {
    place = entry(place["cables"], sentence);
  } else if (sentence.starts_with("body ")) {
    place = place["bodies"] ? entry(place["bodies"], sentence) : place["body"];
  }
  if (place.node() != &file) {
    sentence.remove_prefix(std::min(sentence.find(": ") + 2, sentence.size()));
  }
  while (true) {  // from key to key
    const std::string_view word = sentence.substr(0, sentence.find_first_of(": "));
    const std::string_view name = word.substr(0, word.find('['));
    Place next = place[name];
    if (!next && place.node() == file.get("body")) {
      next = file["initial"][name];
    }
    if (next && word.size() > name.size()) {
      next = entry(next, word.substr(name.size()));
    }
    if (!next) {
      return place.node() == &file ? 0 : line_of(place.node());
    }
    place = next;
    if (sentence.substr(word.size()).substr(0, 2) != ": ") {
      return line_of(place.node());
    }
    sentence.remove_prefix(word.size() + 2);
  }
}

/// Reads a file that is a case.
CaseReading read_as_case(const toml::table& file, const std::string& source_name, CableSet taut,
                         FileProblems& wrong) {
  auto [the_case, starts_taut] = read_case_tables(StrictTable(&file, "", wrong));
  if (!wrong.empty()) {
    return {std::nullopt, wrong.sentences()};
  }
  for (const std::size_t index : starts_taut) {
    taut.insert(index);
  }
  FileProblems notes(source_name);
  StartChange change = start_taut(the_case, taut);  // rules that tie several keys together
  for (const std::string& sentence : change.notes) {
    notes.add(line_of(file["initial"].node()), sentence);
  }
  if (change.problems.empty()) {
    change.problems = problems(the_case);
  }
  for (const std::string& sentence : change.problems) {
    const bool typed = sentence.find(": overstretched") != std::string::npos && near_taut(the_case);
    wrong.add(line_of_problem(file, sentence),
              sentence + (typed ? ", or taut = true, which moves the start" : ""));
  }
  if (!wrong.empty()) {
    return {std::nullopt, wrong.sentences()};
  }
  return {std::move(the_case), {}, notes.sentences()};
}

/// Reads any other file.
template <class TheSystem>
std::optional<TheSystem> read_as(const toml::table& file, FileProblems& wrong) {
  auto result = read_system_tables<TheSystem>(StrictTable(&file, "", wrong));
  if (wrong.empty()) {
    for (const std::string& sentence : problems(result)) {
      wrong.add(line_of_system_problem(file, sentence), sentence);
    }
  }
  return wrong.empty() ? std::optional(std::move(result)) : std::nullopt;
}

SystemReading read_as_system(const toml::table& file, CableSet taut, FileProblems& wrong) {
  SystemReading result;
  for (const std::size_t index : taut) {
    wrong.add(0, "cable " + std::to_string(index) +
                     " cannot start taut: must be a cable of a case, one [body] where all is "
                     "constant");
  }
  if (is_in_space(file)) {
    result.in_space = read_as<SpatialSystem>(file, wrong);
  } else {
    result.system = read_as<System>(file, wrong);
  }
  if (!wrong.empty()) {
    return {.problems = wrong.sentences()};
  }
  return result;
}

std::optional<toml::table> parsed(std::string_view text, FileProblems& wrong) {
  return is_json(text) ? parse_json(text, wrong) : parse_toml(text, wrong);
}

/// Why the file is no case.
std::string only_a_system(const SystemKey& key, const std::string& source_name) {
  FileProblems only(source_name);
  only.add(key.line, key.name + ": makes this a system; must be a case here: one [body], cables " +
                         "with anchor and attachment, and constants");
  return only.sentences().front();
}

}  // namespace
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
  const std::optional<toml::table> file = bench::parsed(text, wrong);
  if (!file) {
    return {std::nullopt, wrong.sentences()};
  }
  if (const auto key = bench::system_key(*file)) {
    return {std::nullopt, {bench::only_a_system(*key, source_name)}};
  }
  return bench::read_as_case(*file, source_name, taut, wrong);
}

SystemReading read_system_text(std::string_view text, const std::string& source_name,
                               CableSet taut) {
  bench::FileProblems wrong(source_name);
  const std::optional<toml::table> file = bench::parsed(text, wrong);
  if (!file) {
    return {.problems = wrong.sentences()};
  }
  auto key = bench::system_key(*file);
  if (!key && bench::is_in_space(*file)) {
    key = {"gravity", bench::line_of(file->get("gravity"))};
  }
  if (key) {
    SystemReading result = bench::read_as_system(*file, taut, wrong);
    result.only_a_system = bench::only_a_system(*key, source_name);
    return result;
  }
  CaseReading reading = bench::read_as_case(*file, source_name, taut, wrong);
  SystemReading result;
  result.problems = std::move(reading.problems);
  result.notes = std::move(reading.notes);
  if (reading.the_case) {
    result.system = as_system(*reading.the_case);
    result.the_case = std::move(reading.the_case);
  }
  return result;
}

}  // namespace tautline
