#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/check/claims.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// Limits on one worker process.
struct WorkerLimits {
  double time = 60.0;                          // [s]
  std::size_t memory = std::size_t{2} << 30U;  // [bytes] of address space
};

/// What one step cost, measured on the processor clock of the worker's thread.
struct Cost {
  double step = 0.0;       // [s], processor time of one step, with its share of the start
  double memory = 0.0;     // [bytes], the most the worker held at once
  double reference = 0.0;  // [s], of one closed-form flight and its gaps, measured side by side
};

/// One run, to be done by a worker process.
struct RunRequest {
  std::filesystem::path plugin;
  Case the_case;
  std::string model;
  RunSettings settings;
  WorkerLimits limits;
};

/// What came back. Exactly one of `trajectory` and `failure` is set.
struct RunReply {
  std::optional<Trajectory> trajectory;
  Cost cost;
  std::string failure;       // such as "crashed: SIGSEGV" or "timed out after 60 s"
  std::string output_tail;   // the last of what the engine printed
  std::size_t printed = 0;   // [bytes], all it printed
  bool interrupted = false;  // the program was told to stop; nothing is known of this run
};

/// Runs it in a process of its own, so that whatever the engine does becomes a reply.
[[nodiscard]] RunReply run_in_worker(const RunRequest& request);

/// What an engine says of itself, asked in a worker process; `failure` as above.
struct DescribeReply {
  std::optional<EngineInfo> info;
  std::string failure;
};
[[nodiscard]] DescribeReply describe_in_worker(const std::filesystem::path& plugin,
                                               const WorkerLimits& limits = {.time = 10.0});

/// Every claim about one model, settled in a worker process, and `determinism` in two. A crash, a
/// hang and a flood of output are findings too; the claims after a crash or a hang are missing.
struct CheckReply {
  std::vector<Finding> findings;
  bool interrupted = false;  // the program was told to stop; the rest is missing
};
[[nodiscard]] CheckReply check_in_worker(const std::filesystem::path& plugin,
                                         const std::string& model, const WorkerLimits& limits);

/// The other side: reads a request from descriptor 0, does it, writes the reply to descriptor 3.
/// Returns the exit code. Called by the program's hidden command.
[[nodiscard]] int worker_main();

/// The hidden command's name.
inline constexpr const char* worker_command = "worker-process";

}  // namespace tautline::bench
