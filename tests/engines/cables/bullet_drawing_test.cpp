// What Bullet's debug drawing shows of cables.

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include "tautline/bullet/btCableConstraint.h"
#include "tautline/bullet/btCableDrawing.h"

namespace {

// a link of a multi-body cannot be an end: what would compile would be solved wrongly, if at all
static_assert(
    std::is_constructible_v<btCableConstraint, btRigidBody&, btVector3, btVector3, btScalar>);
static_assert(std::is_constructible_v<btCableConstraint, btRigidBody&, btRigidBody&, btVector3,
                                      btVector3, btScalar>);
static_assert(!std::is_constructible_v<btCableConstraint, btMultiBodyLinkCollider&, btVector3,
                                       btVector3, btScalar>);
static_assert(!std::is_constructible_v<btCableConstraint, btMultiBodyLinkCollider&, btRigidBody&,
                                       btVector3, btVector3, btScalar>);
static_assert(!std::is_constructible_v<btCableConstraint, btRigidBody&, btMultiBodyLinkCollider&,
                                       btVector3, btVector3, btScalar>);

struct DrawnLine {
  btVector3 from;
  btVector3 to;
  btVector3 color;
};

class Recorder : public btIDebugDraw {
 public:
  explicit Recorder(int mode) : mode_(mode) {}

  std::vector<DrawnLine> lines;

  void drawLine(const btVector3& from, const btVector3& to, const btVector3& color) override {
    lines.push_back({from, to, color});
  }
  void drawContactPoint(const btVector3& /*at*/, const btVector3& /*normal*/, btScalar /*distance*/,
                        int /*lifeTime*/, const btVector3& /*color*/) override {}
  void reportErrorWarning(const char* /*warning*/) override {}
  void draw3dText(const btVector3& /*at*/, const char* /*text*/) override {}
  void setDebugMode(int mode) override { mode_ = mode; }
  [[nodiscard]] int getDebugMode() const override { return mode_; }

 private:
  int mode_;
};

/// Bullet draws actions only with one of three modes, of which this draws nothing here.
constexpr int mode = btIDebugDraw::DBG_DrawConstraints | btIDebugDraw::DBG_DrawNormals;
constexpr double length = 2.0;
const btVector3 taut_color(1, 0, 0);
const btVector3 slack_color(0, 1, 0);

/// A load that nothing is drawn of, on a cable from the origin.
struct Drawn {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  btEmptyShape shape;
  btRigidBody load{
      btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape, btVector3(1, 1, 1))};
  btCableConstraint cable{load, btVector3(0, 0, 0), btVector3(0, 0, 0), btScalar(length)};
  btCableDrawing drawing{&world};

  explicit Drawn(const btVector3& at) {
    world.setGravity(btVector3(0, -10, 0));
    load.setWorldTransform(btTransform(btQuaternion::getIdentity(), at));
    world.addRigidBody(&load);
    world.addConstraint(&cable);
    drawing.setColors(taut_color, slack_color);
    world.addAction(&drawing);
  }
  Drawn(const Drawn&) = delete;
  Drawn& operator=(const Drawn&) = delete;
  ~Drawn() {
    world.removeAction(&drawing);
    world.removeConstraint(&cable);
    world.removeRigidBody(&load);
  }

  std::vector<DrawnLine> lines(int drawn_with = mode) {
    Recorder recorder(drawn_with);
    world.setDebugDrawer(&recorder);
    world.debugDrawWorld();
    world.setDebugDrawer(nullptr);
    return recorder.lines;
  }
};

TEST(BtCableDrawing, DrawsATautCableAsALine) {
  Drawn drawn(btVector3(0, btScalar(-length), 0));
  drawn.world.stepSimulation(btScalar(1) / 60);
  ASSERT_TRUE(drawn.cable.isTaut());
  const auto lines = drawn.lines();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].from, drawn.cable.getPivotAInWorld());
  EXPECT_EQ(lines[0].to, drawn.cable.getPivotBInWorld());
  EXPECT_EQ(lines[0].color, taut_color);
}

TEST(BtCableDrawing, DrawsASlackCableAsACatenaryOfItsLength) {
  // beside the origin, above it, just below it, right on it, and almost taut
  for (const btVector3& at :
       {btVector3(1, 0, 0), btVector3(btScalar(-0.4), btScalar(1.5), btScalar(0.3)),
        btVector3(0, btScalar(-0.5), 0), btVector3(0, 0, 0), btVector3(0, btScalar(-1.999), 0),
        btVector3(btScalar(1.2), btScalar(-1.599), 0)}) {
    Drawn drawn(at);
    const auto lines = drawn.lines();
    ASSERT_GT(lines.size(), 10U);
    double drawn_length = 0.0;
    double lowest = 0.0;
    btVector3 last = drawn.cable.getPivotAInWorld();
    for (const DrawnLine& line : lines) {
      EXPECT_EQ(line.from, last);
      EXPECT_EQ(line.color, slack_color);
      drawn_length += line.from.distance(line.to);
      lowest = std::min(lowest, double(line.to.y()));
      last = line.to;
    }
    EXPECT_EQ(last, drawn.cable.getPivotBInWorld());
    // chords of 24 arcs; in the bend of one that hangs straight down and up a piece may be lost
    EXPECT_LE(drawn_length, length * (1.0 + 1e-5)) << "at " << at.x() << ", " << at.y();
    EXPECT_GE(drawn_length, length * (1.0 - 1.0 / 24)) << "at " << at.x() << ", " << at.y();
    // no lower than its whole length takes it, straight down and up again
    EXPECT_GE(lowest, 0.5 * (double(at.y()) - length) - 1e-5);
  }
}

TEST(BtCableDrawing, HangsByItsClosedForm) {
  // sinh(x) / x = 2 over a span of 1 m: x = 2.177318985, and it sags by (cosh(x) - 1) / (2 x)
  Drawn drawn(btVector3(1, 0, 0));
  const auto lines = drawn.lines();
  const double x = 2.177318985;
  double lowest = 0.0;
  for (const DrawnLine& line : lines) {
    lowest = std::min(lowest, double(line.to.y()));
  }
  EXPECT_NEAR(lowest, -(std::cosh(x) - 1.0) / (2.0 * x), 1e-6);
}

TEST(BtCableDrawing, FollowsTheModeOfTheDrawer) {
  Drawn drawn(btVector3(1, 0, 0));
  EXPECT_TRUE(drawn.lines(0).empty());
  EXPECT_TRUE(drawn.lines(btIDebugDraw::DBG_DrawNormals).empty());
  // Bullet 3.24 asks no action then
  EXPECT_TRUE(drawn.lines(btIDebugDraw::DBG_DrawConstraints).empty());
  for (const auto other : {btIDebugDraw::DBG_DrawWireframe, btIDebugDraw::DBG_DrawAabb,
                           btIDebugDraw::DBG_DrawNormals}) {
    int of_cable = 0;
    for (const DrawnLine& line : drawn.lines(btIDebugDraw::DBG_DrawConstraints | other)) {
      of_cable += line.color == slack_color ? 1 : 0;
    }
    EXPECT_GT(of_cable, 0) << "with mode " << other;
  }
  Recorder recorder(btIDebugDraw::DBG_DrawConstraints);
  drawn.drawing.debugDraw(&recorder);
  EXPECT_FALSE(recorder.lines.empty());
}

TEST(BtCableDrawing, DrawsNothingOfABrokenCableNorOfOtherConstraints) {
  Drawn drawn(btVector3(1, 0, 0));
  drawn.cable.setEnabled(false);
  btPoint2PointConstraint joint(drawn.load, btVector3(0, 0, 0));
  drawn.world.addConstraint(&joint);
  Recorder recorder(mode);
  drawn.drawing.debugDraw(&recorder);
  EXPECT_TRUE(recorder.lines.empty());
  drawn.world.removeConstraint(&joint);
}

}  // namespace
