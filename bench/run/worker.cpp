#include "bench/run/worker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>
#include <variant>

#include "bench/base/process.hpp"
#include "bench/cases/case_file.hpp"
#include "bench/cases/case_writer.hpp"
#include "bench/check/claims.hpp"
#include "bench/run/wire.hpp"
#include "bench/run/worker_process.hpp"

namespace tautline::bench {
namespace {

/// What came back from a worker process.
struct Exchange {
  std::optional<WorkerAnswer> answer;     // none if the worker did not come to its end
  std::optional<WorkerAnswer> last_word;  // of a worker that did not, if there is one
  ProcessEnd end;
  std::string failure;  // why the answer is none, or a failure; else empty

  [[nodiscard]] bool interrupted() const { return end.kind == ProcessEnd::Kind::interrupted; }
};

std::string failure_of(const ProcessEnd& end, const WorkerLimits& limits) {
  switch (end.kind) {
    case ProcessEnd::Kind::timed_out:
      return fmt::format("timed out after {:g} s", limits.time);
    case ProcessEnd::Kind::interrupted:
      return "interrupted";
    case ProcessEnd::Kind::signalled:
      return "crashed: " + signal_name(end.code);
    case ProcessEnd::Kind::exited:
      break;
  }
  return fmt::format("ended by itself with exit code {} and no result", end.code);
}

/// An engine may end its process with exit code 0 in the middle of a check.
bool is_last(const WorkerAnswer& answer) {
  const auto* const check = std::get_if<CheckAnswer>(&answer);
  return check == nullptr || check->unfinished.empty();
}

WorkerRequest request_for(Task task, const std::filesystem::path& plugin,
                          const std::string& model) {
  WorkerRequest request;
  request.task = task;
  request.plugin = plugin.string();
  request.model = model;
  return request;
}

/// Sends `request` to a worker process and waits for its answer.
Exchange exchange(WorkerRequest request, const WorkerLimits& limits) {
  request.memory = limits.memory;
  Exchange result;
  const Descriptor input = memory_file(to_bytes(request));
  const Descriptor output = memory_file("");
  result.end = run_process({"/proc/self/exe", worker_command}, input, output, limits.time);
  const bool whole = result.end.kind == ProcessEnd::Kind::exited && result.end.code == 0;
  std::optional<WorkerAnswer> answer = answer_from(content_of(output));
  if (!whole || !answer || !is_last(*answer)) {
    result.last_word = std::move(answer);
    result.failure = failure_of(result.end, limits);
    return result;
  }
  if (const auto* const failure = std::get_if<Failure>(&*answer)) {
    result.failure = failure->sentence;
  }
  result.answer = std::move(answer);
  return result;
}

/// The answer to a request of its kind; null if it is none.
template <class Answer>
const Answer* answer_as(const std::optional<WorkerAnswer>& answer) {
  return answer ? std::get_if<Answer>(&*answer) : nullptr;
}

/// Repeats the run of `determinism` in another process, for what is seeded once in each: the claim
/// that holds within the first process is settled anew if the digests differ. False if the program
/// was told to stop.
bool settle_determinism(const WorkerRequest& check, const WorkerLimits& limits,
                        const std::string& digest, std::vector<SettledClaim>& claims) {
  const auto claim = std::find_if(claims.begin(), claims.end(), [](const SettledClaim& one) {
    return one.claim == "determinism" && one.holds;
  });
  if (claim == claims.end()) {
    return true;
  }
  WorkerRequest request = check;
  request.task = Task::digest;
  const Exchange other = exchange(std::move(request), limits);
  const auto* const answer = answer_as<DigestAnswer>(other.answer);
  if (answer == nullptr) {
    *claim = unmeasured("determinism", "the run in another process: " + other.failure);
  } else if (answer->digest != digest) {
    claim->holds = false;
    claim->found = std::numeric_limits<double>::infinity();
    claim->sentence = "not deterministic: in another process the same case runs otherwise";
  }
  return !other.interrupted();
}

}  // namespace

RunReply run_in_worker(const RunRequest& request) {
  RunReply reply;
  try {
    WorkerRequest asked = request_for(Task::run, request.plugin, request.model);
    asked.case_text = write_case(request.the_case);
    asked.settings = request.settings;
    Exchange other = exchange(std::move(asked), request.limits);
    reply.failure = other.failure;
    reply.output_tail = other.end.output_tail;
    reply.printed = other.end.printed;
    reply.interrupted = other.interrupted();
    if (other.answer && std::holds_alternative<RunAnswer>(*other.answer)) {
      auto& run = std::get<RunAnswer>(*other.answer);
      reply.cost = run.cost;
      reply.trajectory = std::move(run.trajectory);
    }
  } catch (const std::system_error& error) {
    reply.failure = std::string("cannot run a worker: ") + error.what();
  }
  return reply;
}

DescribeReply describe_in_worker(const std::filesystem::path& plugin, const WorkerLimits& limits) {
  const Exchange other = exchange(request_for(Task::describe, plugin, ""), limits);
  DescribeReply reply;
  reply.failure = other.failure;
  if (const auto* const info = answer_as<EngineInfo>(other.answer)) {
    reply.info = *info;
  }
  return reply;
}

StrikesReply strike_in_worker(const StrikesRequest& request) {
  WorkerRequest asked = request_for(Task::strikes, request.plugin, request.model);
  asked.settings = request.settings;
  asked.strikes = request.strikes;
  asked.restitution = request.restitution;
  const Exchange other = exchange(std::move(asked), request.limits);
  StrikesReply reply;
  reply.failure = other.failure;
  reply.interrupted = other.interrupted();
  if (const auto* const answer = answer_as<StrikesAnswer>(other.answer)) {
    reply.restitutions = answer->restitutions;
  }
  return reply;
}

CheckReply check_in_worker(const std::filesystem::path& plugin, const std::string& model,
                           const WorkerLimits& limits) {
  const WorkerRequest request = request_for(Task::check, plugin, model);
  const Exchange other = exchange(request, limits);
  CheckReply reply;
  reply.interrupted = other.interrupted();
  if (const auto* const answer = answer_as<CheckAnswer>(other.answer)) {
    reply.claims = answer->claims;
    reply.interrupted = !settle_determinism(request, limits, answer->digest, reply.claims);
  } else {
    std::string claim(claims().front().name);
    const auto* const last_word = answer_as<CheckAnswer>(other.last_word);
    if (last_word != nullptr && !last_word->unfinished.empty()) {
      claim = last_word->unfinished;
      reply.claims = last_word->claims;
    }
    reply.claims.push_back(unmeasured(claim, other.failure));
  }
  reply.claims.push_back(settle_quiet(other.end.printed, other.end.output_tail));
  return reply;
}

}  // namespace tautline::bench
