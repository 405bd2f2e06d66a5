#include "peer.hpp"

namespace tautline::peers {

std::vector<std::unique_ptr<Peer>> all_peers() {
  std::vector<std::unique_ptr<Peer>> result;
  result.push_back(exact_peer());
#ifdef TAUTLINE_PEER_CVODE
  result.push_back(cvode_peer());
#endif
#ifdef TAUTLINE_PEER_ODEINT
  result.push_back(odeint_peer());
#endif
#ifdef TAUTLINE_PEER_SICONOS
  result.push_back(siconos_peer());
#endif
#ifdef TAUTLINE_PEER_SIMBODY
  result.push_back(simbody_peer());
#endif
  return result;
}

}  // namespace tautline::peers
