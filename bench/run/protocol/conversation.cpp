#include "bench/run/protocol/conversation.hpp"

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

ChildStart Conversation::start(const Case& the_case, const ChildModel& model,
                               const RunSettings& settings) {
  cables_ = the_case.cables.size();
  return exchange(
      "start", [&](int id) { return start_request(id, the_case, model, settings); }, start_answer);
}

ChildSteps Conversation::step(double dt, std::size_t count) {
  return exchange(
      "step", [&](int id) { return step_request(id, dt, count); },
      [&](std::string_view line, int id) { return step_answer(line, id, cables_, count); });
}

State Conversation::fly(double dt) {
  return exchange(
      "fly", [&](int id) { return fly_request(id, dt); },
      [](std::string_view line, int id) { return state_answer(line, id, "fly"); });
}

State Conversation::place(const State& state) {
  return exchange(
      "place", [&](int id) { return place_request(id, state); },
      [](std::string_view line, int id) { return state_answer(line, id, "place"); });
}

ChildSolve Conversation::solve(CableSet cables, const CableVector& rates) {
  return exchange(
      "solve", [&](int id) { return solve_request(id, cables, rates); },
      [&](std::string_view line, int id) { return solve_answer(line, id, cables.size()); });
}

}  // namespace tautline::bench
