#include "bench/suite/suite.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/report/rows.hpp"
#include "bench/run/worker.hpp"
#include "bench/suite/run_files.hpp"

namespace tautline::bench {
namespace {

/// One run: from the result tree if it is there, else in a worker, compared and written.
/// None if the program was interrupted.
std::optional<RunRecord> do_run(const SuiteOptions& options, const ReferenceCase& reference,
                                const PlannedRun& run, std::atomic<std::size_t>& kept) {
  const RegisteredEngine& engine = options.engines[run.engine];
  const RunKey key = key_of(options, run);
  const bool writes = !options.out.empty();
  const auto folder = run_folder(options.out, key);
  if (writes && options.resume) {
    if (auto earlier = read_run(folder, fingerprint(options, run));
        earlier && earlier->row.status != Status::failed) {
      ++kept;
      return earlier;
    }
  }
  const RunReply reply = run_in_worker(
      {engine.plugin, reference.the_case, run.model.name, {run.step, options.law}, options.limits});
  if (reply.interrupted) {
    return std::nullopt;
  }
  RunRecord record = run_record(reference, *engine.info, key, reply, {options.compare});
  if (writes) {
    write_run(folder, options, run, reply, record);
  }
  return record;
}

}  // namespace

SuiteResult run_suite(const SuiteOptions& options, const std::vector<ReferenceCase>& references,
                      const std::function<void(std::size_t)>& progress) {
  const std::vector<PlannedRun> runs = plan(options);
  std::vector<std::optional<RunRecord>> results(runs.size());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> kept{0};
  std::size_t ended = 0;
  std::exception_ptr failure;
  std::mutex guard;  // of `ended`, `failure` and `progress`
  const auto work = [&] {
    for (std::size_t index = next++; index < runs.size() && !interruption(); index = next++) {
      try {
        results[index] = do_run(options, references[runs[index].the_case], runs[index], kept);
      } catch (...) {
        const std::scoped_lock lock(guard);
        failure = std::current_exception();
        next = runs.size();
        return;
      }
      const std::scoped_lock lock(guard);
      progress(++ended);
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned job = 0; job < options.jobs; ++job) {
      workers.emplace_back(work);
    }
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  SuiteResult suite;
  suite.planned = runs.size();
  suite.kept = kept;
  suite.interrupted = interruption();
  for (std::optional<RunRecord>& result : results) {
    if (result) {
      suite.runs.push_back(std::move(*result));
    }
  }
  return suite;
}

}  // namespace tautline::bench
