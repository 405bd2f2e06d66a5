// How the cables of dCable.h pull in a step: what dCableAddContacts does.
//
// Cables that hang together are solved as one, exactly, and pull by forces, wherever nothing else
// is jointed to their bodies: ODE's iterative dWorldQuickStep would leave them wrong, and its exact
// dWorldStep takes longer. Where contacts or joints act on one of the bodies too, or one may fall
// asleep, each cable is a contact joint without friction, and ODE solves it with them.

#ifndef TAUTLINE_ODE_CABLE_SOLVE_H
#define TAUTLINE_ODE_CABLE_SOLVE_H

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "tautline/cable_overstretch.h"
#include "tautline/ode/dxCable.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// The cables of one call of dCableAddContacts. It is kept by the first of them, for its memory.
class dxCableSolve {
 public:
  void add_contacts(dWorldID world, dJointGroupID group, const dCableID* cables, int count,
                    dReal stepsize) {
    m_group = group;
    m_world = world;
    m_stepsize = stepsize;
    dWorldGetGravity(world, m_gravity);
    ask(cables, count);
    gather();
    for (std::size_t from = 0; from < m_acting.size();) {
      std::size_t to = from + 1;
      while (to < m_acting.size() && m_acting[to].cluster == m_acting[from].cluster) {
        ++to;
      }
      solve(&m_acting[from], to - from);
      from = to;
    }
  }

 private:
  struct Acting {
    dCableID cable;
    std::size_t cluster;
  };

  /// The cables that pull together, as tautline::move_out_of_overstretch needs them.
  struct Overstretch {
    dxCableSolve& solve;
    const Acting* acting;
    std::size_t count;

    dxCable& at(std::size_t index) const { return *acting[index].cable; }
    dReal distance(std::size_t index) const { return at(index).line.distance; }
    dReal distance_now(std::size_t index) const { return dxCableLine(at(index).end).distance; }
    dReal correction(std::size_t index) const { return at(index).correction; }
    dReal length(std::size_t index) const { return at(index).rule.length; }
    dReal& aimed(std::size_t index) const { return at(index).aimed_distance; }
    void move(std::size_t index, double push) const {
      for (int side = 0; side < 2; ++side) {
        if (at(index).end[side].is_moved()) {
          dxCableSolve::move(at(index).end[side].body, solve.m_block.row(index).end[side], push);
        }
      }
    }
    void slow_turning() const { solve.slow_turning(acting, count); }
    void look_again() const {
      for (std::size_t index = 0; index < count; ++index) {
        dxCable& cable = at(index);
        const dReal before = cable.line.distance;
        cable.line.find(cable.end);
        if (cable.spring.is_elastic()) {
          cable.set_row(cable.spring.moved(cable.line.distance - before));
          continue;
        }
        cable.row.rate = std::min(cable.row.rate, -cable.line.rate(cable.end) - cable.length_rate);
      }
      solve.fill(acting, count);
    }
  };

  /// What every cable asks for.
  void ask(const dCableID* cables, int count) {
    m_acting.clear();
    for (int index = 0; index < count; ++index) {
      const dCableID cable = cables[index];
      dxCableReadImpulse(cable);
      cable->wake_if_wound();
      cable->wake_if_led();
      if (!cable->end[0].is_awake() && !cable->end[1].is_awake()) {
        continue;  // it pulls as it did
      }
      cable->line.find(cable->end);
      const dxMotion one(cable->end[0].body);
      const dxMotion two(cable->end[1].body);
      cable->free[0].find(cable->end[0].body, m_gravity, m_stepsize);
      cable->free[1].find(cable->end[1].body, m_gravity, m_stepsize);
      const dxMotion& free_one = cable->free[0];
      const dxMotion& free_two = cable->free[1];
      const dxCableLine& line = cable->line;
      const dReal free_rate = line.rate(free_one, free_two);
      dxCable::Rule::Start start;
      start.gap = cable->rule.length - line.distance;
      start.rate = line.rate(one, two) + cable->rule.length_rate;
      start.fall = start.rate - free_rate - cable->rule.length_rate;
      start.dt = m_stepsize;
      tautline::cable_turn(start, line.swing(free_one, free_two), line.distance);
      cable->ask(start);
      if (cable->row.acts) {
        m_acting.push_back(Acting{cable, m_acting.size()});
      } else {
        cable->impulse = cable->of_impacts = cable->taut_time = 0;
      }
    }
  }

  /// Gives those that share a body that moves the same cluster, and puts them side by side.
  void gather() {
    m_hung.clear();
    for (std::size_t index = 0; index < m_acting.size(); ++index) {
      for (const dxCableEnd& end : m_acting[index].cable->end) {
        if (end.is_moved()) {
          m_hung.push_back(std::make_pair(end.body, index));
        }
      }
    }
    std::sort(m_hung.begin(), m_hung.end());
    for (std::size_t index = 1; index < m_hung.size(); ++index) {
      if (m_hung[index].first == m_hung[index - 1].first) {
        const std::size_t one = root(m_hung[index - 1].second);
        const std::size_t two = root(m_hung[index].second);
        m_acting[std::max(one, two)].cluster = std::min(one, two);
      }
    }
    for (std::size_t index = 0; index < m_acting.size(); ++index) {
      m_acting[index].cluster = root(index);
    }
    std::stable_sort(m_acting.begin(), m_acting.end(), [](const Acting& one, const Acting& two) {
      return one.cluster < two.cluster;
    });
  }
  std::size_t root(std::size_t index) const {
    while (m_acting[index].cluster != index) {
      index = m_acting[index].cluster;
    }
    return index;
  }

  void solve(const Acting* acting, std::size_t count) {
    bool by_force = true;
    bool impact = false;
    for (std::size_t index = 0; index < count; ++index) {
      const dCableID cable = acting[index].cable;
      impact = impact || cable->of_impacts > 0;
      for (const dxCableEnd& end : cable->end) {
        if (end.is_moved()) {
          if (dBodyIsEnabled(end.body) == 0) {
            dBodyEnable(end.body);
          }
          by_force = by_force && may_be_alone(*cable, end.body);
        }
      }
    }
    for (std::size_t index = 0; index < count && (count > 1 || !by_force); ++index) {
      dxCable& cable = *acting[index].cable;
      cable.row = cable.spring.is_elastic() ? cable.row : cable.rule.beside_others(cable.row);
    }
    fill(acting, count);
    Overstretch overstretch{*this, acting, count};
    tautline::move_out_of_overstretch<dReal>(overstretch, m_block, count);
    m_block.forget();
    for (std::size_t index = 0; index < count; ++index) {
      acting[index].cable->inverse_mass = static_cast<dReal>(m_block.inverse_mass(index));
      // one cable's strikes all, but those that stretch
      const bool strikes = impact && !acting[index].cable->spring.is_elastic();
      acting[index].cable->of_impacts = strikes ? dInfinity : dReal(0);
    }
    by_force ? pull(acting, count) : join(acting, count);
  }

  void fill(const Acting* acting, std::size_t count) {
    m_block.begin(count);
    for (std::size_t index = 0; index < count; ++index) {
      const dCableID cable = acting[index].cable;
      tautline::CableBlock::Row& row = m_block.row(index);
      cable->fill(row);
      row.compliance = cable->spring.is_elastic()
                           ? cable->compliance
                           : static_cast<double>(std::max(cable->cfm, dReal(0)) / m_stepsize);
      for (int side = 0; side < 2; ++side) {
        const dReal* spin = cable->free[side].spin;
        std::copy(spin, spin + 3, row.end[side].spin);
      }
    }
    m_block.assemble();
  }

  /// In a step by events the user's contacts are not there yet. ODE puts no body to sleep that has
  /// no joint: one that is slow enough for it gets one.
  static bool may_be_alone(const dxCable& cable, dBodyID body) {
    return !cable.as_contact && dBodyGetNumJoints(body) == 0 && !may_sleep(body) &&
           (!cable.by_events || dBodyGetFirstGeom(body) == nullptr);
  }
  static bool may_sleep(dBodyID body) {
    if (dBodyGetAutoDisableFlag(body) == 0) {
      return false;
    }
    const dReal slow = dBodyGetAutoDisableLinearThreshold(body);
    const dReal still = dBodyGetAutoDisableAngularThreshold(body);
    return dCalcVectorLengthSquare3(dBodyGetLinearVel(body)) <= slow * slow &&
           dCalcVectorLengthSquare3(dBodyGetAngularVel(body)) <= still * still;
  }

  /// Takes half of the spin of a body that turns too far in a step for it to follow.
  void slow_turning(const Acting* acting, std::size_t count) {
    m_slowed.clear();
    for (std::size_t index = 0; index < count; ++index) {
      for (const dxCableEnd& end : acting[index].cable->end) {
        const dReal* spin = end.is_moved() ? dBodyGetAngularVel(end.body) : nullptr;
        if (spin != nullptr && dCalcVectorLength3(spin) * m_stepsize > dxCable::Rule::followed() &&
            std::find(m_slowed.begin(), m_slowed.end(), end.body) == m_slowed.end()) {
          m_slowed.push_back(end.body);
          dBodySetAngularVel(end.body, spin[0] / 2, spin[1] / 2, spin[2] / 2);
        }
      }
    }
    for (std::size_t index = 0; index < count; ++index) {
      dxCable& cable = *acting[index].cable;
      for (int side = 0; side < 2; ++side) {
        cable.free[side].find(cable.end[side].body, m_gravity, m_stepsize);
      }
    }
  }
  static void move(dBodyID body, const tautline::CableBlockEnd& end, double push) {
    dVector3 turn;
    dReal to[3];
    for (int axis = 0; axis < 3; ++axis) {
      to[axis] = dBodyGetPosition(body)[axis] + static_cast<dReal>(push * end.move[axis]);
      turn[axis] = static_cast<dReal>(push * end.turn[axis]);
    }
    dBodySetPosition(body, to[0], to[1], to[2]);
    dxBodyTurn(body, turn, dCalcVectorLength3(turn));
  }

  /// By forces, which the step to come turns into just these impulses.
  void pull(const Acting* acting, std::size_t count) {
    for (std::size_t index = 0; index < count; ++index) {
      const dxCable& cable = *acting[index].cable;
      const dReal free_rate = cable.line.rate(cable.free[0], cable.free[1]);
      m_block.lacking(index) = cable.row.rate - cable.length_rate - free_rate;
    }
    m_block.solve_stiffly(m_stepsize);
    for (std::size_t index = 0; index < count; ++index) {
      dxCable& cable = *acting[index].cable;
      cable.pulled(static_cast<dReal>(m_block.impulse(index)));
      const dReal tension = cable.impulse / m_stepsize;
      for (int side = 0; side < 2; ++side) {
        const dBodyID body = cable.end[side].body;
        if (cable.end[side].is_moved()) {
          const dReal along = side == 0 ? tension : -tension;
          const dReal* towards = cable.line.towards;
          const dReal* moment = cable.line.moment[side];
          const dReal turning = along * static_cast<dReal>(m_block.kept(index, side));
          dBodyAddForce(body, along * towards[0], along * towards[1], along * towards[2]);
          dBodyAddTorque(body, turning * moment[0], turning * moment[1], turning * moment[2]);
        }
      }
    }
  }

  void join(const Acting* acting, std::size_t count) {
    for (std::size_t index = 0; index < count; ++index) {
      join(*acting[index].cable);
    }
  }
  void join(dxCable& cable) const {
    // the row is asked for the rate and nothing else; ODE adds its ERP to nothing. A rebound asks
    // as a bounce, which dWorldSetContactMaxCorrectingVel does not limit
    dReal rate = cable.row.rate - cable.length_rate;
    const dReal free_rate = cable.line.rate(cable.free[0], cable.free[1]);
    // of a row that is satisfied without a pull, and exactly, ODE says "LCP internal error"
    if (std::abs(free_rate - rate) <= rounding(cable)) {
      rate = free_rate - rounding(cable);
    }
    const dReal closing = -cable.line.rate(cable.end);
    const bool rebounds = rate > 0 && rate <= closing;
    dContact contact = dContact();
    contact.surface.mode = dContactSoftERP | (rebounds ? dContactBounce : dContactMotionN);
    contact.surface.bounce = rebounds ? rate / closing : 0;
    contact.surface.bounce_vel = 0;
    contact.surface.motionN = rebounds ? 0 : rate;
    if (cable.cfm >= 0 || cable.spring.is_elastic()) {
      contact.surface.mode |= dContactSoftCFM;
      contact.surface.soft_cfm =
          cable.spring.is_elastic() ? static_cast<dReal>(cable.compliance) * m_stepsize : cable.cfm;
    }
    // the normal pushes the joint's first body, which must be one; any point of the line gives
    // both the right torque
    const int first = cable.end[0].body != nullptr ? 0 : 1;
    for (int axis = 0; axis < 3; ++axis) {
      contact.geom.pos[axis] = cable.line.point[first][axis];
      contact.geom.normal[axis] = first == 0 ? cable.line.towards[axis] : -cable.line.towards[axis];
    }
    const dJointID joint = dJointCreateContact(m_world, m_group, &contact);
    dJointAttach(joint, cable.end[first].body, cable.end[1 - first].body);
    dJointSetFeedback(joint, &cable.feedback);
    cable.stepsize = m_stepsize;
  }

  /// Of the rate of a cable's row, as ODE computes it [m/s].
  dReal rounding(const dxCable& cable) const {
    dReal fastest = m_stepsize * dCalcVectorLength3(m_gravity);
    for (int side = 0; side < 2; ++side) {
      fastest +=
          dCalcVectorLength3(cable.free[side].velocity) +
          dCalcVectorLength3(cable.free[side].spin) * dCalcVectorLength3(cable.line.arm[side]);
    }
    return 1000 * std::numeric_limits<dReal>::epsilon() * fastest;
  }

  dWorldID m_world = nullptr;
  dJointGroupID m_group = nullptr;
  dReal m_stepsize = 0;
  dVector3 m_gravity;
  std::vector<Acting> m_acting;
  std::vector<dBodyID> m_slowed;
  std::vector<std::pair<dBodyID, std::size_t>> m_hung;
  tautline::CableBlock m_block{std::numeric_limits<dReal>::epsilon()};
};

// NOLINTEND(modernize-use-nodiscard)

#endif
