#include "bench/check/claims.hpp"

#include <array>

#include "bench/base/listed.hpp"
#include "bench/check/claims/measures.hpp"

namespace tautline::bench {
namespace {

constexpr bool spatial = true;

constexpr std::array all_claims = {
    Claim{"state-echo", "a run begins in the initial state it was given",
          "the rounding of the precision that the engine declares", measure_state_echo},
    Claim{"precision", "states keep the declared precision after every step",
          "one number in 2^29 is a float by chance", measure_precision},
    Claim{"flight", "a slack body flies the parabola or semi-implicit Euler, at any step",
          "an angle that is turned by an arctangent lags by 5.6e-4 rad", measure_flight},
    Claim{"fast-flight", "a body keeps its speed up to 10 m/s, and its spin up to 40 rad/s",
          "a thousandth, more than rounding; the cases that ship are no faster",
          measure_fast_flight},
    Claim{"slow-flight", "a body that nothing pulls keeps its speed, however slow",
          "a thousandth in 2.5 s, more than the rounding of its steps", measure_slow_flight},
    Claim{"mass", "an impulse moves the declared mass",
          "a contact of 20 steps turns the body meanwhile", measure_mass},
    Claim{"inertia", "an impulse turns the declared inertia",
          "a contact of 20 steps turns the body meanwhile", measure_inertia},
    Claim{"arm", "an impulse acts at the attachment at every angle",
          "a contact of 20 steps turns the body meanwhile", measure_arm},
    Claim{"angular-momentum", "a hit keeps the angular momentum about the anchor",
          "the same limit as for the inertia and the arm it comes from", measure_angular_momentum},
    Claim{"step-momentum", "the reported impulses are the change of momentum",
          "they may act anywhere in the step, in which a body turns", measure_step_momentum},
    Claim{"central-restitution", "a hit through the centre rebounds with the restitution",
          "gravity's part of a contact of 20 steps, and 0.02 for a spring's phase",
          measure_central_restitution},
    Claim{"off-centre-restitution", "so does one that turns the body",
          "the cable's turning in a contact of 20 steps, and 0.02 for a spring's phase",
          measure_off_centre_restitution},
    Claim{"slow-restitution", "so does one at any speed down to 0.02 m/s",
          "0.02 for the phase in which a spring begins and ends", measure_slow_restitution},
    Claim{"energy", "energy never rises, beyond what the scheme borrows and returns",
          "gravity's part of a contact of 20 steps", measure_energy},
    Claim{"overstretch", "a cable is stopped at its length",
          "one step late, or a spring contact of 20 steps", measure_overstretch},
    Claim{"taut-growth", "a cable that stays taut does not lengthen",
          "a tenth of what a cable held in its rate alone lengthens by", measure_taut_growth},
    Claim{"taut-turning", "a taut body turned without gravity keeps its energy and tension",
          "half of what a rule that brakes every step takes in 10 s", measure_taut_turning},
    Claim{"mirror-symmetry", "the mirrored case moves in the mirror",
          "what ten sweeps of a solver leave of the order of the cables", measure_mirror_symmetry},
    Claim{"determinism", "a second run is the same, bit by bit", "none: the same is the same",
          measure_determinism},
    Claim{"convergence", "smaller steps bring it to the exact motion, at first order",
          "a slope of 1, scattered by where an impact falls in its step", measure_convergence},
    Claim{"space-echo", "a system in space begins in the initial state it was given",
          "the rounding of the precision that the engine declares", measure_space_echo, spatial},
    Claim{"gyroscopic-term", "a free body turns in space as Euler's equations say",
          "the square of the turn in a step, in each step: a scheme of first order errs by less",
          measure_gyroscopic_term, spatial},
    Claim{"space-inertia", "an impulse turns the declared moment about each axis",
          "a contact of 20 steps turns the body meanwhile", measure_space_inertia, spatial},
    Claim{"space-arm", "an impulse acts at the attachment in every orientation",
          "a contact of 20 steps turns the body meanwhile", measure_space_arm, spatial},
    Claim{"pair-momentum", "a cable between two bodies keeps their momenta",
          "it may act anywhere in the step, in which the bodies turn", measure_pair_momentum,
          spatial},
    Claim{"pair-restitution", "a hit between two bodies rebounds with the restitution",
          "the cable's turning in a contact of 20 steps, and 0.02 for a spring's phase",
          measure_pair_restitution, spatial},
    Claim{"moving-anchor", "a body on an anchor of constant velocity moves as on one at rest",
          "a hit that is noticed a step sooner or later", measure_moving_anchor, spatial}};

}  // namespace

std::span<const Claim> claims() { return all_claims; }

const Claim* find_claim(std::string_view name) { return find_by(all_claims, &Claim::name, name); }

}  // namespace tautline::bench
