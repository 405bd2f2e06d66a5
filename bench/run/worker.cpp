#include "bench/run/worker.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>
#include <algorithm>
#include <csignal>
#include <ctime>
#include <exception>
#include <limits>
#include <new>
#include <system_error>

#include "bench/base/process.hpp"
#include "bench/cases/case_file.hpp"
#include "bench/cases/case_writer.hpp"
#include "bench/run/plugin.hpp"
#include "bench/run/wire.hpp"
#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

constexpr int request_descriptor = 0;
constexpr int reply_descriptor = 3;

/// The key of a reply that is not the last: an engine may end this process with exit code 0.
constexpr const char* unfinished_claim = "unfinished claim";

/// The key of the digest of the run that `determinism` repeats.
constexpr const char* digest_key = "digest";

/// The most steps that are timed: enough to average over impacts, cheap next to the run itself.
constexpr std::size_t timed_steps = 20'000;

/// Processor time of this thread [s].
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A second run that is only started and stepped, and beside it as many closed-form flights with
/// their gaps.
Cost measure_cost(const Case& the_case, const Engine& engine, const std::string& model,
                  const RunSettings& settings) {
  const double step = settings.step;
  const double start = processor_time();
  const auto simulation = engine.start(the_case, model, settings);
  const auto whole_steps = static_cast<std::size_t>(the_case.duration / step);
  const std::size_t steps = std::max<std::size_t>(1, std::min(whole_steps, timed_steps));
  const double dt = std::min(step, the_case.duration);
  std::size_t done = 0;
  for (; done < steps && !simulation->stopped(); ++done) {
    simulation->step(dt);
  }
  const double middle = processor_time();
  double sum = 0.0;
  for (std::size_t index = 0; index < done; ++index) {
    const State state = fly(the_case.initial, the_case.gravity, static_cast<double>(index) * dt);
    for (const Cable& cable : the_case.cables) {
      sum += gap(cable, state);
    }
  }
  const double end = processor_time();
  [[maybe_unused]] const volatile double keep = sum;  // the loop must not be optimised away
  const auto count = static_cast<double>(std::max<std::size_t>(1, done));
  return {(middle - start) / count, peak_memory(), (end - middle) / count};
}

/// Writes a message in place of the one before, which was never longer. False where it cannot.
bool write_reply(const Message& reply) {
  ::lseek(reply_descriptor, 0, SEEK_SET);
  const std::string text = to_bytes(reply);
  for (std::string_view bytes = text; !bytes.empty();) {
    const ssize_t size = ::write(reply_descriptor, bytes.data(), bytes.size());
    if (size <= 0) {
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(size));
  }
  return true;
}

ImpactLaw impact_law(const std::string& name) {
  const auto law = std::find_if(impact_laws.begin(), impact_laws.end(),
                                [&](ImpactLaw known) { return to_string(known) == name; });
  if (law == impact_laws.end()) {
    throw std::invalid_argument("impact law " + name + " is unknown");
  }
  return *law;
}

Message do_run(const ordered_json& request, const Plugin& plugin) {
  const auto reading = read_case_text(request.at("case").get<std::string>(), "request");
  const Case& the_case = reading.the_case.value();
  const std::string model = request.at("model");
  const RunSettings settings{request.at("step"), impact_law(request.at("law"))};
  const auto simulation = plugin.engine().start(the_case, model, settings);
  Message reply = trajectory_message(record(the_case, *simulation, settings.step));
  const Cost cost = measure_cost(the_case, plugin.engine(), model, settings);
  reply.head["cost"] = {cost.step, cost.memory, cost.reference};
  return reply;
}

/// Says before each claim which one it is: the program reads that should this process die of it.
Message do_check(const std::string& model, const Plugin& plugin) {
  const auto progress = [](std::string_view claim, const std::vector<Finding>& findings) {
    static_cast<void>(
        write_reply({{{unfinished_claim, claim}, {"findings", findings_json(findings)}}, {}}));
  };
  Message reply{{{"findings", findings_json(check_model(plugin.engine(), model, progress))}}, {}};
  try {
    reply.head[digest_key] = run_digest(plugin.engine(), model);
  } catch (const std::exception&) {  // a finding by now
    return reply;
  }
  return reply;
}

Message obey(const ordered_json& request) {
  const Plugin plugin = Plugin::open(request.at("plugin").get<std::string>());
  if (request.contains("case")) {
    return do_run(request, plugin);
  }
  if (request.contains("check")) {
    return do_check(request.at("check"), plugin);
  }
  if (request.contains(digest_key)) {
    return {{{digest_key, run_digest(plugin.engine(), request.at(digest_key))}}, {}};
  }
  return {engine_json(plugin.engine().info()), {}};
}

void limit_this_process(std::size_t memory) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a killed program leaves no workers behind
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
#ifndef TAUTLINE_SANITIZED  // whose shadow memory is terabytes of address space
  const rlimit space{memory, memory};
  ::setrlimit(RLIMIT_AS, &space);
#else
  (void)memory;
#endif
}

/// Sends a request to a worker process; the reply, or what went wrong.
struct Exchange {
  std::optional<Message> message;
  std::optional<Message> unfinished;  // the last word of a worker that did not come to its end
  std::string failure;
  ProcessEnd end;
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

Exchange exchange(const ordered_json& request, const WorkerLimits& limits) {
  Exchange result;
  const Descriptor input = memory_file(request.dump());
  const Descriptor output = memory_file("");
  result.end = run_process({"/proc/self/exe", worker_command}, input, output, limits.time);
  const bool whole = result.end.kind == ProcessEnd::Kind::exited && result.end.code == 0;
  std::optional<Message> message = from_bytes(content_of(output));
  const bool last = whole && message && !message->head.contains(unfinished_claim);
  (last ? result.message : result.unfinished) = std::move(message);
  if (!result.message) {
    result.failure = failure_of(result.end, limits);
  } else if (result.message->head.contains("failure")) {
    result.failure = result.message->head.at("failure");
    result.message.reset();
  }
  return result;
}

}  // namespace

RunReply run_in_worker(const RunRequest& request) {
  RunReply reply;
  try {
    const Exchange answer = exchange({{"plugin", request.plugin.string()},
                                      {"case", write_case(request.the_case)},
                                      {"model", request.model},
                                      {"step", request.settings.step},
                                      {"law", to_string(request.settings.law)},
                                      {"memory", request.limits.memory}},
                                     request.limits);
    reply.failure = answer.failure;
    reply.output_tail = answer.end.output_tail;
    reply.printed = answer.end.printed;
    reply.interrupted = answer.end.kind == ProcessEnd::Kind::interrupted;
    if (answer.message) {
      const ordered_json& cost = answer.message->head.at("cost");
      reply.cost = {cost.at(0), cost.at(1), cost.at(2)};
      reply.trajectory = trajectory_from(*answer.message);
    }
  } catch (const std::system_error& error) {
    reply.failure = std::string("cannot run a worker: ") + error.what();
  } catch (const ordered_json::exception&) {
    reply.failure = "gave a result that makes no sense";
  }
  return reply;
}

DescribeReply describe_in_worker(const std::filesystem::path& plugin, const WorkerLimits& limits) {
  const Exchange answer =
      exchange({{"plugin", plugin.string()}, {"memory", limits.memory}}, limits);
  DescribeReply reply;
  reply.failure = answer.failure;
  if (answer.message) {
    reply.info = engine_from(answer.message->head);
  }
  return reply;
}

namespace {

/// Repeats the run of `determinism` in another process, for what is seeded once in each: the claim
/// that holds within the first process is settled anew if the digests differ. False if the program
/// was told to stop.
bool settle_determinism(const std::filesystem::path& plugin, const std::string& model,
                        const WorkerLimits& limits, const std::string& digest,
                        std::vector<Finding>& findings) {
  const auto finding = std::find_if(findings.begin(), findings.end(), [](const Finding& one) {
    return one.claim == "determinism" && one.holds;
  });
  if (finding == findings.end()) {
    return true;
  }
  const Exchange answer = exchange(
      {{"plugin", plugin.string()}, {digest_key, model}, {"memory", limits.memory}}, limits);
  if (!answer.message) {
    *finding = unmeasured("determinism", "the run in another process: " + answer.failure);
  } else if (answer.message->head.at(digest_key) != digest) {
    finding->holds = false;
    finding->found = std::numeric_limits<double>::infinity();
    finding->sentence = "not deterministic: in another process the same case runs otherwise";
  }
  return answer.end.kind != ProcessEnd::Kind::interrupted;
}

}  // namespace

CheckReply check_in_worker(const std::filesystem::path& plugin, const std::string& model,
                           const WorkerLimits& limits) {
  const Exchange answer =
      exchange({{"plugin", plugin.string()}, {"check", model}, {"memory", limits.memory}}, limits);
  CheckReply reply;
  reply.interrupted = answer.end.kind == ProcessEnd::Kind::interrupted;
  if (answer.message) {
    reply.findings = findings_from(answer.message->head.at("findings"));
    const std::string digest = answer.message->head.value(digest_key, "");
    reply.interrupted = !settle_determinism(plugin, model, limits, digest, reply.findings);
  } else {
    std::string claim(claims().front().name);
    if (answer.unfinished && answer.unfinished->head.contains(unfinished_claim)) {
      claim = answer.unfinished->head.at(unfinished_claim);
      reply.findings = findings_from(answer.unfinished->head.at("findings"));
    }
    reply.findings.push_back(unmeasured(claim, answer.failure));
  }
  reply.findings.push_back(quiet(answer.end.printed, answer.end.output_tail));
  return reply;
}

int worker_main() {
  Message reply;
  try {
    const auto request = ordered_json::parse(content_of(Descriptor(::dup(request_descriptor))));
    limit_this_process(request.at("memory"));
    reply = obey(request);
  } catch (const std::bad_alloc&) {
    reply = {{{"failure", "ran out of memory"}}, {}};
  } catch (const std::exception& error) {
    reply = {{{"failure", error.what()}}, {}};
  }
  if (::ftruncate(reply_descriptor, 0) != 0 || !write_reply(reply)) {
    return 1;
  }
  std::fflush(nullptr);
  ::_exit(0);  // without static destructors: an engine has nothing to say any more
}

}  // namespace tautline::bench
