#include "bench/ensemble/ensemble.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "bench/base/atomic_file.hpp"
#include "bench/base/process.hpp"
#include "bench/ensemble/draw_files.hpp"

namespace tautline::bench {
namespace {

/// Draws that are solved in one go.
struct Chunk {
  std::size_t setup;
  std::size_t first;
  std::size_t end;
};

std::vector<Chunk> chunks_of(const EnsembleRequest& request) {
  const std::size_t count = draw_count(request.spec);
  std::vector<Chunk> chunks;
  for (std::size_t setup = 0; setup < request.setups.size(); ++setup) {
    const std::size_t size = chunk_size(request.setups[setup]);
    for (std::size_t first = 0; first < count; first += size) {
      chunks.push_back({setup, first, std::min(first + size, count)});
    }
  }
  std::stable_sort(chunks.begin(), chunks.end(),
                   [](const Chunk& one, const Chunk& other) { return one.first < other.first; });
  return chunks;
}

struct Solved {
  std::vector<DrawResult> results;
  bool kept;  // they had been done before
};

/// One thread's part of the work: its solvers, and the files that keep what they find.
class Solving {
 public:
  Solving(const EnsembleRequest& request, const EnsembleOptions& options)
      : request_(request), options_(options) {}

  /// The draws of `chunk`; fewer if the program was interrupted.
  Solved solve(const Chunk& chunk) {
    const EnsembleSetup& setup = request_.setups[chunk.setup];
    const std::uint64_t mark = draws_fingerprint(
        request_.spec, setup, options_.programs.empty() ? 0 : options_.programs[chunk.setup]);
    const auto file = chunk_file(options_.out, setup, chunk.first);
    if (options_.resume) {
      if (auto kept = read_chunk(file, request_.spec, mark, chunk.first, chunk.end)) {
        return {std::move(*kept), true};
      }
    }
    auto& solver = solvers_[chunk.setup];
    if (!solver) {
      solver = draw_solver(request_, setup);
    }
    std::vector<DrawResult> results = solver->solve(chunk.first, chunk.end);
    const bool whole = results.size() == chunk.end - chunk.first;
    if (whole && !options_.out.empty()) {
      write_file_soon(file, chunk_csv(request_.spec, mark, results));
    }
    return {std::move(results), false};
  }

 private:
  const EnsembleRequest& request_;
  const EnsembleOptions& options_;
  std::map<std::size_t, std::unique_ptr<DrawSolver>> solvers_;  // by setup
};

}  // namespace

EnsembleResult solve_ensemble(const EnsembleRequest& request, const EnsembleOptions& options,
                              const DrawProgress& progress) {
  const std::vector<Chunk> chunks = chunks_of(request);
  EnsembleResult result;
  result.goes_on = true;
  result.draws.reserve(request.setups.size());  // copies would take as much room again
  const bool collects = options.team == nullptr;
  const std::size_t count = collects ? draw_count(request.spec) : 0;
  // an atlas is of every draw
  const bool maps = grid_axes(request.spec).size() > 1;
  for (std::size_t setup = 0; setup < request.setups.size(); ++setup) {
    result.draws.emplace_back(statistics_of(request.spec).size(), count,
                              maps ? count : std::min(count, most_held));
  }
  std::atomic<std::size_t> own{0};
  std::exception_ptr failure;
  std::atomic<bool> failed{false};
  std::mutex guard;      // of `result`, `failure`, `progress` and `told`
  std::size_t told = 0;  // of a team's chunks, in their order
  const auto next = [&] {
    if (collects) {
      return own++;
    }
    const std::size_t index = options.team->next();
    const std::scoped_lock lock(guard);
    for (; told < std::min(index, chunks.size()); ++told) {
      const Chunk& chunk = chunks[told];
      progress(request.setups[chunk.setup], chunk.end - chunk.first, false);
    }
    return index;
  };
  const auto work = [&] {
    Solving solving(request, options);
    for (std::size_t index = next(); index < chunks.size() && !interruption() && !failed;
         index = next()) {
      try {
        const Chunk& chunk = chunks[index];
        const Solved solved = solving.solve(chunk);
        if (!collects) {
          continue;
        }
        const std::scoped_lock lock(guard);
        for (const DrawResult& one : solved.results) {
          result.draws[chunk.setup].put(one);
        }
        progress(request.setups[chunk.setup], solved.results.size(), solved.kept);
        options.so_far(result);
      } catch (...) {
        const std::scoped_lock lock(guard);
        failure = std::current_exception();
        failed = true;
        return;
      }
    }
  };
  keep_freed_memory();
  {
    std::vector<std::jthread> workers;
    for (unsigned job = 0; job < options.jobs; ++job) {
      workers.emplace_back(work);
    }
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  result.interrupted = interruption();
  result.goes_on = false;
  return result;
}

}  // namespace tautline::bench
