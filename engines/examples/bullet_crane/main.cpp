// A crane drops its load into the slack of two cables, beside a stack of boxes on the ground, and
// then hoists it by its winch. Bullet steps as ever, at 60 Hz and with its own settings; the cables
// are constraints of its world.

#include <cstdio>
#include <memory>
#include <vector>

#include <btBulletDynamicsCommon.h>

#include "tautline/bullet/btCableConstraint.h"

namespace {

const btScalar timeStep = btScalar(1) / 60;  // [s]
const btScalar restitution = btScalar(0.5);

struct Body {
  std::unique_ptr<btCollisionShape> shape;
  std::unique_ptr<btRigidBody> body;
};

/// A box, or the ground if `mass` [kg] is 0.
Body makeBox(btDiscreteDynamicsWorld& world, btScalar mass, const btVector3& halfExtents,
             const btVector3& position) {
  Body result;
  result.shape.reset(new btBoxShape(halfExtents));
  btVector3 inertia(0, 0, 0);
  if (mass > 0) {
    result.shape->calculateLocalInertia(mass, inertia);
  }
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, result.shape.get(), inertia);
  info.m_startWorldTransform.setOrigin(position);
  result.body.reset(new btRigidBody(info));
  world.addRigidBody(result.body.get());
  return result;
}

/// One line per impact: a step in which a cable that was closing pulled and opened.
void printImpact(int step, int index, const btRigidBody& load, const btCableConstraint& cable,
                 btScalar rateBefore) {
  std::printf("%7.3f  %8.4f  %5d  %12.4f  %10.4f\n", double(timeStep) * step,
              double(load.getCenterOfMassPosition().y()), index, double(cable.getAppliedImpulse()),
              double(-cable.getGapRate() / rateBefore));
}

void printCables(const char* title, const btRigidBody& load,
                 const std::vector<std::unique_ptr<btCableConstraint>>& cables) {
  std::printf("\n%s: y = %.4f m\ncable  state  length [m]  tension [N]    gap [m]\n", title,
              double(load.getCenterOfMassPosition().y()));
  for (std::size_t index = 0; index < cables.size(); ++index) {
    const btCableConstraint& cable = *cables[index];
    std::printf("%5d  %-5s  %10.4f  %11.3f  %9.1e\n", int(index), cable.isTaut() ? "taut" : "slack",
                double(cable.getMaxLength()), double(cable.getTension(timeStep)),
                double(cable.getGap()));
  }
}

}  // namespace

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, btScalar(-9.81), 0));

  std::vector<Body> scenery;
  scenery.push_back(makeBox(world, 0, btVector3(20, 1, 20), btVector3(0, -1, 0)));
  for (int level = 0; level < 3; ++level) {
    scenery.push_back(makeBox(world, 5, btVector3(btScalar(0.3), btScalar(0.3), btScalar(0.3)),
                              btVector3(3, btScalar(0.3) + btScalar(0.6 * level), 0)));
  }
  const Body load = makeBox(world, 10, btVector3(btScalar(0.5), btScalar(0.2), btScalar(0.3)),
                            btVector3(0, btScalar(4.2), 0));

  // from the hook to two corners of the load's lid
  const btVector3 hook(0, 6, 0);
  std::vector<std::unique_ptr<btCableConstraint>> cables;
  for (const btScalar side : {btScalar(-0.5), btScalar(0.5)}) {
    cables.emplace_back(new btCableConstraint(*load.body, btVector3(side, btScalar(0.2), side / 2),
                                              hook, btScalar(2.5)));
    cables.back()->setRestitution(restitution);
    world.addConstraint(cables.back().get());
  }

  std::printf("impacts, restitution %.2f\n", double(restitution));
  std::printf("  t [s]     y [m]  cable  impulse [Ns]  measured e\n");
  for (int step = 1; step <= 300; ++step) {
    const btScalar before[2] = {cables[0]->getGapRate(), cables[1]->getGapRate()};
    world.stepSimulation(timeStep);
    for (std::size_t index = 0; index < cables.size(); ++index) {
      const btCableConstraint& cable = *cables[index];
      if (cable.isTaut() && before[index] < btScalar(-0.05) && cable.getGapRate() > 0) {
        printImpact(step, int(index), *load.body, cable, before[index]);
      }
    }
  }

  printCables("it hangs", *load.body, cables);

  // 2 s of winch, at a speed that is there at once: an impact of 0.3 m/s, with its rebound
  for (const auto& cable : cables) {
    cable->setMaxLengthRate(btScalar(-0.3));
  }
  for (int step = 0; step < 120; ++step) {
    world.stepSimulation(timeStep);
  }
  printCables("2 s of hoisting at 0.3 m/s", *load.body, cables);
  for (const auto& cable : cables) {
    cable->setMaxLengthRate(0);
  }
  for (int step = 0; step < 180; ++step) {
    world.stepSimulation(timeStep);
  }
  printCables("it hangs higher", *load.body, cables);

  const bool hangs = cables[0]->isTaut() && cables[1]->isTaut();
  for (const auto& cable : cables) {
    world.removeConstraint(cable.get());
  }
  world.removeRigidBody(load.body.get());
  for (const Body& body : scenery) {
    world.removeRigidBody(body.body.get());
  }
  return hangs ? 0 : 1;
}
