#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bench/check/settle.hpp"
#include "bench/check/strike.hpp"
#include "bench/run/cost.hpp"
#include "bench/run/trajectory.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

// How the program and a worker process talk: one request, one answer, each a message of bytes. Both
// are the same executable.

/// The hidden command of the program that makes it a worker process.
inline constexpr const char* worker_command = "worker-process";

/// Where a worker finds its request, and where it leaves its answer.
inline constexpr int request_descriptor = 0;
inline constexpr int answer_descriptor = 3;

/// A socket: it may begin when it hears a byte, and says one where it stays for more.
inline constexpr int turn_descriptor = 4;

/// What a worker process does: reads its request, obeys it, writes its answer; and that again where
/// the request says that more follow or its plug-in is an engine with a process of its own, as long
/// as all goes well and there is more to do. The exit code.
[[nodiscard]] int worker_main();

/// What a worker is asked to do with a plug-in.
enum class Task { describe, run, check, digest, strikes };

struct WorkerRequest {
  Task task = Task::describe;
  std::string plugin;                // its file
  std::size_t memory = 0;            // [bytes] of address space that the worker may take
  std::string model;                 // to run, to check, or to take the digest of
  std::string case_text;             // to run: a case file
  RunSettings settings = 0.0;        // to run, or of strikes
  std::vector<Strike> strikes = {};  // each on a cable of this
  double restitution = 0.0;          // [-]
  bool costs = true;                 // of a run: what it costs is measured too
  bool more = false;                 // another request follows, for which the process may stay
};

/// Why there is no answer, in one sentence.
struct Failure {
  std::string sentence;
  bool of_process = false;  // an engine's own process ended
};

/// A run that came to its end, of a `Case` or of a `SpatialSystem`.
template <class TheCase>
struct BasicRunAnswer {
  BasicTrajectory<TheCase> trajectory;
  Cost cost;
};
using RunAnswer = BasicRunAnswer<Case>;
using SystemRunAnswer = BasicRunAnswer<SpatialSystem>;

/// The claims about a model that are settled.
struct CheckAnswer {
  std::vector<SettledClaim> claims;
  std::string unfinished;  // the claim that is being measured; none in the last answer
  std::string digest;      // of the run that `determinism` repeats; none if the engine threw
};

struct DigestAnswer {
  std::string digest;
};

struct StrikesAnswer {
  std::vector<double> restitutions;  // one for each strike; no number where nothing was struck
  std::optional<SoftRow> law;        // of the cable, where the engine has springs and dampers
};

/// One for each task, and a failure of any.
using WorkerAnswer = std::variant<Failure, EngineInfo, RunAnswer, CheckAnswer, DigestAnswer,
                                  StrikesAnswer, SystemRunAnswer>;

[[nodiscard]] std::string to_bytes(const WorkerRequest& request);
[[nodiscard]] std::string to_bytes(const WorkerAnswer& answer);

/// Throws std::runtime_error if `bytes` is no request.
[[nodiscard]] WorkerRequest request_from(std::string_view bytes);

/// None if `bytes` is not a whole message: the writer died. A failure if it makes no sense.
[[nodiscard]] std::optional<WorkerAnswer> answer_from(std::string_view bytes);

}  // namespace tautline::bench
