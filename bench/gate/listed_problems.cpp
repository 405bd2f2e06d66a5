// Reads a problems file, as strictly as a case file: all that is wrong with it is said
// at once.

#include "bench/gate/listed_problems.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "bench/base/input_file.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/problems.hpp"
#include "bench/base/strict_table.hpp"
#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "shipped_problems.inc"

namespace tautline::bench {
namespace {

/// A longer file is refused before it is read [bytes].
constexpr std::size_t longest_problems_file = std::size_t{1} << 20U;

/// More entries than this are a mistake: every run is compared with each of them.
constexpr std::size_t most_entries = 10'000;

const Range right_schema = {"2, the form that this program reads: a list of problems, no limits",
                            problems_schema,
                            problems_schema,
                            problems_schema,
                            false,
                            true};

/// Holds the patterns of a file against the names that there are.
class Names {
 public:
  explicit Names(const ProblemNames& names) : names_(names) {
    for (const ProblemNames::Engine& engine : names.engines) {
      engines_.push_back(engine.name);
    }
  }

  void check(const RunPattern& runs, StrictTable& table) const {
    for (const std::string& engine : alternatives(runs.engine)) {
      check_slip("engine", engine, engines_, table);
    }
    for (const std::string& model : alternatives(runs.model)) {
      check_model(runs.engine, model, table);
    }
    for (const std::string& the_case : alternatives(runs.the_case)) {
      check_case(the_case, table);
    }
  }

 private:
  static bool any_matches(const std::string& pattern, const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return matches(pattern, name); });
  }

  /// A name that is none of `names`, and nearly one.
  static void check_slip(const char* key, const std::string& pattern,
                         const std::vector<std::string>& names, StrictTable& table) {
    const std::string near = suggestion(pattern, names);
    if (!near.empty() && !any_matches(pattern, names)) {
      table.refuse_value(key, std::string("there is no such ") + key + near);
    }
  }

  /// A model that none of the engines has, all of them being here.
  void check_model(const std::string& engine_pattern, const std::string& model,
                   StrictTable& table) const {
    std::vector<std::string> models;
    bool all_here = true;
    for (const ProblemNames::Engine& engine : names_.engines) {
      if (matches(engine_pattern, engine.name)) {
        all_here = all_here && engine.models;
        const auto& own = engine.models ? *engine.models : std::vector<std::string>();
        models.insert(models.end(), own.begin(), own.end());
      }
    }
    if (!models.empty() && all_here && !any_matches(model, models)) {
      std::sort(models.begin(), models.end());
      models.erase(std::unique(models.begin(), models.end()), models.end());
      const std::string near = suggestion(model, models);
      table.refuse_value("model", "no engine that this means has such a model" +
                                      (near.empty() ? ", must be " + joined(models, "or") : near));
    }
  }

  /// A case that its series does not have.
  void check_case(const std::string& pattern, StrictTable& table) const {
    const std::string series = pattern.substr(0, pattern.find('/') + 1);
    const bool known = !series.empty() && any_matches(series + "*", names_.cases);
    if (known && !any_matches(pattern, names_.cases)) {
      table.refuse_value("case", "there is no such case" + suggestion(pattern, names_.cases));
    } else {
      check_slip("case", pattern, names_.cases, table);
    }
  }

  const ProblemNames& names_;
  std::vector<std::string> engines_;
};

ListedProblem read_problem(StrictTable& table, const Names& names) {
  ListedProblem problem;
  problem.runs.engine =
      table.text({"engine", "a pattern of names with * and ?, or several with | between them"});
  problem.runs.model = table.text({"model", "a pattern, like engine"});
  problem.runs.the_case =
      table.optional_text({"case", "a pattern, like engine; default all cases"}).value_or("*");
  problem.runs.step =
      table.optional_number({"step", "the time step; default all steps"}, above_zero, "[s]");
  names.check(problem.runs, table);
  problem.kind =
      table.one_of({"kind", "what is wrong with the run"},
                   listed<std::string>(problem_kinds, [](std::string_view kind) { return kind; }));
  problem.finding =
      table.optional_text({"finding", "what was found when it was listed"}).value_or("");
  problem.reason = table.text_or_empty({"reason", "why it is so, and may stay"});
  problem.in_some =
      table.flag({"in_some", "true: only some of these runs show the problem; default false"});
  table.refuse_unknown_keys();
  return problem;
}

ListedProblems read_tables(StrictTable root, const Names& names) {
  ListedProblems result;
  static_cast<void>(root.number({"schema", "the form of this file"}, right_schema, ""));
  result.version = root.text({"version", "the version of this list, which reports name"});
  for (StrictTable& table : root.optional_tables(
           {"problem", "problems that runs are known to have"}, most_entries,
           "must be tables [[problem]], each with engine, model, kind and reason")) {
    for (StrictTable& entry : table.each(most_entries)) {
      result.problems.push_back(read_problem(entry, names));
    }
  }
  for (const char* old : {"limits", "known", "not_judged"}) {
    root.refuse_value(old,
                      "is no longer asked for: runs are judged from the exact motion; list what "
                      "may stay as [[problem]], with engine, model, kind and reason");
  }
  root.refuse_unknown_keys();
  return result;
}

}  // namespace

Form problems_form() {
  Form form;
  const ProblemNames none;
  static_cast<void>(read_tables(StrictTable(form), Names(none)));
  return form;
}

ProblemsReading read_problems_text(std::string_view text, const std::string& source_name,
                                   const ProblemNames& names) {
  FileProblems findings(source_name);
  const std::optional<toml::table> file = parse_toml(text, findings);
  if (!file) {
    return {std::nullopt, findings.sentences()};
  }
  ListedProblems result = read_tables(StrictTable(&*file, "", findings), Names(names));
  if (!findings.empty()) {
    return {std::nullopt, findings.sentences()};
  }
  result.file = source_name;
  if (text.starts_with("#:schema ")) {
    result.schema_line = text.substr(0, text.find('\n'));
  }
  return {std::move(result), {}};
}

ProblemsReading read_problems_file(const std::filesystem::path& path, const ProblemNames& names) {
  const InputFile file = read_input_file(path, longest_problems_file);
  if (file.problem) {
    FileProblems findings(path.native());
    findings.add(0, *file.problem);
    return {std::nullopt, findings.sentences()};
  }
  return read_problems_text(file.content, path.native(), names);
}

ListedProblems shipped_problems() {
  // the tests read it: what ships is sound
  return read_problems_text(shipped_problems_text, std::string(shipped_problems_file))
      .listed.value();
}

const ListedProblem* ListedProblems::find(const RunKey& run, std::string_view kind) const {
  const auto found = std::find_if(problems.begin(), problems.end(), [&](const ListedProblem& one) {
    return one.kind == kind && one.runs.holds(run);
  });
  return found != problems.end() ? &*found : nullptr;
}

}  // namespace tautline::bench
