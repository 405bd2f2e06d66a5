// Cables in Bullet's debug drawing. Add it to the world once:
//
//   btCableDrawing drawing(world);
//   world->addAction(&drawing);  // and removeAction before it ends
//
// It then draws every btCableConstraint of that world with debugDrawWorld: a line if the cable is
// taut, a catenary of its length if it is slack. The drawer's mode needs DBG_DrawConstraints, and
// one of DBG_DrawWireframe, DBG_DrawAabb and DBG_DrawNormals, without which Bullet 3.24 draws no
// actions; with DBG_DrawConstraints alone, call drawing.debugDraw(drawer) after debugDrawWorld.
// It takes RTTI.

#ifndef TAUTLINE_BT_CABLE_DRAWING_H
#define TAUTLINE_BT_CABLE_DRAWING_H

#include <BulletDynamics/Dynamics/btActionInterface.h>
#include <BulletDynamics/Dynamics/btDynamicsWorld.h>
#include <LinearMath/btIDebugDraw.h>

#include <algorithm>
#include <cmath>

#include "tautline/bullet/btCableConstraint.h"

/// Draws the cables of a world: taut as a line, slack as a catenary of its length.
class btCableDrawing : public btActionInterface {
 public:
  /// Draws all cables of this world, which outlives it.
  explicit btCableDrawing(btDynamicsWorld* world) : m_world(world) {}

  /// Red, green and blue, in [0, 1] each; red and light blue unless set.
  void setColors(const btVector3& taut, const btVector3& slack) {
    m_taut = taut;
    m_slack = slack;
  }

  void updateAction(btCollisionWorld* /*world*/, btScalar /*timeStep*/) override {}  // does nothing

  /// Called by the world where its drawer draws constraints.
  void debugDraw(btIDebugDraw* drawer) override {
    if ((drawer->getDebugMode() & btIDebugDraw::DBG_DrawConstraints) == 0) {
      return;
    }
    for (int index = 0; index < m_world->getNumConstraints(); ++index) {
      const auto* cable = dynamic_cast<const btCableConstraint*>(m_world->getConstraint(index));
      if (cable != nullptr && cable->isEnabled()) {
        draw(*cable, *drawer);
      }
    }
  }

 private:
  void draw(const btCableConstraint& cable, btIDebugDraw& drawer) const {
    const btVector3 from = cable.getPivotAInWorld();
    const btVector3 to = cable.getPivotBInWorld();
    const btScalar gap = cable.getGap();
    const bool falls = m_world->getGravity().length2() > 0;
    if (cable.isTaut() || !falls || !(gap > SIMD_EPSILON * cable.getMaxLength())) {
      drawer.drawLine(from, to, cable.isTaut() ? m_taut : m_slack);
    } else {
      drawHanging(from, to, cable.getMaxLength(), drawer);
    }
  }

  /// A catenary of parameter a is, from its lowest point along its arc s, at the height
  /// sqrt(a^2 + s^2) and at a asinh(s / a) across. It spans `across` and `rise` with its `length`
  /// if
  ///   x = across / (2 a) has sinh(x) / x = sqrt(length^2 - rise^2) / across,
  /// and its middle is at s = a sinh(m) cosh(x), tanh(m) = rise / length.
  void drawHanging(const btVector3& from, const btVector3& to, double length,
                   btIDebugDraw& drawer) const {
    const btVector3 up = -m_world->getGravity().normalized();
    const btVector3 between = to - from;
    const double rise = between.dot(up);
    const btVector3 sideways = between - between.dot(up) * up;
    const double below = std::sqrt(std::max((length - rise) * (length + rise), 0.0));
    const double narrowest = 1e-3;  // of that: one that hangs straight down and up again
    const double across = std::max(double(sideways.length()), narrowest * below);
    const double x = halfSpan(below / across);
    const double a = across / (2 * x);
    const double m = std::atanh(rise / length);
    const double start = a * std::sinh(m - x);
    btVector3 last = from;
    const int pieces = 24;
    for (int piece = 1; piece <= pieces; ++piece) {
      const double s = start + length * piece / pieces;
      const double out = a * (std::asinh(s / a) - (m - x));
      const double height = std::hypot(a, s) - a * std::cosh(m - x);
      const btVector3 next =
          piece < pieces ? from + btScalar(out / across) * sideways + btScalar(height) * up : to;
      drawer.drawLine(last, next, m_slack);
      last = next;
    }
  }

  /// x > 0 with sinh(x) / x = `ratio`, for a ratio of 1 to 1000.
  static double halfSpan(double ratio) {
    double low = 1e-6;  // where sinh(x) / x is 1 to rounding
    double high = 10;
    const int halvings = 50;
    for (int done = 0; done < halvings; ++done) {
      const double middle = (low + high) / 2;
      (std::sinh(middle) < ratio * middle ? low : high) = middle;
    }
    return low;
  }

  btDynamicsWorld* m_world;
  btVector3 m_taut = btVector3(1, btScalar(0.3), btScalar(0.2));
  btVector3 m_slack = btVector3(btScalar(0.4), btScalar(0.7), 1);
};

#endif
