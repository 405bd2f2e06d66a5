// CVODE as its manual recommends for problems that are not stiff: Adams' methods, fixed-point
// iteration, roots of falling gaps alone (CVodeSetRootDirection), so that the root which a flight
// starts from is not found again.

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <stdexcept>

#include "flight_events.hpp"

namespace tautline::peers {
namespace {

constexpr long most_steps = 1'000'000;  // of one flight; CVODE's default is 500

int rate(double /*time*/, N_Vector state, N_Vector result, void* the_case) {
  const double* now = NV_DATA_S(state);
  double* rates = NV_DATA_S(result);
  std::copy_n(now + 3, 3, rates);
  const Vec2& gravity = static_cast<const Case*>(the_case)->gravity;
  rates[3] = gravity.x();
  rates[4] = gravity.y();
  rates[5] = 0.0;
  return 0;
}

int gaps(double /*time*/, N_Vector state, double* result, void* the_case) {
  for (const Cable& cable : static_cast<const Case*>(the_case)->cables) {
    *result++ = gap_at(cable, NV_DATA_S(state));
  }
  return 0;
}

class CvodePeer final : public Peer {
 public:
  CvodePeer() {
    SUNContext_Create(nullptr, &context_);
    state_ = N_VNew_Serial(6, context_);
    N_VConst(0.0, state_);
    memory_ = CVodeCreate(CV_ADAMS, context_);
    CVodeInit(memory_, rate, 0.0, state_);
    constexpr int acceleration = 0;  // of the fixed-point iteration: none, as the manual has it
    iteration_ = SUNNonlinSol_FixedPoint(state_, acceleration, context_);
    CVodeSetNonlinearSolver(memory_, iteration_);
    CVodeSetMaxNumSteps(memory_, most_steps);
    CVodeSetNoInactiveRootWarn(memory_);
  }
  ~CvodePeer() override {
    CVodeFree(&memory_);
    SUNNonlinSolFree(iteration_);
    N_VDestroy(state_);
    SUNContext_Free(&context_);
  }

  std::string name() const override { return "CVODE"; }
  std::string version() const override { return "SUNDIALS " SUNDIALS_VERSION; }
  std::string method() const override {
    return "Adams, fixed-point iteration, CVodeRootInit on the gaps, falling only";
  }

  std::vector<Located> impacts(const Case& the_case, const Stop& stop,
                               const Effort& effort) override {
    prepare(the_case, effort);
    return follow(the_case, stop, effort, [&](const State& state, double time) {
      return next(the_case, state, time, stop.horizon);
    });
  }

 private:
  void prepare(const Case& the_case, const Effort& effort) {
    const auto count = static_cast<int>(the_case.cables.size());
    CVodeSetUserData(memory_, const_cast<Case*>(&the_case));  // read alone
    CVodeSStolerances(memory_, effort.tolerance, effort.tolerance);
    CVodeSetMaxStep(memory_, effort.longest_step);
    if (count != roots_) {
      CVodeRootInit(memory_, count, gaps);
      std::array<int, max_cables> falling;
      falling.fill(-1);
      CVodeSetRootDirection(memory_, falling.data());
      roots_ = count;
    }
  }

  std::optional<Root> next(const Case& the_case, const State& state, double time, double horizon) {
    if (time >= horizon) {
      return std::nullopt;
    }
    const Numbers start = numbers_of(state);
    std::copy(start.begin(), start.end(), NV_DATA_S(state_));
    CVodeReInit(memory_, time, state_);
    CVodeSetStopTime(memory_, horizon);
    const int outcome = CVode(memory_, horizon, state_, &time, CV_NORMAL);
    if (outcome < 0) {
      throw std::runtime_error(std::string("CVode returns ") + CVodeGetReturnFlagName(outcome));
    }
    if (outcome != CV_ROOT_RETURN) {
      return std::nullopt;
    }
    std::array<int, max_cables> found{};
    CVodeGetRootInfo(memory_, found.data());
    Numbers reached;
    std::copy_n(NV_DATA_S(state_), reached.size(), reached.begin());
    Root result{time, state_of(reached), {}};
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
      if (found[index] != 0) {
        result.cables.insert(index);
      }
    }
    return result;
  }

  SUNContext context_ = nullptr;
  N_Vector state_ = nullptr;
  void* memory_ = nullptr;
  SUNNonlinearSolver iteration_ = nullptr;
  int roots_ = 0;
};

}  // namespace

std::unique_ptr<Peer> cvode_peer() { return std::make_unique<CvodePeer>(); }

}  // namespace tautline::peers
