#include "bench/run/wire.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "bench/base/process.hpp"
#include "bench/cases/bench_case.hpp"
#include "bench/check/claims/measures.hpp"
#include "bench/check/settle.hpp"
#include "bench/check/strike.hpp"
#include "bench/run/cost.hpp"
#include "bench/run/plugin.hpp"
#include "bench/run/protocol/messages.hpp"
#include "bench/run/record.hpp"
#include "tautline/case_file.hpp"

namespace tautline::bench {
namespace {

/// Writes an answer in place of the one before, which was never longer. False where it cannot.
bool write_answer(const WorkerAnswer& answer) {
  ::lseek(answer_descriptor, 0, SEEK_SET);
  return write_all(answer_descriptor, to_bytes(answer)) == 0;
}

template <class TheCase>
BasicRunAnswer<TheCase> run_of(const TheCase& the_case, const WorkerRequest& request,
                               const Plugin& plugin) {
  const Engine& engine = plugin.engine();
  BasicRunAnswer<TheCase> answer;
  plugin.forget_peak_memory();
  {
    const auto simulation = started(engine, the_case, request.model, request.settings);
    answer.trajectory = record(the_case, *simulation, request.settings.step);
  }  // over before its cost is measured: an engine outside then goes on in the process it has
  if (request.costs) {
    answer.cost = measure_cost(the_case, engine, request.model, request.settings, plugin.meter());
  }
  return answer;
}

WorkerAnswer do_run(const WorkerRequest& request, const Plugin& plugin) {
  return std::visit([&](const auto& one) { return WorkerAnswer(run_of(one, request, plugin)); },
                    bench_case_from(request.case_text, "request"));
}

/// Says before each claim which one it is: the program reads that should this process die of it.
CheckAnswer do_check(const std::string& model, const Engine& engine) {
  const auto progress = [](std::string_view claim, const std::vector<SettledClaim>& settled) {
    static_cast<void>(write_answer(CheckAnswer{settled, std::string(claim), ""}));
  };
  CheckAnswer answer{check_model(engine, model, progress), "", ""};
  try {
    answer.digest = run_digest(engine, model);
  } catch (const std::exception&) {  // it broke a claim by now
    return answer;
  }
  return answer;
}

/// The law of the cable of a strike; none where it is no spring and damper, or nothing is struck.
std::optional<SoftRow> law_of_strike(const WorkerRequest& request, const Engine& engine) {
  const Strike strike = request.strikes.empty() ? Strike() : request.strikes.front();
  const Case the_case = struck_case(strike, request.restitution, request.settings.step, 0.0);
  try {
    const auto simulation = engine.start(the_case, request.model, request.settings);
    const std::vector<SoftRow> rows = soft_rows_of(the_case, *simulation);
    return rows.empty() ? std::nullopt : std::optional(rows.front());
  } catch (const std::exception&) {  // no strike has a number then, which says it
    return std::nullopt;
  }
}

StrikesAnswer do_strikes(const WorkerRequest& request, const Engine& engine) {
  return {restitutions_of(Subject(engine, request.model, request.settings.parameters),
                          request.strikes, request.settings.step, request.restitution),
          law_of_strike(request, engine)};
}

/// Opens the plug-in of the first request; a worker has no other.
WorkerAnswer obey(const WorkerRequest& request, std::optional<Plugin>& plugin) {
  if (!plugin) {
    plugin = Plugin::open(request.plugin, request.memory);
  }
  switch (request.task) {
    case Task::describe:
      break;
    case Task::run:
      return do_run(request, *plugin);
    case Task::check:
      return do_check(request.model, plugin->engine());
    case Task::digest:
      return DigestAnswer{run_digest(plugin->engine(), request.model)};
    case Task::strikes:
      return do_strikes(request, plugin->engine());
  }
  return plugin->engine().info();
}

void limit_this_process(std::size_t memory) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a killed program leaves no workers behind
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
#ifndef TAUTLINE_SANITIZED  // whose shadow memory is terabytes of address space
  // the most that may be asked for stays: an engine's own process is limited in what it holds
  limit_address_space(memory);
#else
  (void)memory;
#endif
}

/// `more` is set where another request is to follow.
WorkerAnswer answer_to_request(std::optional<Plugin>& plugin, bool& more) {
  try {
    const WorkerRequest request = request_from(content_of(Descriptor(::dup(request_descriptor))));
    more = request.more;
    limit_this_process(request.memory);
    return obey(request, plugin);
  } catch (const std::bad_alloc&) {
    return Failure{"ran out of memory"};
  } catch (const EngineEnded& error) {
    return Failure{error.what(), true};
  } catch (const std::exception& error) {
    return Failure{error.what()};
  }
}

/// False where the program is gone, or wants no more.
bool is_our_turn() {
  char byte = 0;
  return ::read(turn_descriptor, &byte, 1) == 1;
}

/// True after what the engine may be asked again and again, and did well.
bool stays(const WorkerAnswer& answer) {
  return std::holds_alternative<RunAnswer>(answer) ||
         std::holds_alternative<SystemRunAnswer>(answer) ||
         std::holds_alternative<StrikesAnswer>(answer);
}

void give_turn_back() { (void)::send(turn_descriptor, "", 1, MSG_NOSIGNAL); }

}  // namespace

int worker_main() {
  for (std::optional<Plugin> plugin; is_our_turn(); give_turn_back()) {
    bool more = false;
    const WorkerAnswer answer = answer_to_request(plugin, more);
    if (::ftruncate(answer_descriptor, 0) != 0 || !write_answer(answer)) {
      return 1;
    }
    std::fflush(nullptr);
    if (!stays(answer) || !(more || plugin->has_a_process())) {
      break;
    }
  }
  ::_exit(0);  // without static destructors: an engine has nothing to say any more
}

}  // namespace tautline::bench
