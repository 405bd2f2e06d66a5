// Runs every peer that was built in on the same problems, and prints one line of words and numbers
// with tabs between them for each thing measured: scripts/bench-peers makes tables of them.
//
//   peers ARCS ROUNDS               measures
//   peers --problems ARCS           prints the problems, for peers in other languages

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "measure.hpp"

namespace tautline::peers {
namespace {

constexpr std::uint64_t seed = 20240607;
constexpr std::size_t most = 12;  // impacts of a case
constexpr std::array tolerances = {1e-6, 1e-9, 1e-12};
/// [s]: the peer's own choice, and a hundredth of the unit of time.
constexpr std::array longest_steps = {0.0, 0.01};

std::vector<Effort> efforts_of(const Peer& peer) {
  if (!peer.has_effort()) {
    return {{tolerances.back(), 0.0}};
  }
  std::vector<Effort> result;
  for (const double longest : longest_steps) {
    for (const double tolerance : tolerances) {
      result.push_back({tolerance, longest});
    }
  }
  return result;
}

void print_row(const char* what, const Peer& peer, const Effort& effort) {
  std::printf("%s\t%s\t%g\t%g", what, peer.name().c_str(),
              peer.has_effort() ? effort.tolerance : 0.0, effort.longest_step);
}

struct Timed {
  Peer* peer;
  Effort effort;
  std::vector<double> nanoseconds;  // by round
  std::vector<double> ratios;       // to the first peer's in the same round
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Every peer and effort once a round, so that what else the machine does hits all alike.
void measure_cost(std::vector<Timed>& all, const std::vector<KnownMotion>& motions, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    for (Timed& timed : all) {
      timed.nanoseconds.push_back(cost(*timed.peer, motions, timed.effort));
      timed.ratios.push_back(timed.nanoseconds.back() / all.front().nanoseconds.back());
    }
  }
  for (const Timed& timed : all) {
    const Accuracy found = accuracy(*timed.peer, motions, timed.effort);
    print_row("cost", *timed.peer, timed.effort);
    std::printf("\t%.4g\t%.4g\t%.3g\t%.3g\t%zu\t%zu\n", median(timed.ratios),
                median(timed.nanoseconds), found.first, found.median, found.followed, found.of);
  }
}

void count_missed(Peer& peer, const Effort& effort, const std::vector<Graze>& arcs) {
  const Missed found = missed(peer, arcs, effort);
  print_row("missed", peer, effort);
  for (std::size_t band = 0; band < depth_bands.size(); ++band) {
    std::printf("\t%zu\t%zu", found.missed[band], found.of[band]);
  }
  std::printf("\n");
}

void measure(std::size_t arcs, int rounds) {
  const std::vector<KnownMotion> motions = known_motions(most);
  const std::vector<std::unique_ptr<Peer>> peers = all_peers();
  std::printf("problems\t%zu\t%zu\t%zu\t%llu\n", motions.size(), most, arcs,
              static_cast<unsigned long long>(seed));
  std::vector<Timed> all;
  for (const auto& peer : peers) {
    std::printf("peer\t%s\t%s\t%s\n", peer->name().c_str(), peer->version().c_str(),
                peer->method().c_str());
    for (const Effort& effort : efforts_of(*peer)) {
      all.push_back({peer.get(), effort, {}, {}});
    }
  }
  measure_cost(all, motions, rounds);
  std::fflush(stdout);
  const std::vector<Graze> drawn = grazes(arcs, seed);
  for (const Timed& timed : all) {
    count_missed(*timed.peer, timed.effort, drawn);
    std::fflush(stdout);
  }
}

/// The numbers of a case on a line: body, gravity, start; and of each cable on one more.
void print_case(const Case& the_case) {
  const State& start = the_case.initial;
  std::printf("%s\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%zu\n",
              the_case.name.c_str(), the_case.body.mass, the_case.body.inertia,
              the_case.gravity.x(), the_case.gravity.y(), start.position.x(), start.position.y(),
              start.angle, start.velocity.x(), start.velocity.y(), start.spin,
              the_case.cables.size());
  for (const Cable& cable : the_case.cables) {
    std::printf("cable\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\n", cable.anchor.x(),
                cable.anchor.y(), cable.attachment.x(), cable.attachment.y(), cable.length,
                cable.restitution);
  }
}

void print_problems(std::size_t arcs) {
  for (const KnownMotion& motion : known_motions(most)) {
    std::printf("motion\t%.17g\t%zu\t", motion.stop.horizon, motion.stop.most);
    print_case(motion.the_case);
    for (const Located& impact : motion.impacts) {
      std::printf("impact\t%.17g", impact.time);
      for (const std::size_t index : impact.cables) {
        std::printf("\t%zu", index);
      }
      std::printf("\n");
    }
  }
  for (const Graze& arc : grazes(arcs, seed)) {
    std::printf("graze\t%.17g\t%.17g\t%.17g\t", arc.deepest, arc.depth, arc.width);
    print_case(arc.the_case);
  }
}

}  // namespace
}  // namespace tautline::peers

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "peers: expected ARCS ROUNDS, or --problems ARCS\n");
    return 2;
  }
  const bool export_only = std::string_view(argv[1]) == "--problems";
  const auto arcs = static_cast<std::size_t>(std::strtoul(argv[export_only ? 2 : 1], nullptr, 10));
  try {
    if (export_only) {
      tautline::peers::print_problems(arcs);
    } else {
      tautline::peers::measure(arcs, std::max(1, std::atoi(argv[2])));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peers: %s\n", error.what());
    return 1;
  }
}
