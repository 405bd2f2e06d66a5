#include "bench/run/worker.hpp"

#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>
#include <variant>

#include "bench/check/claims.hpp"
#include "bench/run/wire.hpp"
#include "bench/run/workplace.hpp"
#include "tautline/case_file.hpp"

namespace tautline::bench {
namespace {

WorkerRequest request_for(Task task, const std::filesystem::path& plugin, const std::string& model,
                          const WorkerLimits& limits) {
  WorkerRequest request;
  request.task = task;
  request.memory = limits.memory;
  request.plugin = plugin.string();
  request.model = model;
  return request;
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
  const Exchange other = Workplace().exchange(request, limits.time);
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

RunReply run_in_worker(const RunRequest& request, Workplace& workplace) {
  RunReply reply;
  try {
    WorkerRequest asked = request_for(Task::run, request.plugin, request.model, request.limits);
    asked.case_text = write_case(request.the_case);
    asked.settings = request.settings;
    asked.costs = request.costs;
    asked.more = request.more;
    Exchange other = workplace.exchange(asked, request.limits.time);
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
  const Exchange other =
      Workplace().exchange(request_for(Task::describe, plugin, "", limits), limits.time);
  DescribeReply reply;
  reply.failure = other.failure;
  if (const auto* const info = answer_as<EngineInfo>(other.answer)) {
    reply.info = *info;
  }
  return reply;
}

StrikesReply strike_in_worker(const StrikesRequest& request, Workplace& workplace) {
  WorkerRequest asked = request_for(Task::strikes, request.plugin, request.model, request.limits);
  asked.settings = request.settings;
  asked.strikes = request.strikes;
  asked.restitution = request.restitution;
  const Exchange other = workplace.exchange(asked, request.limits.time);
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
  const WorkerRequest request = request_for(Task::check, plugin, model, limits);
  const Exchange other = Workplace().exchange(request, limits.time);
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
