#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/process.hpp"
#include "bench/cases/bench_case.hpp"
#include "bench/check/settle.hpp"
#include "bench/check/strike.hpp"
#include "bench/run/cost.hpp"
#include "bench/run/plugin.hpp"
#include "bench/run/trajectory.hpp"
#include "bench/run/wire.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// What came back from a worker process.
struct Exchange {
  std::optional<WorkerAnswer> answer;     // none if the worker did not come to its end
  std::optional<WorkerAnswer> last_word;  // of a worker that did not, if there is one
  ProcessEnd end;
  std::string failure;  // why the answer is none, or a failure; else empty

  [[nodiscard]] bool interrupted() const { return end.kind == ProcessEnd::Kind::interrupted; }
};

/// Where the worker processes of one thread are, one at a time. A plug-in, which lives in its
/// worker, gets a new one each time unless the request before said that more follow. The worker of
/// an engine with a process of its own stays for the next run: to start such an engine costs as
/// much as many a run.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  /// Has a worker obey `request` within `time_limit` [s]. Throws std::system_error where there are
  /// no more processes, descriptors or memory.
  [[nodiscard]] Exchange exchange(const WorkerRequest& request, double time_limit);

 private:
  class Worker;
  std::unique_ptr<Worker> waiting_;  // for more to do; none if the last one is gone
};

/// Limits on one worker process.
struct WorkerLimits {
  double time = 60.0;                 // [s]
  std::size_t memory = usual_memory;  // [bytes] of address space, or held by an engine's process
};

/// One run, to be done by a worker process.
struct RunRequest {
  std::filesystem::path plugin;
  BenchCase the_case;
  std::string model;
  RunSettings settings;
  WorkerLimits limits;
  bool costs = true;  // what it costs is measured too
  bool more = false;  // further runs follow: the process of a plug-in stays for them
};

/// What came back. Exactly one of `trajectory`, `in_space` and `failure` is set.
struct RunReply {
  std::optional<Trajectory> trajectory;      // of a case
  std::optional<SystemTrajectory> in_space;  // of a system
  Cost cost;                                 // where it was asked for
  std::string failure;                       // such as "crashed: SIGSEGV" or "timed out after 60 s"
  std::string output_tail;                   // the last of what the engine printed
  std::size_t printed = 0;                   // [bytes], all it printed
  bool interrupted = false;  // the program was told to stop; nothing is known of this run
};

/// The run of a case, or of a system.
[[nodiscard]] inline const std::optional<Trajectory>& run_of(const RunReply& reply,
                                                             const Case& /*the_case*/) {
  return reply.trajectory;
}
[[nodiscard]] inline const std::optional<SystemTrajectory>& run_of(
    const RunReply& reply, const SpatialSystem& /*system*/) {
  return reply.in_space;
}

/// Runs it in another process, so that whatever the engine does becomes a reply.
[[nodiscard]] RunReply run_in_worker(const RunRequest& request, Workplace& workplace);

/// What an engine says of itself, asked in a worker process; `failure` as above.
struct DescribeReply {
  std::optional<EngineInfo> info;
  std::string failure;
};
[[nodiscard]] DescribeReply describe_in_worker(const std::filesystem::path& plugin,
                                               const WorkerLimits& limits = {.time = 10.0});

/// What is struck, and with what.
struct StrikesRequest {
  std::filesystem::path plugin;
  std::string model;
  RunSettings settings;
  std::vector<Strike> strikes;
  double restitution;  // [-], of their cables
  WorkerLimits limits;
};

/// The restitution of each strike; no number where there is none. `failure` as above.
struct StrikesReply {
  std::vector<double> restitutions;
  std::optional<SoftRow> law;  // of the cable, where the engine has springs and dampers
  std::string failure;
  bool interrupted = false;
};
[[nodiscard]] StrikesReply strike_in_worker(const StrikesRequest& request, Workplace& workplace);

/// Every claim about one model, settled in a worker process, and `determinism` in two. A crash, a
/// hang and a flood of output break a claim too; the claims after a crash or a hang are missing.
struct CheckReply {
  std::vector<SettledClaim> claims;
  bool interrupted = false;  // the program was told to stop; the rest is missing
};
[[nodiscard]] CheckReply check_in_worker(const std::filesystem::path& plugin,
                                         const std::string& model, const WorkerLimits& limits);

}  // namespace tautline::bench
