#include <array>
#include <cstddef>
#include <string>

#include "bench/run/protocol/messages.hpp"
#include "bench/run/wire.hpp"
#include "fuzz/targets.hpp"

namespace tautline::fuzz {
namespace {

constexpr int id = 1;  // every request has it
constexpr std::size_t cables = 2;
constexpr std::size_t steps = 3;
constexpr bench::StateForm in_space{2};  // two bodies

using Read = void (*)(std::string_view);

/// The readers that the first byte chooses, from 'a' on.
constexpr std::array<Read, 10> readings = {
    [](std::string_view line) {
      const bench::ChildInfo info = bench::info_answer(line, id);
      require(!info.name.empty() && !info.models.empty(), "an engine has a name and a model");
    },
    [](std::string_view line) { static_cast<void>(bench::start_answer(line, id)); },
    [](std::string_view line) {
      const bench::ChildSteps done = bench::step_answer(line, id, cables, steps);
      require(done.count() == steps || (done.count() < steps && done.stopped),
              "as many steps as asked, or the reason");
    },
    [](std::string_view line) { static_cast<void>(bench::state_answer(line, id, "fly")); },
    [](std::string_view line) {
      const bench::ChildSolve solved = bench::solve_answer(line, id, cables);
      require(solved.impulses.size() == cables && solved.impulses.minCoeff() >= 0.0, "cables pull");
    },
    [](std::string_view bytes) {
      if (const auto answer = bench::answer_from(bytes)) {
        static_cast<void>(bench::answer_from(bench::to_bytes(*answer)).value());
      }
    },
    [](std::string_view line) {
      require(bench::start_answer(line, id, in_space).state.size() == in_space.width(),
              "a state of two bodies");
    },
    [](std::string_view line) {
      const bench::ChildSteps done = bench::step_answer(line, id, cables, steps, in_space);
      require(done.width == in_space.width() + cables, "states of two bodies, and impulses");
    },
    [](std::string_view line) {
      const std::vector<double> state = bench::state_answer(line, id, "fly", in_space);
      require(bench::state_from(state.data(), in_space.bodies, 0.0).bodies.size() == 2,
              "a state of two bodies");
    },
    [](std::string_view line) {
      const bench::ChildSolve solved = bench::solve_answer(line, id, cables, in_space);
      require(solved.impulses.minCoeff() >= 0.0, "cables pull");
    },
};

}  // namespace

void fuzz_protocol(std::string_view input) {
  const std::size_t which =
      input.empty() ? readings.size() : static_cast<std::size_t>(input[0] - 'a');
  if (which >= readings.size()) {
    return;
  }
  std::string refused;
  try {
    readings[which](input.substr(1));
    return;
  } catch (const bench::ProtocolError& error) {
    refused = error.what();
  } catch (const bench::EngineRefusal& refusal) {
    refused = refusal.what();
  }
  require_sentences({refused}, true);
}

}  // namespace tautline::fuzz
