#include "bench/store/trees.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "bench/base/atomic_file.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/store/run_files.hpp"
#include "bench/store/shard.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

std::string tree_name(const fs::path& path) {
  return path.empty() ? "\"\"" : printable(path.native(), 1024);
}

/// What hinders this program from merging a tree that another one wrote; "" if nothing.
std::string other_program(const Manifest::Program& theirs) {
  const Manifest::Program ours = manifest_of({}, "", "").program;
  if (theirs.version != ours.version) {
    return fmt::format("was written by tautline {}, must be of {}, which merges",
                       printable(theirs.version), ours.version);
  }
  if (theirs.hash != ours.hash) {
    return fmt::format(
        "was written by another build of tautline {} (commit {}, here {}), must be of the one "
        "that merges: give every shard the same program",
        ours.version, printable(theirs.commit), ours.commit);
  }
  return "";
}

/// How two trees differ that must agree.
class Differences {
 public:
  Differences(const ResultTree& tree, const ResultTree& first) : tree_(tree), first_(first) {}

  std::vector<std::string> sentences() && {
    compare_lists("case", names(tree_.options.cases), names(first_.options.cases));
    compare_cases();
    compare_lists("engine", engine_names(tree_), engine_names(first_));
    compare_engines();
    const SuiteOptions& one = tree_.options;
    const SuiteOptions& other = first_.options;
    compare("models", all_or(one.models), all_or(other.models));
    compare("the steps", fmt::format("{}", fmt::join(one.steps, ", ")),
            fmt::format("{}", fmt::join(other.steps, ", ")));
    compare("the law", std::string(to_string(one.law)), std::string(to_string(other.law)));
    compare("the time limit", fmt::format("{} s", one.limits.time),
            fmt::format("{} s", other.limits.time));
    compare("the memory limit", fmt::format("{} bytes", one.limits.memory),
            fmt::format("{} bytes", other.limits.memory));
    compare("a number of shards of", fmt::format("{}", one.shard.of),
            fmt::format("{}", other.shard.of));
    return std::move(sentences_);
  }

 private:
  using Names = std::vector<std::string>;

  static Names names(const std::vector<BenchCase>& cases) {
    return listed(cases, [](const BenchCase& one) { return name_of(one); });
  }

  static Names engine_names(const ResultTree& tree) {
    Names result;
    for (const Manifest::Engine& engine : tree.manifest.engines) {
      result.push_back(engine.row.name);
    }
    return result;
  }

  static std::string all_or(const Names& chosen) {
    return chosen.empty() ? "all" : printable(fmt::format("{}", fmt::join(chosen, ", ")));
  }

  void say(const std::string& sentence) {
    sentences_.push_back(tree_name(tree_.path) + ": " + sentence);
  }

  [[nodiscard]] std::string first() const { return tree_name(first_.path); }

  void compare(const char* what, const std::string& one, const std::string& other) {
    if (one != other) {
      say(fmt::format("has {} {}, must have {} as {} has", what, one, other, first()));
    }
  }

  /// Names one that is in one list alone, and says how many there are.
  void compare_lists(const std::string& what, const Names& one, const Names& other) {
    const auto without = [](const Names& all, const Names& some) {
      Names rest;
      std::copy_if(all.begin(), all.end(), std::back_inserter(rest), [&](const std::string& name) {
        return std::find(some.begin(), some.end(), name) == some.end();
      });
      return rest;
    };
    const auto tell = [&](const Names& names, const char* how) {
      if (!names.empty()) {
        const std::string more =
            names.size() > 1 ? fmt::format(" and {} more", names.size() - 1) : "";
        say(fmt::format("{} the {} {}{}, which {} {}", how, what, printable(names.front()), more,
                        first(), std::string(how) == "has" ? "has not" : "has"));
      }
    };
    const Names mine = without(one, other);
    const Names theirs = without(other, one);
    tell(mine, "has");
    tell(theirs, "lacks");
    if (mine.empty() && theirs.empty() && one != other) {
      say(fmt::format("has the {}s in another order than {}", what, first()));
    }
  }

  void compare_cases() {
    const auto& cases = tree_.options.cases;
    const auto& others = first_.options.cases;
    for (std::size_t index = 0; index < std::min(cases.size(), others.size()); ++index) {
      if (name_of(cases[index]) == name_of(others[index]) &&
          tree_.manifest.cases[index] != first_.manifest.cases[index]) {
        say(fmt::format("has another case {} than {}", printable(name_of(cases[index])), first()));
      }
    }
  }

  void compare_engines() {
    const auto version = [](const EngineRow& row) {
      return row.info ? printable(row.info->version) : row.missing ? "missing" : "unusable";
    };
    std::map<std::string, const Manifest::Engine*> others;
    for (const Manifest::Engine& engine : first_.manifest.engines) {
      others.emplace(engine.row.name, &engine);
    }
    for (const Manifest::Engine& engine : tree_.manifest.engines) {
      const auto other = others.find(engine.row.name);
      if (other == others.end()) {
        continue;
      }
      const std::string name = printable(engine.row.name);
      const EngineRow& row = other->second->row;
      if (version(engine.row) != version(row)) {
        say(fmt::format("has {} {}, must have {} as {} has", name, version(engine.row),
                        version(row), first()));
      } else if (engine.plugin != other->second->plugin) {
        say(fmt::format("has another plug-in for {} than {}", name, first()));
      }
    }
  }

  const ResultTree& tree_;
  const ResultTree& first_;
  std::vector<std::string> sentences_;
};

/// A result tree of this program, or what is wrong with it.
void read_tree(const fs::path& path, TreeSet& set) {
  std::optional<Manifest> manifest = read_manifest(path);
  if (!manifest) {
    set.problems.push_back(tree_name(path) +
                           ": is not a result tree of `tautline bench`: must be a folder that one "
                           "of this version wrote as its --out");
    return;
  }
  if (std::string problem = other_program(manifest->program); !problem.empty()) {
    set.problems.push_back(tree_name(path) + ": " + problem);
    return;
  }
  try {
    SuiteOptions options = options_of(*manifest);
    set.trees.push_back({path, *std::move(manifest), std::move(options)});
  } catch (const std::exception& error) {
    set.problems.push_back(tree_name(path) + ": its suite.json makes no sense: " + error.what());
  }
}

/// Copies the files of one run; result.json last, so that a folder with one is whole.
void copy_run(const fs::path& from, const fs::path& to) {
  std::error_code error;
  const auto copy = [&](const fs::path& file) {
    if (!error) {
      fs::copy_file(file, to / file.filename(), fs::copy_options::overwrite_existing, error);
    }
  };
  fs::create_directories(to, error);
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    if (entry.is_regular_file() && entry.path().filename() != "result.json") {
      copy(entry.path());
    }
  }
  copy(from / "result.json");
  if (error) {
    throw FileError("cannot copy " + printable(from.native(), 1024) + " to " +
                    printable(to.native(), 1024) + ": " + error.message());
  }
}

/// What a shard lacks, and how it gets it.
std::string lacking(const ResultTree& tree, std::size_t missing, std::size_t due) {
  return fmt::format(
      "{}: lacks {} of the {} runs of shard {}; its `tautline bench` with --resume does them",
      printable(tree.path.native(), 1024), missing, due, to_string(tree.options.shard));
}

}  // namespace

TreeSet read_trees(const std::vector<fs::path>& paths) {
  TreeSet set;
  for (const fs::path& path : paths) {
    read_tree(path, set);
  }
  std::map<Shard, const ResultTree*> by_shard;
  for (const ResultTree& tree : set.trees) {
    std::vector<std::string> found = Differences(tree, set.trees.front()).sentences();
    std::move(found.begin(), found.end(), std::back_inserter(set.problems));
    const auto [other, is_new] = by_shard.emplace(tree.options.shard, &tree);
    if (!is_new) {
      set.problems.push_back(fmt::format("{}: is shard {}, and so is {}; give each shard once",
                                         tree_name(tree.path), to_string(tree.options.shard),
                                         tree_name(other->second->path)));
    }
  }
  std::stable_sort(set.trees.begin(), set.trees.end(),
                   [](const ResultTree& one, const ResultTree& other) {
                     return one.options.shard.number < other.options.shard.number;
                   });
  return set;
}

std::vector<std::size_t> missing_shards(const std::vector<ResultTree>& trees) {
  std::vector<std::size_t> missing;
  for (std::size_t number = 1; number <= trees.front().options.shard.of; ++number) {
    if (std::none_of(trees.begin(), trees.end(),
                     [&](const ResultTree& tree) { return tree.options.shard.number == number; })) {
      missing.push_back(number);
    }
  }
  return missing;
}

SuiteOptions whole_suite(const std::vector<ResultTree>& trees, const fs::path& out) {
  SuiteOptions options = trees.front().options;
  options.shard = {};
  options.out = out;
  return options;
}

Gathering gather(const std::vector<ResultTree>& trees, const fs::path& out) {
  const SuiteOptions options = whole_suite(trees, out);
  const std::vector<PlannedRun> runs = plan(options);
  const std::vector<std::size_t> numbers = shard_numbers(options, trees.front().options.shard.of);
  std::map<std::size_t, const ResultTree*> tree_of;
  for (const ResultTree& tree : trees) {
    tree_of.emplace(tree.options.shard.number, &tree);
  }
  Gathering gathering;
  gathering.result.planned = runs.size();
  gathering.result.due = runs.size();
  std::map<std::size_t, std::size_t> missing;  // by the number of the shard
  for (std::size_t index = 0; index < runs.size(); ++index) {
    const auto tree = tree_of.find(numbers[index]);
    if (tree == tree_of.end()) {
      continue;
    }
    const RunKey key = key_of(options, runs[index]);
    const fs::path from = run_folder(tree->second->path, key);
    if (auto record = read_run(from, fingerprint(options, runs[index]))) {
      copy_run(from, run_folder(out, key));
      gathering.result.runs.push_back(*std::move(record));
    } else {
      ++missing[numbers[index]];
    }
  }
  gathering.result.kept = gathering.result.runs.size();
  if (const auto shards = missing_shards(trees); !shards.empty()) {
    gathering.missing.push_back(fmt::format(
        "shard{} {} of {} {} missing", shards.size() == 1 ? "" : "s", fmt::join(shards, ", "),
        trees.front().options.shard.of, shards.size() == 1 ? "is" : "are"));
  }
  for (const auto& [number, count] : missing) {
    const auto due = static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), number));
    gathering.missing.push_back(lacking(*tree_of.at(number), count, due));
  }
  return gathering;
}

Context made_by(const std::vector<ResultTree>& trees) {
  Context context;
  std::set<std::string> processors;
  for (const ResultTree& tree : trees) {
    const ShardRow& shard = tree.manifest.shard;
    context.shards.push_back(shard);
    processors.insert(printable(shard.processor));
    context.cores = std::max(context.cores, shard.cores);
    context.elapsed += shard.elapsed;
    if (context.started.empty() || shard.started < context.started) {
      context.started = shard.started;
    }
  }
  context.processor = fmt::format("{}", fmt::join(processors, "; "));
  return context;
}

}  // namespace tautline::bench
