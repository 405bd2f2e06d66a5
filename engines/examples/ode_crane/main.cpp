// A crane drops its load into the slack of two cables, beside a stack of boxes on the ground. ODE
// steps at 60 Hz; the cables pull by forces, or, while the load touches something, by contacts
// beside those of the collisions.

#include <cstdio>

#include <ode/ode.h>

#include "tautline/ode/dCable.h"

namespace {

const dReal stepsize = dReal(1) / 60;  // [s]
const dReal restitution = dReal(0.5);

dWorldID world;
dSpaceID space;
dJointGroupID contacts;

void nearCallback(void* /*data*/, dGeomID geom1, dGeomID geom2) {
  const int most = 8;
  dContact contact[most];
  const int count = dCollide(geom1, geom2, most, &contact[0].geom, sizeof(dContact));
  for (int index = 0; index < count; ++index) {
    contact[index].surface.mode = dContactApprox1;
    contact[index].surface.mu = dReal(0.5);
    dJointAttach(dJointCreateContact(world, contacts, &contact[index]), dGeomGetBody(geom1),
                 dGeomGetBody(geom2));
  }
}

/// A box with a body [kg], [m].
dBodyID createBox(dReal mass, dReal x, dReal y, dReal z, dReal height) {
  const dBodyID body = dBodyCreate(world);
  dMass m;
  dMassSetBoxTotal(&m, mass, x, y, z);
  dBodySetMass(body, &m);
  const dGeomID geom = dCreateBox(space, x, y, z);
  dGeomSetBody(geom, body);
  dBodySetPosition(body, 0, height, 0);
  return body;
}

}  // namespace

int main() {
  dInitODE2(0);
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
  world = dWorldCreate();
  space = dHashSpaceCreate(nullptr);
  contacts = dJointGroupCreate(0);
  dWorldSetGravity(world, 0, dReal(-9.81), 0);

  dCreatePlane(space, 0, 1, 0, 0);
  for (int level = 0; level < 3; ++level) {
    const dReal height = dReal(0.3) + dReal(0.6) * dReal(level);
    dBodySetPosition(createBox(5, dReal(0.6), dReal(0.6), dReal(0.6), 0), 3, height, 0);
  }
  const dBodyID load = createBox(10, 1, dReal(0.4), dReal(0.6), dReal(4.2));

  // from the hook to two corners of the load's lid
  dCableID cables[2];
  for (int index = 0; index < 2; ++index) {
    const dReal side = index == 0 ? dReal(-0.5) : dReal(0.5);
    cables[index] = dCableCreate();
    dCableAttach(cables[index], load, nullptr);
    dCableSetAnchor1(cables[index], side, dReal(4.4), side / 2);
    dCableSetAnchor2(cables[index], 0, 6, 0);
    dCableSetLength(cables[index], dReal(2.5));
    dCableSetBounce(cables[index], restitution);
  }

  std::printf("impacts, restitution %.2f\n", double(restitution));
  std::printf("  t [s]     y [m]  cable  impulse [Ns]  measured e\n");
  for (int step = 1; step <= 300; ++step) {
    const dReal before[2] = {dCableGetGapRate(cables[0]), dCableGetGapRate(cables[1])};
    dSpaceCollide(space, nullptr, &nearCallback);
    dCableAddContacts(world, contacts, cables, 2, stepsize);
    dWorldStep(world, stepsize);
    dJointGroupEmpty(contacts);
    for (int index = 0; index < 2; ++index) {
      const dReal after = dCableGetGapRate(cables[index]);
      if (dCableIsTaut(cables[index]) != 0 && before[index] < dReal(-0.05) && after > 0) {
        std::printf("%7.3f  %8.4f  %5d  %12.4f  %10.4f\n", double(stepsize) * step,
                    double(dBodyGetPosition(load)[1]), index,
                    double(dCableGetImpulse(cables[index])), double(-after / before[index]));
      }
    }
  }

  std::printf("\nit hangs\ncable  state  tension [N]    gap [m]\n");
  bool hangs = true;
  for (int index = 0; index < 2; ++index) {
    const bool taut = dCableIsTaut(cables[index]) != 0;
    hangs = hangs && taut;
    std::printf("%5d  %-5s  %11.3f  %9.1e\n", index, taut ? "taut" : "slack",
                double(dCableGetImpulse(cables[index]) / stepsize),
                double(dCableGetGap(cables[index])));
    dCableDestroy(cables[index]);
  }
  dJointGroupDestroy(contacts);
  dSpaceDestroy(space);
  dWorldDestroy(world);
  dCloseODE();
  return hangs ? 0 : 1;
}
