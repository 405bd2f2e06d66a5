// The user's forces in a step of ODE that is split at impacts. ODE forgets the forces on a body in
// each call of dWorldStep; here they act over the whole step, wherever the user gives them.
//
// Forces that were given before the step are given again before each part. The ones that the user's
// step function adds itself are seen in the midst of dWorldStep: a body of ours without joints is
// the first that ODE steps there, and ODE calls back as it has moved it, before it steps any other.
// The next part is expected to have the same ones.

#ifndef TAUTLINE_ODE_DX_FORCES_OF_STEP_H
#define TAUTLINE_ODE_DX_FORCES_OF_STEP_H

#include <ode/ode.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tautline/ode/dxCable.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// For the length of one dStepWithCables. It limits the world to one thread meanwhile.
class dxForcesOfStep {
 public:
  /// Of a step of `stepsize` [s] with these cables, all of which outlive it.
  dxForcesOfStep(dWorldID world, const dCableID* cables, int count, dReal stepsize)
      : m_world(world),
        m_cables(cables),
        m_count(count),
        m_threads(dWorldGetStepIslandsProcessingMaxThreadCount(world)),
        m_witness(dBodyCreate(world)) {
    // the newest body is the first in ODE's list, and a body without joints an island of its own
    dBodySetGravityMode(m_witness, 0);
    dBodySetAutoDisableFlag(m_witness, 0);
    dBodySetData(m_witness, this);
    dBodySetMovedCallback(m_witness, &see);
    dWorldSetStepIslandsProcessingMaxThreadCount(world, 1);
    for (int index = 0; index < count; ++index) {
      for (const dxCableEnd& end : cables[index]->end) {
        if (end.is_moved() && find(end.body) == nullptr) {
          m_pushed.push_back(Pushed(end.body, end.pushes));
        }
      }
    }
    m_ends = m_pushed.size();
    add_jointed();
    forget_before_impacts();
    for (Pushed& one : m_pushed) {
      one.mean = one.given;
      one.known.given.next(one.mean, stepsize);
    }
    expect();
  }
  dxForcesOfStep(const dxForcesOfStep&) = delete;
  dxForcesOfStep& operator=(const dxForcesOfStep&) = delete;
  ~dxForcesOfStep() {
    dBodyDestroy(m_witness);
    dWorldSetStepIslandsProcessingMaxThreadCount(m_world, m_threads);
  }

  /// How many bodies are at cables' ends.
  std::size_t ends() const { return m_ends; }
  /// The body of this index, below `ends`.
  dBodyID end(std::size_t index) const { return m_pushed[index].body; }

  /// Gives all bodies the forces that the next part is expected to have.
  void expect() const {
    for (const Pushed& one : m_pushed) {
      dxPush all = one.mean;
      all += one.known.last;
      all.set(one.body);
    }
  }
  /// Before the user's step function steps by `part` [s]: takes away what that will add itself.
  void withdraw(dReal part) {
    forget_before_impacts();
    for (Pushed& one : m_pushed) {
      one.before = dxPush(one.body);
      one.before -= one.known.last;
      one.before.set(one.body);
      one.known.last = dxPush();
    }
    m_part = part;
  }
  /// After the last part: none is left, as after dWorldStep, but on a body that sleeps.
  void finish() const {
    for (const Pushed& one : m_pushed) {
      (dBodyIsEnabled(one.body) != 0 ? dxPush() : one.given).set(one.body);
    }
    for (int index = 0; index < m_count; ++index) {
      for (dxCableEnd& end : m_cables[index]->end) {
        for (std::size_t one = 0; one < m_ends; ++one) {
          if (m_pushed[one].body == end.body) {
            const bool is_struck = end.pushes.is_struck;  // at the end of the last part
            end.pushes = m_pushed[one].known;
            end.pushes.is_struck = is_struck;
          }
        }
      }
    }
  }

 private:
  struct Pushed {
    dBodyID body;
    dxPush given;   // before the step
    dxPush mean;    // of these, over the step
    dxPush before;  // the user's step function is called: these, and the cables' pulls
    dxPushes known;

    Pushed(dBodyID the_body, const dxPushes& pushes)
        : body(the_body), given(the_body), known(pushes) {}
  };

  /// ODE calls it in the midst of a step, when it has stepped the witness and no other body.
  static void see(dBodyID witness) { static_cast<dxForcesOfStep*>(dBodyGetData(witness))->see(); }
  void see() {
    if (m_part > 0) {  // a second step within the part has other forces, if any
      for (Pushed& one : m_pushed) {
        one.known.last = dxPush(one.body);
        one.known.last -= one.before;
        if (&one < m_pushed.data() + m_ends) {
          const dxPush value = one.known.last;
          one.known.added.next(one.known.last, m_part);
          dxPush all(one.body);
          all += one.known.last;
          all -= value;
          all.set(one.body);
        }
      }
    }
    m_part = 0;
  }

  Pushed* find(dBodyID body) {
    const auto found = std::find_if(m_pushed.begin(), m_pushed.end(),
                                    [body](const Pushed& one) { return one.body == body; });
    return found != m_pushed.end() ? &*found : nullptr;
  }
  /// Bodies that joints connect to the cables'. ODE tells of no others.
  void add_jointed() {
    for (std::size_t next = 0; next < m_pushed.size(); ++next) {
      const dBodyID body = m_pushed[next].body;
      for (int index = 0; index < dBodyGetNumJoints(body); ++index) {
        for (int side = 0; side < 2; ++side) {
          const dBodyID other = dJointGetBody(dBodyGetJoint(body, index), side);
          if (other != nullptr && dBodyIsKinematic(other) == 0 && find(other) == nullptr) {
            m_pushed.push_back(Pushed(other, dxPushes()));
          }
        }
      }
    }
  }
  void forget_before_impacts() {
    for (int index = 0; index < m_count; ++index) {
      for (dxCableEnd& end : m_cables[index]->end) {
        Pushed* one = end.pushes.is_struck ? find(end.body) : nullptr;
        if (one != nullptr) {
          one->known.forget();
        }
        end.pushes.is_struck = false;
      }
    }
  }

  dWorldID m_world;
  const dCableID* m_cables;
  int m_count;
  unsigned m_threads;  // that may step its islands
  dBodyID m_witness;
  dReal m_part = 0;  // that is stepped now, and not seen yet [s]
  std::vector<Pushed> m_pushed;
  std::size_t m_ends = 0;  // the first of them are at cables' ends
};

// NOLINTEND(modernize-use-nodiscard)

#endif
