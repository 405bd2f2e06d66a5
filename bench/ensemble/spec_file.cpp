#include "bench/ensemble/spec_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "bench/base/input_file.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/problems.hpp"
#include "bench/base/strict_table.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/detail/scalar.hpp"

namespace tautline::bench {
namespace {

/// A longer file is refused before it is read [bytes].
constexpr std::size_t longest_spec_file = std::size_t{1} << 20U;

/// More of them than this are a mistake: each draw is solved for each.
constexpr std::size_t most_tables = 100;

/// Points of one grid, which is drawn with a cell for each.
constexpr double most_points = 1000;

const Range whole_number = {"a whole number from 1 to 10000000", 1.0,   1.0,
                            static_cast<double>(most_draws),     false, true};
const Range seed_number = {"a whole number from 0 to 2^53", 1.0, 0.0, 0x1p53, false, true};
const Range point_count = {"a whole number from 2 to 1000", 2.0, 2.0, most_points, false, true};

// a case takes no larger numbers, and differences of such numbers are finite
const Range case_number = {"a number from -1e20 to 1e20", 0.0, -largest_number, largest_number};
// of a pair: what is refused is compared with nothing
const Range number_of_pair = {case_number.right, not_a_number<double>(), -largest_number,
                              largest_number};
const Range positive_number = {"above 0 and at most 1e20", 1.0, 0.0, largest_number, true};

/// More would leave out bounces that the slower of the speeds asks for, in systems of sizes near
/// one.
const Range completion_error = {"above 0 and at most 1e-10", 1e-10, 0.0, 1e-10, true};

const Key completion_key = {
    "completion", "about how much completing an accumulation may change the later velocities"};
const Key seed_key = {"seed", "the seed of the random numbers"};

/// `otherwise`: where none is given.
ImpactLaw read_law(StrictTable& table, ImpactLaw otherwise) {
  const std::vector<std::string> names =
      listed<std::string>(impact_laws, [](ImpactLaw law) { return to_string(law); });
  const std::optional<std::string> name = table.optional_one_of(
      {"law", "the impact law of the exact motion; default simultaneous"}, names);
  const auto place = name ? std::find(names.begin(), names.end(), *name) : names.end();
  return place == names.end() ? otherwise
                              : impact_laws.at(static_cast<std::size_t>(place - names.begin()));
}

/// A relative path, as it is from where the program runs. `name` with a '/' or an ending is one.
std::string from_folder_of(const std::filesystem::path& source, const std::string& name) {
  const bool is_path =
      name.find('/') != std::string::npos || name.ends_with(".so") || name.ends_with(".toml");
  if (!is_path || std::filesystem::path(name).is_absolute()) {
    return name;
  }
  const std::string path = (source.parent_path() / name).string();
  return path.find('/') == std::string::npos ? "./" + path : path;
}

/// The case that a spec means: a file next to it, or a shipped one.
std::optional<AnyCase> read_case(StrictTable& root, const std::filesystem::path& source,
                                 const std::optional<std::string>& other_case, FileProblems& wrong,
                                 std::vector<std::string>& notes) {
  std::string name = root.text(
      {"case", "the name of a shipped case, or a case file, from the folder of this one"});
  if (name.ends_with(".toml")) {  // a shipped one has a '/', too
    name = from_folder_of(source, name);
  }
  name = other_case.value_or(name);
  if (name.empty()) {
    return std::nullopt;
  }
  CaseSelection selection = select_cases({&name, 1}, {}, Kinds::cases_and_systems);
  std::vector<AnyCase> meant;
  const auto add = [&](auto& of_one_kind) {
    std::move(of_one_kind.begin(), of_one_kind.end(), std::back_inserter(meant));
  };
  add(selection.cases);
  add(selection.systems);
  add(selection.in_space);
  if (meant.size() > 1) {
    selection.problems.push_back(fmt::format("means {} cases, must mean one", meant.size()));
  }
  for (const std::string& sentence : selection.problems) {
    other_case ? wrong.add(0, "--case: " + sentence) : root.refuse_value("case", sentence);
  }
  notes = std::move(selection.notes);
  return meant.size() == 1 ? std::optional(std::move(meant.front())) : std::nullopt;
}

/// Values of a grid from one end to the other.
std::vector<double> evenly(const Vec2& ends, double points) {
  const auto count = static_cast<std::size_t>(points);
  std::vector<double> values;
  for (std::size_t index = 0; index < count; ++index) {
    values.push_back(ends.x() +
                     (ends.y() - ends.x()) * static_cast<double>(index) / (points - 1.0));
  }
  return values;
}

Vec2 rising_pair(StrictTable& table, const Key& key) {
  Vec2 ends = table.optional_vector<2>(key, "", number_of_pair).value_or(Vec2(0.0, 1.0));
  if (ends.x() >= ends.y()) {
    table.refuse_value(key.name, "must be two numbers [low, high] with low below high");
  }
  return ends;
}

Distribution read_distribution(StrictTable& table) {
  using Kind = Distribution::Kind;
  std::vector<Distribution> given;
  const std::size_t count = table.count({"normal", "uniform", "list", "grid"});
  const Key normal = {"normal", "normal draws: the standard deviation about the case's own value"};
  if (const auto deviation = table.optional_number(normal, positive_number, "")) {
    given.push_back({Kind::normal, {*deviation}});
  }
  table.with("uniform", [&] {
    const Vec2 ends = rising_pair(table, {"uniform", "draws between two numbers [low, high]"});
    given.push_back({Kind::uniform, {ends.x(), ends.y()}});
  });
  const Key list = {"list", "draws from these values, each as likely as the others"};
  if (auto values = table.numbers(list, "", case_number); !values.empty()) {
    given.push_back({Kind::list, std::move(values)});
  }
  table.with("grid", [&] {
    const Vec2 ends = rising_pair(table, {"grid", "points of a grid from [low, high]"});
    const double points = table.number({"points", "how many values the grid has"}, point_count, "");
    given.push_back({Kind::grid, evenly(ends, points)});
  });
  if (count != 1) {
    table.refuse_value("quantities", "needs one of normal, uniform, list and grid; " +
                                         std::string(count == 0 ? "none is" : "several are") +
                                         " given");
  }
  return given.empty() ? Distribution{Kind::list, {0.0}} : given.front();
}

/// Adds the names of any system of D dimensions that `names` does not have, but for its bodies'.
template <int D>
void add_names(std::vector<std::string>& names) {
  BasicSystem<double, D> system;
  system.bodies.resize(1);
  if constexpr (D == 2) {
    system.bodies.front().inertia = 1.0;
  } else {
    system.bodies.front().inertia.setOnes();
  }
  system.initial.bodies.resize(1);
  system.cables.resize(1);
  auto& cable = system.cables.front();
  cable.length.pieces.front().coefficients.push_back(Function<1>::Value(1.0));
  cable.length.waves = {{Function<1>::Value(1.0), 1.0}};
  cable.from_time = 1.0;
  cable.cut_at = 2.0;
  for (const std::string& name : quantities_of(system)) {
    const bool of_body = name.find('.') != std::string::npos;
    if (!of_body && std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
  }
}

/// The names that an editor proposes.
std::vector<std::string> proposed_names() {
  Case any_case;
  any_case.cables.resize(max_cables);
  std::vector<std::string> names = quantities_of(any_case);
  add_names<2>(names);
  add_names<3>(names);
  names.emplace_back(names_of_one);
  return names;
}

/// Refuses a `name` that is none of `names`.
bool is_known(StrictTable& table, const char* key, const std::string& name,
              const std::vector<std::string>& names) {
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  if (!known) {
    table.refuse_value(key, printable(name) + " is none of this case" + suggestion(name, names) +
                                "; it has " + joined(names, "and"));
  }
  return known;
}

/// What one table [[vary]] varies, each of its quantities independent of the others: `names` of
/// `the_case`, and none of those `before`, which it joins.
std::vector<Varied> read_varied(StrictTable& table, const AnyCase& the_case,
                                const std::vector<std::string>& names,
                                std::set<std::string>& before) {
  std::vector<Varied> result;
  const auto chosen =
      table.texts({"quantities", "the numbers of the case that vary, each by itself"},
                  "must be an array of names, such as [\"x\", \"y\"]", proposed_names());
  const Distribution distribution = read_distribution(table);
  for (const std::string& name : chosen) {
    if (is_known(table, "quantities", name, names) && !before.insert(name).second) {
      table.refuse_value("quantities", printable(name) + " is varied twice");
    }
    const bool known = before.contains(name);
    result.push_back(
        {name, distribution,
         known
             ? std::visit([&](const auto& one) { return std::string(unit_of_quantity(one, name)); },
                          the_case)
             : ""});
  }
  table.refuse_unknown_keys();
  return result;
}

/// What it does not say is as in `spec`, with the variants `before` it.
ExactVariant read_variant(StrictTable& table, const std::vector<std::string>& names,
                          const EnsembleSpec& spec) {
  ExactVariant result;
  result.name = table.text({"name", "the name of this exact motion"});
  const bool is_taken =
      result.name == "exact" || find_by(spec.exact, &ExactVariant::name, result.name) != nullptr;
  if (is_taken && !result.name.empty()) {
    table.refuse_value("name", "two are called " + printable(result.name));
  }
  result.law = read_law(table, spec.law);
  if (const auto seed = table.optional_number(seed_key, seed_number, "")) {
    result.seed = static_cast<std::uint64_t>(*seed);
  }
  table.with("quantity", [&] {
    result.quantity =
        table.text({"quantity", "a number of the case that is another here"}, proposed_names());
    static_cast<void>(result.quantity.empty() ||
                      is_known(table, "quantity", result.quantity, names));
    result.factor =
        table.number({"factor", "by which the quantity is multiplied"}, case_number, "");
  });
  result.completion =
      table.optional_number(completion_key, completion_error, "").value_or(spec.completion);
  table.refuse_unknown_keys();
  return result;
}

void read_engines(StrictTable table, const std::filesystem::path& source, EnsembleSpec& spec) {
  if (is_system(spec.the_case)) {
    table.refuse_value("names", "engines run cases of one body; " +
                                    printable(name_of(spec.the_case)) + " is a system");
  }
  const std::string names = "must be an array of at least one name";
  for (const std::string& name : table.texts(
           {"names", "names of engines, or paths of plug-ins, from the folder of this file"},
           names)) {
    spec.engines.push_back(from_folder_of(source, name));
  }
  spec.models = table.optional_texts({"models", "the models that run; default all"}, names)
                    .value_or(std::vector<std::string>());
  spec.steps = table.numbers({"steps", "the time steps; default [0.001]"}, "[s]", positive_number);
  if (spec.steps.empty()) {
    spec.steps = {1e-3};  // the middle one of those that `tautline bench` takes
  }
  for (const double step : spec.steps) {
    const double duration = duration_of(spec.the_case);
    if (const double count = duration / step; count > most_steps) {
      table.refuse_value("steps",
                         fmt::format("{} needs {:.0e} steps for {} s, must need at most {:.0e}",
                                     shortest(step), count, shortest(duration), most_steps));
    }
  }
  if (std::set<double>(spec.steps.begin(), spec.steps.end()).size() != spec.steps.size()) {
    table.refuse_value("steps", "a step is given twice");
  }
  table.refuse_unknown_keys();
}

void read_speeds(StrictTable& root, EnsembleSpec& spec) {
  const Vec2 speeds =
      root.optional_vector<2>({"speeds",
                               "two falling speeds: slower impacts are not counted; default "
                               "[0.01, 0.001]"},
                              "[m/s]", number_of_pair)
          .value_or(Vec2(spec.speeds[0], spec.speeds[1]));
  spec.speeds = {speeds.x(), speeds.y()};
  if (speeds.x() <= speeds.y() || speeds.y() < 1e-3) {
    // RecordOptions::slowest: an engine's slower impacts are not kept
    root.refuse_value("speeds", "must be two falling speeds of at least 0.001 m/s");
  }
}

/// The points of all grids together count.
void check_count(StrictTable& root, const EnsembleSpec& spec) {
  if (draw_count(spec) > most_draws) {
    root.refuse_value(
        "count", fmt::format("{} draws in all, must be at most {}", draw_count(spec), most_draws));
  }
}

EnsembleSpec read_tables(StrictTable root, const std::filesystem::path& source,
                         const std::optional<std::string>& other_case, FileProblems& wrong,
                         std::vector<std::string>& notes) {
  EnsembleSpec spec;
  Case any_case;  // in place of one that cannot be read: with every cable that is asked for
  any_case.cables.resize(max_cables);
  spec.the_case = read_case(root, source, other_case, wrong, notes).value_or(any_case);
  if (const auto until =
          root.optional_number({"until", "where every run ends; default the case's own duration"},
                               positive_number, "[s]")) {
    std::visit([&](auto& one) { one.duration = *until; }, spec.the_case);
  }
  spec.count = static_cast<std::size_t>(
      root.optional_number(
              {"count", "the number of samples, at each point of a grid; default 1000"},
              whole_number, "")
          .value_or(1000.0));
  spec.seed =
      static_cast<std::uint64_t>(root.optional_number(seed_key, seed_number, "").value_or(1.0));
  spec.sampling = root.optional_one_of({"sampling",
                                        "random, or sobol: evenly spread, for means with less "
                                        "noise; default random"},
                                       {"random", "sobol"}) == "sobol"
                      ? Sampling::sobol
                      : Sampling::random;
  spec.law = read_law(root, spec.law);
  read_speeds(root, spec);
  spec.completion =
      root.optional_number(completion_key, completion_error, "").value_or(spec.completion);
  const std::vector<std::string> names =
      std::visit([](const auto& one) { return quantities_of(one); }, spec.the_case);
  std::set<std::string> quantities;
  for (StrictTable& table : root.tables({"vary", "what differs between the samples"}, most_tables,
                                        "must be tables [[vary]]")) {
    for (Varied& one : read_varied(table, spec.the_case, names, quantities)) {
      spec.varied.push_back(std::move(one));
    }
  }
  for (StrictTable& table :
       root.optional_tables({"exact", "further exact motions of the same samples"}, most_tables,
                            "must be [[exact]]")) {
    spec.exact.push_back(read_variant(table, names, spec));
  }
  root.with("engines", [&] {
    read_engines(root.table({"engines", "engines that run the same samples"}), source, spec);
  });
  root.refuse_unknown_keys();
  if (wrong.empty()) {
    check_count(root, spec);
  }
  return spec;
}

}  // namespace

Form spec_form() {
  Form form;
  FileProblems wrong("");
  std::vector<std::string> notes;
  static_cast<void>(read_tables(StrictTable(form), "", {}, wrong, notes));
  return form;
}

SpecReading read_spec_file(const std::filesystem::path& path,
                           const std::optional<std::string>& other_case) {
  const InputFile file = read_input_file(path, longest_spec_file);
  if (file.problem) {
    FileProblems wrong(path.native());
    wrong.add(0, *file.problem);
    return {std::nullopt, wrong.sentences()};
  }
  return read_spec_text(file.content, path, other_case);
}

SpecReading read_spec_text(std::string_view text, const std::filesystem::path& source,
                           const std::optional<std::string>& other_case) {
  FileProblems wrong(source.native());
  const std::optional<toml::table> file = parse_toml(text, wrong);
  if (!file) {
    return {std::nullopt, wrong.sentences()};
  }
  std::vector<std::string> notes;
  EnsembleSpec spec = read_tables(StrictTable(&*file, "", wrong), source, other_case, wrong, notes);
  if (!wrong.empty()) {
    return {std::nullopt, wrong.sentences()};
  }
  return {std::move(spec), {}, std::move(notes)};
}

}  // namespace tautline::bench
