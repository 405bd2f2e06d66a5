#include "peer.hpp"
#include "tautline/solve.hpp"

namespace tautline::peers {
namespace {

class ExactPeer final : public Peer {
 public:
  std::string name() const override { return "tautline"; }
  std::string version() const override { return "this source"; }
  std::string method() const override { return "solve: closed form of flight, guaranteed search"; }
  bool has_effort() const override { return false; }

  std::vector<Located> impacts(const Case& the_case, const Stop& stop,
                               const Effort& /*effort*/) override {
    Case until = the_case;
    until.duration = stop.horizon;
    SolveOptions options;
    options.max_events = stop.most;
    std::vector<Located> result;
    const Solution solution = solve(until, options);
    for (const Event& event : solution.events()) {
      if (event.kind == EventKind::impact) {
        result.push_back({event.time, event.cables});
      }
    }
    return result;
  }
};

}  // namespace

std::unique_ptr<Peer> exact_peer() { return std::make_unique<ExactPeer>(); }

}  // namespace tautline::peers
