#include "bench/suite/suite.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "bench/base/process.hpp"
#include "bench/run/worker.hpp"
#include "bench/store/run_files.hpp"
#include "bench/store/shard.hpp"
#include "bench/suite/rows.hpp"

namespace tautline::bench {
namespace {

/// A run that need not be done again: the result tree has it, and it did not fail.
std::optional<RunRecord> earlier_run(const SuiteOptions& options, const PlannedRun& run) {
  if (options.out.empty() || !options.resume) {
    return std::nullopt;
  }
  auto earlier = read_run(run_folder(options.out, key_of(options, run)), fingerprint(options, run));
  return earlier && earlier->row.status != Status::failed ? earlier : std::nullopt;
}

/// One run in a worker, compared, drawn and written. None if the program was interrupted.
std::optional<RunRecord> do_run(const SuiteOptions& options, const AnyExpectation& expectation,
                                const Nearness& nearness, const PlannedRun& run,
                                Workplace& workplace) {
  const RegisteredEngine& engine = options.engines[run.engine];
  const RunKey key = key_of(options, run);
  const RunReply reply = run_in_worker({engine.plugin,
                                        options.cases[run.the_case],
                                        run.model.name,
                                        {run.step, options.law},
                                        options.limits},
                                       workplace);
  if (reply.interrupted) {
    return std::nullopt;
  }
  RunRecord record = run_record(expectation, nearness, *engine.info, key, reply, options.compare);
  if (!options.out.empty()) {
    write_run(run_folder(options.out, key), options, run, reply, record);
  }
  return record;
}

}  // namespace

SuiteResult run_suite(const SuiteOptions& options, const Expectations& expectations,
                      const SuiteProgress& progress) {
  const std::vector<PlannedRun> runs = plan(options);
  const std::vector<std::size_t> due = places_in_shard(options);
  std::vector<std::optional<RunRecord>> results(due.size());
  std::vector<Nearness> nearness(expectations.size());  // of the motions of each case
  std::vector<std::once_flag> known(expectations.size());
  std::atomic<std::size_t> next{0};
  std::size_t kept = 0;
  std::exception_ptr failure;
  std::mutex guard;  // of `kept`, `failure` and `progress`
  const auto work = [&] {
    Workplace workplace;
    for (std::size_t index = next++; index < due.size() && !interruption(); index = next++) {
      const PlannedRun& run = runs[due[index]];
      const std::size_t place = run.the_case;
      bool earlier = false;
      try {
        results[index] = earlier_run(options, run);
        earlier = results[index].has_value();
        if (!earlier) {
          std::call_once(known[place], [&] { nearness[place] = nearness_of(expectations[place]); });
          results[index] = do_run(options, expectations[place], nearness[place], run, workplace);
        }
      } catch (...) {
        const std::scoped_lock lock(guard);
        failure = std::current_exception();
        next = due.size();
        return;
      }
      const std::scoped_lock lock(guard);
      kept += earlier ? 1U : 0U;
      progress(run, earlier);
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
  suite.due = due.size();
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
