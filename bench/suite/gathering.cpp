#include "bench/suite/gathering.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "bench/base/atomic_file.hpp"
#include "bench/base/text.hpp"
#include "bench/suite/run_files.hpp"
#include "bench/suite/shard.hpp"

namespace tautline::bench {
namespace {

namespace fs = std::filesystem;

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
