#include "bench/run/protocol/children.hpp"

#include <algorithm>

#include "bench/base/process.hpp"

namespace tautline::bench {

template <class Request, class Answer>
auto Conversation::exchange(std::string_view method, const Request& request, const Answer& answer) {
  ++id_;
  try {
    return answer(child_.ask(request(id_), method), id_);
  } catch (const EngineRefusal&) {
    throw;
  } catch (...) {
    sound_ = false;
    throw;
  }
}

Conversation::Conversation(const KeptCommand& command)
    : child_(command), info_(exchange("info", info_request, info_answer)) {}

template <class TheCase>
ChildStart Conversation::start(const TheCase& the_case, const ChildModel& model,
                               const RunSettings& settings) {
  cables_ = the_case.cables.size();
  form_ = {};
  if constexpr (TheCase::has_several_bodies) {
    form_.bodies = the_case.bodies.size();
  }
  return exchange(
      "start", [&](int id) { return start_request(id, the_case, model, settings); },
      [&](std::string_view line, int id) { return start_answer(line, id, form_); });
}
template ChildStart Conversation::start(const Case&, const ChildModel&, const RunSettings&);
template ChildStart Conversation::start(const SpatialSystem&, const ChildModel&,
                                        const RunSettings&);

ChildSteps Conversation::step(double dt, std::size_t count) {
  return exchange(
      "step", [&](int id) { return step_request(id, dt, count); },
      [&](std::string_view line, int id) { return step_answer(line, id, cables_, count, form_); });
}

std::vector<double> Conversation::fly(double dt) {
  return exchange(
      "fly", [&](int id) { return fly_request(id, dt); },
      [&](std::string_view line, int id) { return state_answer(line, id, "fly", form_); });
}

template <class TheState>
std::vector<double> Conversation::place(const TheState& state) {
  return exchange(
      "place", [&](int id) { return place_request(id, state); },
      [&](std::string_view line, int id) { return state_answer(line, id, "place", form_); });
}
template std::vector<double> Conversation::place(const State&);
template std::vector<double> Conversation::place(const SpatialSystemState&);

ChildSolve Conversation::solve(CableSet cables, const CableVector& rates) {
  return exchange(
      "solve", [&](int id) { return solve_request(id, cables, rates); },
      [&](std::string_view line, int id) { return solve_answer(line, id, cables.size(), form_); });
}

double Children::processor_time() const {
  double sum = 0.0;
  for (const Process& process : processes_) {
    sum += processor_time_of(process.conversation->process());
  }
  return sum;
}

double Children::peak_memory() const {
  double most = 0.0;
  for (const Process& process : processes_) {
    most = std::max(most, peak_memory_of(process.conversation->process()));
  }
  return most;
}

void Children::forget_peak_memory() const {
  for (const Process& process : processes_) {
    forget_peak_memory_of(process.conversation->process());
  }
}

Conversation* Children::take() {
  const auto idle = std::find_if(processes_.begin(), processes_.end(),
                                 [](const Process& process) { return !process.busy; });
  if (idle != processes_.end()) {
    idle->busy = true;
    return idle->conversation.get();
  }
  processes_.push_back({std::make_unique<Conversation>(command_), true});
  return processes_.back().conversation.get();
}

void Children::give_back(Conversation* conversation) {
  const auto process = std::find_if(processes_.begin(), processes_.end(), [&](const Process& one) {
    return one.conversation.get() == conversation;
  });
  process->busy = false;
  if (!conversation->sound()) {
    processes_.erase(process);
  }
}

}  // namespace tautline::bench
