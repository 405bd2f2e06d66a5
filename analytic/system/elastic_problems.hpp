#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "sentences.hpp"
#include "system/kernel.hpp"
#include "system/least_value.hpp"
#include "tautline/system.hpp"
#include "tautline/system_geometry.hpp"
#include "words.hpp"

// Why an elastic cable of an otherwise sound system cannot be solved.

namespace tautline {

/// The frequency of an elastic cable times the duration may be this [-]: a million steps.
inline constexpr double most_radians = 2.5e6;

/// Loads, ends and lengths that vary over time may stretch a cable by this share of its length [-]:
/// no energy bounds it.
inline constexpr double driven_strain = 1.0;

/// By which a file says how stiff a cable is, and in which unit.
inline const char* stiffness_key(const Elasticity& law) {
  return law.of_strain ? "EA" : "stiffness";
}
inline const char* stiffness_unit(const Elasticity& law) { return law.of_strain ? "[N]" : "[N/m]"; }

/// True where the function is a constant, as a file has one.
template <int N>
bool is_constant(const Function<N>& function) {
  return function.waves.empty() &&
         (function.pieces.empty() ||
          (function.pieces.size() == 1 && function.pieces.front().coefficients.size() < 2));
}

/// The response of a cable to an impulse of its own at the start [1/kg]; the largest in any
/// direction where two of its ends meet and give none.
template <int D>
double response_at_start(const BasicSystem<double, D>& system,
                         BasicCableOfSystem<double, D> cable) {
  cable.from_time.reset();
  cable.cut_at.reset();
  const auto row = gap_gradient(cable, system.initial);
  const double response = row.dot(row.cwiseProduct(inverse_mass(system.bodies)));
  if (std::isfinite(response)) {
    return response;
  }
  double most = 0.0;
  for (std::size_t index = 0; index < system.bodies.size(); ++index) {
    double pulls = 0.0;  // by the segments at this body
    double arms = 0.0;   // [m]
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      const double segments = i == 0 || i == cable.segments() ? 1.0 : 2.0;
      if (cable.end(i).body == index) {
        pulls += segments;
        arms += segments * cable.end(i).at.norm();
      }
    }
    const auto& body = system.bodies[index];
    most += pulls * pulls / body.mass;
    most += arms > 0.0 ? arms * arms / moments(body.inertia).minCoeff() : 0.0;
  }
  return most;
}

/// To which value the damper of this `law` must be lowered for a rate of at most `most` [rad/s],
/// with the `frequency` of its first stiffness [rad/s].
inline std::string slower_damper(const Elasticity& law, double most, double response,
                                 double frequency) {
  if (law.damping > 0.0) {
    return "damping to " + text(most / response) + " N s/m";
  }
  const double ratio = most / (2.0 * frequency);
  return "damping_ratio to " + text(ratio) +
         (law.cut == ElasticCut::force ? " (a restitution of " + text(restitution_of(ratio)) + ")"
                                       : "");
}

/// The frequency of an elastic cable, or the rate of its damper if that is faster, says how many
/// steps its motion takes.
template <int D>
void check_frequency(Sentences& wrong, const BasicSystem<double, D>& system, std::size_t index) {
  const BasicCableOfSystem<double, D>& cable = system.cables[index];
  const Elasticity& law = *cable.elasticity;
  const double response = response_at_start(system, cable);
  double stiffest = law.stiffness.front();
  std::string to_lower = stiffness_key(law);
  for (std::size_t i = 0; i < law.corners.size(); ++i) {
    if (law.corners[i].stiffness > stiffest) {
      stiffest = law.corners[i].stiffness;
      to_lower = stiffness_key(law) + (" of corners[" + std::to_string(i) + "]");
    }
  }
  const double base = base_of(law, cable.length.at(0.0)[0]);
  const double frequency = std::sqrt(stiffest / base * response);
  const double first = std::sqrt(law.stiffness.front() / base * response);
  const double of_contacts =  // that stay below the first corner
      law.damping_ratio > 0.0 ? law.damping_ratio : law.damping * response / (2.0 * first);
  const double ratio = of_contacts * (first / frequency);
  const double above = std::max(1.0, ratio);  // from where on the damper is the faster of both
  const double fastest = frequency * (above + std::sqrt(above * above - 1.0));
  const double most = most_radians / system.duration;
  if (!(fastest > most)) {
    return;
  }
  const double share = std::min(1.0, most / frequency);
  const bool restitutes = law.cut == ElasticCut::force;  // contacts end where the tension is 0 (E6)
  std::string advice = "lower its ";
  if (share < 1.0) {
    advice = "make it inextensible" +
             (restitutes ? " with restitution " + text(restitution_of(of_contacts)) +
                               ", which its contacts have"
                         : "") +
             ", or lower its ";
  }
  if (ratio > 1.0) {
    const double lowered = stiffest > law.stiffness.front() ? first : share * first;
    advice += slower_damper(law, most, response, lowered) + (share < 1.0 ? " and its " : "");
  }
  if (share < 1.0) {
    advice += to_lower + " to " + text(stiffest * share * share) + (law.of_strain ? " N" : " N/m");
  }
  wrong.add(cable_name(index) +
            (ratio > 1.0 ? ": the rate of its damper, " + text(fastest)
                         : ": its frequency, " + text(frequency)) +
            " rad/s, must be at most " + text(most) + " rad/s for a duration of " +
            text(system.duration) + " s: " + advice);
}

/// True where something that varies over time, or begins to pull, may move what cable `index`
/// joins.
template <int D>
bool is_driven(const BasicSystem<double, D>& system, std::size_t index) {
  const auto island = joined(system, CableSet::first(system.cables.size()));
  const std::size_t own = island[bodies_on(system.cables[index]).front()];
  bool result = !is_constant(system.gravity);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const auto& body = system.bodies[i];
    result = result || (island[i] == own && !(is_constant(body.force) && body.moment.empty()));
  }
  for (const auto& cable : system.cables) {
    bool varies = cable.from_time || !is_constant(cable.length);
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      varies = varies || !is_constant(cable.end(i).motion);
    }
    result = result || (varies && island[bodies_on(cable).front()] == own);
  }
  return result;
}

/// A force that falls while the stretch grows pulls ever less.
template <int D>
void check_turn(Sentences& wrong, const BasicSystem<double, D>& system, std::size_t index) {
  const BasicCableOfSystem<double, D>& cable = system.cables[index];
  const Elasticity& law = *cable.elasticity;
  Function<1> slope;
  slope.pieces.push_back({0.0, {}});
  for (std::size_t i = 0; i < law.stiffness.size(); ++i) {
    slope.pieces.front().coefficients.push_back(
        Function<1>::Value(static_cast<double>(i + 1) * law.stiffness[i]));
  }
  const double length = cable.length.at(0.0)[0];
  const double base = base_of(law, length);
  double weight = 0.0;  // [N]
  for (const auto& body : system.bodies) {
    weight += body.mass * system.gravity.at(0.0).norm() + body.force.at(0.0).norm();
  }
  const double energy =
      kinetic_energy(system.bodies, system.initial) + stored_energy(system, system.initial);
  const bool driven = law.stiffness.size() > 1 && is_driven(system, index);
  bool within_energy = true;
  constexpr double shortest = 1e-9;  // [-], of the length
  constexpr double longest = 1e9;
  for (double reach = shortest; reach < longest; reach *= 2.0) {
    const double stretch = reach * length;
    if (const auto found = not_above_zero(slope, 0.0, stretch / base)) {
      wrong.add(cable_name(index) + ": its force falls at a stretch of " +
                text(found->time * base) + " m, which " +
                (within_energy ? "the start and a fall through two lengths"
                               : "a motion that is driven over time") +
                " may reach; " + stiffness_key(law) + " must give a force that rises");
      return;
    }
    within_energy = within_energy && !(spring_energy(law, stretch, length) >
                                       energy + 2.0 * weight * (length + stretch));
    if (!within_energy && !(driven && reach < driven_strain)) {
      return;
    }
  }
}

}  // namespace tautline
