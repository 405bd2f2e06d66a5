// The row of a cable of btCableConstraint.h for solvers of Bullet that know rows alone.

#ifndef TAUTLINE_BT_CABLE_ROW_H
#define TAUTLINE_BT_CABLE_ROW_H

#include "tautline/bullet/btCableInSolver.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

// overstretch is taken out by velocity there
inline void btCableInSolver::getInfo2(btConstraintInfo2* info) {
  const btScalar timeStep = 1 / info->fps;
  m_line = getLineBefore(timeStep);
  for (int axis = 0; axis < 3; ++axis) {
    info->m_J1linearAxis[axis] = m_line.m_towards[axis];
    info->m_J1angularAxis[axis] = m_line.m_momentA[axis];
    info->m_J2linearAxis[axis] = -m_line.m_towards[axis];
    info->m_J2angularAxis[axis] = -m_line.m_momentB[axis];
  }
  const btCableMotion a(m_rbA);
  const btCableMotion b(m_rbB);
  Rule::Start start;
  start.gap = m_rule.length - m_line.m_distance;
  start.rate = m_line.rate(a, b) + m_rule.length_rate;
  start.fall = -timeStep * m_line.acceleration(m_rbA, m_rbB);
  start.dt = timeStep;
  tautline::cable_turn(start, m_line.swing(a, b), m_line.m_distance);
  const btScalar rateOfLength = m_rule.length_rate;
  ask(start);
  m_inverseMass = m_line.inverseMass(m_rbA, m_rbB);
  info->m_constraintError[0] =
      (m_spring.is_elastic()
           ? m_row.rate
           : btMax(m_row.rate, m_rule.held() ? m_correction / timeStep : btScalar(0))) -
      rateOfLength;
  info->m_lowerLimit[0] = 0;
  info->m_upperLimit[0] = m_row.acts ? SIMD_INFINITY : btScalar(0);
  if (m_spring.is_elastic()) {
    info->cfm[0] = static_cast<btScalar>(m_compliance / m_inverseMass);
  } else if (m_cfm > 0) {
    info->cfm[0] = m_cfm;
  }
}

// NOLINTEND(modernize-use-nodiscard)

#endif
