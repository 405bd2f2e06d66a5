#include "bench/run/worker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "bench/base/text.hpp"
#include "bench/check/claims.hpp"
#include "bench/run/wire.hpp"
#include "tautline/case_file.hpp"

namespace tautline::bench {
namespace {

std::string failure_of(const ProcessEnd& end, double time_limit) {
  switch (end.kind) {
    case ProcessEnd::Kind::timed_out:
      return fmt::format("timed out after {:g} s", time_limit);
    case ProcessEnd::Kind::interrupted:
      return "interrupted";
    case ProcessEnd::Kind::signalled:
      return "crashed: " + signal_name(end.code);
    case ProcessEnd::Kind::exited:
    case ProcessEnd::Kind::answered:
      break;
  }
  return fmt::format("ended by itself with exit code {} and no result", end.code);
}

/// True for "TypeError: …" and "Error [ERR_MODULE_NOT_FOUND]: …", as Python and node begin the line
/// that says what went wrong.
bool names_an_error(std::string_view line) {
  const auto of_a_name = [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '.' || letter == '_';
  };
  const auto end = std::find_if_not(line.begin(), line.end(), of_a_name);
  const std::string_view name = line.substr(0, static_cast<std::size_t>(end - line.begin()));
  return name.ends_with("Error") && (end == line.end() || *end == ':' || *end == ' ');
}

constexpr std::size_t longest_quote = 200;  // [bytes] of a line; a longer one is code

/// Of what an engine printed before it failed, the line that says most: the first that names an
/// error, or the last. Empty if there is none.
std::string telling_line(const std::string& output) {
  std::istringstream lines(output);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (names_an_error(line)) {
      return line;
    }
    if (line.size() <= longest_quote && line.find_first_not_of(" \t\r") != std::string::npos) {
      last = line;
    }
  }
  return last;
}

/// The failure of a process, and what that said before.
std::string with_its_words(const std::string& failure, const ProcessEnd& end) {
  const std::string line = telling_line(end.output_tail);
  return line.empty() ? failure : failure + "; it printed: " + printable(line, longest_quote);
}

/// An engine may end its process with exit code 0 in the middle of a check.
bool is_last(const WorkerAnswer& answer) {
  const auto* const check = std::get_if<CheckAnswer>(&answer);
  return check == nullptr || check->unfinished.empty();
}

/// What a worker left, and whether it can be believed.
Exchange exchange_of(ProcessEnd end, std::optional<WorkerAnswer> answer, double time_limit) {
  Exchange result;
  result.end = std::move(end);
  const bool whole = result.end.kind == ProcessEnd::Kind::answered ||
                     (result.end.kind == ProcessEnd::Kind::exited && result.end.code == 0);
  if (!whole || !answer || !is_last(*answer)) {
    result.last_word = std::move(answer);
    result.failure = failure_of(result.end, time_limit);
    if (result.end.kind == ProcessEnd::Kind::exited ||
        result.end.kind == ProcessEnd::Kind::signalled) {
      result.failure = with_its_words(result.failure, result.end);
    }
    return result;
  }
  if (const auto* const failure = std::get_if<Failure>(&*answer)) {
    result.failure =
        failure->of_process ? with_its_words(failure->sentence, result.end) : failure->sentence;
  }
  result.answer = std::move(answer);
  return result;
}

}  // namespace

/// A worker process and the ways to talk to it.
class Workplace::Worker {
 public:
  explicit Worker(const WorkerRequest& first) : plugin_(first.plugin), memory_(first.memory) {}

  /// True if it may obey `request` after what it has done.
  [[nodiscard]] bool suits(const WorkerRequest& request) const {
    return request.plugin == plugin_ && request.memory == memory_;
  }

  [[nodiscard]] Exchange exchange(const WorkerRequest& request, double time_limit) {
    fill(input_, to_bytes(request));
    fill(output_, "");
    (void)::send(turns_.ours.get(), "", 1, MSG_NOSIGNAL);  // one that is gone says so by its end
    ProcessEnd end = process_.wait(turns_.ours, time_limit);
    return exchange_of(std::move(end), answer_from(content_of(output_)), time_limit);
  }

 private:
  struct Turns {
    Turns() {
      auto [one, other] = make_socket(SOCK_STREAM);
      ours = std::move(one);
      // above all that a worker has, so that nothing takes its place while it is moved there
      of_the_worker = Descriptor(::fcntl(other.get(), F_DUPFD_CLOEXEC, turn_descriptor + 1));
    }

    Descriptor ours;
    Descriptor of_the_worker;
  };

  std::string plugin_;
  std::size_t memory_;  // [bytes]
  Descriptor input_ = memory_file();
  Descriptor output_ = memory_file();
  Turns turns_;
  Process process_{{"/proc/self/exe", worker_command}, input_, output_, turns_.of_the_worker};
};

Workplace::Workplace() = default;
Workplace::~Workplace() = default;

Exchange Workplace::exchange(const WorkerRequest& request, double time_limit) {
  std::unique_ptr<Worker> worker = std::move(waiting_);
  if (!worker || !worker->suits(request)) {
    worker.reset();  // before the next: no more than one at a time
    worker = std::make_unique<Worker>(request);
  }
  Exchange result = worker->exchange(request, time_limit);
  if (result.end.kind == ProcessEnd::Kind::answered) {
    waiting_ = std::move(worker);
  }
  return result;
}

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
/// that holds within the first process is settled again if the digests differ. False if the program
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

namespace {

std::optional<Trajectory>& motion_of(RunReply& reply, const Case& /*the_case*/) {
  return reply.trajectory;
}
std::optional<SystemTrajectory>& motion_of(RunReply& reply, const SpatialSystem& /*system*/) {
  return reply.in_space;
}

bool is_of(const Case& /*the_case*/, const State& /*state*/) { return true; }
bool is_of(const SpatialSystem& system, const SpatialSystemState& state) {
  return state.bodies.size() == system.bodies.size();
}

/// True where `run` can be one of `the_case`.
template <class TheCase>
bool is_of(const TheCase& the_case, const BasicTrajectory<TheCase>& run) {
  const std::size_t cables = the_case.cables.size();
  return (run.tensions.empty() || run.tensions.size() == run.points.size() * cables) &&
         std::all_of(run.points.begin(), run.points.end(),
                     [&](const auto& point) { return is_of(the_case, point.state); }) &&
         std::all_of(run.impacts.begin(), run.impacts.end(), [&](const auto& impact) {
           return impact.cable < cables && is_of(the_case, impact.before) &&
                  is_of(the_case, impact.after);
         });
}

/// Puts the run of `the_case` that `answer` is into `reply`, if it is one.
template <class TheCase>
void take_run(const TheCase& the_case, std::optional<WorkerAnswer>& answer, RunReply& reply) {
  auto* const run = answer ? std::get_if<BasicRunAnswer<TheCase>>(&*answer) : nullptr;
  if (run != nullptr && is_of(the_case, run->trajectory)) {
    reply.cost = run->cost;
    motion_of(reply, the_case) = std::move(run->trajectory);
  }
}

}  // namespace

RunReply run_in_worker(const RunRequest& request, Workplace& workplace) {
  RunReply reply;
  try {
    WorkerRequest asked = request_for(Task::run, request.plugin, request.model, request.limits);
    asked.case_text = written(request.the_case);
    asked.settings = request.settings;
    asked.costs = request.costs;
    asked.more = request.more;
    Exchange other = workplace.exchange(asked, request.limits.time);
    reply.failure = other.failure;
    reply.output_tail = other.end.output_tail;
    reply.printed = other.end.printed;
    reply.interrupted = other.interrupted();
    std::visit([&](const auto& the_case) { take_run(the_case, other.answer, reply); },
               request.the_case);
    if (reply.failure.empty() && !reply.trajectory && !reply.in_space && !reply.interrupted) {
      reply.failure = "gave a result that makes no sense";
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
    reply.law = answer->law;
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
