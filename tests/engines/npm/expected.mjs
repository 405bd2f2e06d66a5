// What each fixed-step model does on the standard case, as it was measured apart from these engines' folders: the largest
// distance from the exact motion up to t = 2 at steps of 1e-2 and 1e-3, and of the first impact at each step the rebound, as
// a part of the closing speed. A test holds an engine to these within a factor of 2, or of what no digit tells apart.

const row = { deviation: [1.7e-2, 1.3e-3], rebound: [0.9, 0.9] };
const early = { deviation: [5.7e-3, 6.8e-4], rebound: [0.9, 0.9] };
// an impulse before a step of four substeps meets a quarter of gravity at once
const substeppedRow = { deviation: [1.9e-2, 2.3e-3], rebound: [0.9, 0.9] };
const substeppedEarly = { deviation: [1.1e-2, 1.0e-3], rebound: [0.9, 0.9] };
const bounce = { deviation: [1.1e-2, 3.0e-4], rebound: [0.9, 0.9] };
const lost = { deviation: [6.6e-2, 6.6e-2], rebound: [0, 0] };

const rapier = { rope: lost, "rope-bounce": bounce, row: substeppedRow, early: substeppedEarly };

export const expected = {
  rapier2d: rapier,
  rapier3d: rapier,
  jolt: { distance: lost, "distance-defaults": lost, "distance-bounce": { deviation: [1.6e-2, 2.4e-3], rebound: [0.9, 0.9] }, row, early },
  physx: {
    distance: lost, "distance-bounce": bounce, row, early,
    "distance-defaults": { deviation: [8e-2, 6.6e-2], rebound: [0, 0] },
    d6: { deviation: [6.6e-2, 6.0e-2], rebound: [0.69, 0.003] },
    "d6-toggled": { deviation: [2.2e-2, 3.1e-3], rebound: [0.91, 0.9011] },
  },
  havok: {
    distance: lost, "distance-defaults": lost, row: substeppedRow, early: substeppedEarly,
    "distance-bounce": { deviation: [8.9e-3, 1.1e-3], rebound: [0.9, 0.9] },
  },
  mujoco3: {
    "tendon-limit": { deviation: [1.0e-1, 1.6e-2], rebound: [0.75, 0.897] },
    "tendon-limit-defaults": { deviation: [6.6e-2, 6.6e-2], rebound: [0.05, 0.08] },
    row, early,
  },
  box2d3: {
    "distance-joint": lost, row: substeppedRow, early: substeppedEarly,
    "distance-joint-bounce": { deviation: [1.1e-2, 1.5e-3], rebound: [0.9, 0.9] },
    "distance-joint-rod": { deviation: [2e-1, 1.3e-1] },
  },
  planck: { rope: lost, "rope-bounce": bounce, row, early, "solver-row": row, "solver-early": early },
  matter: {
    row, early,
    "constraint-toggled": { deviation: [2e-1, 1.1e-1], rebound: [0.41, 0.68] },
    constraint: { deviation: [1.5e-1, 1.7e-1] }, // pushes as it pulls
    "row-defaults": { deviation: [6.7e-2, 6.8e-2] }, // the air stops it
  },
  cannon: { row, early, "solver-row": row, "solver-early": early, contact: { deviation: [4.7e-2, 5.3e-2], rebound: [0.84, 0.996] } },
  p2: {
    distance: { deviation: [6.6e-2, 6.6e-2], rebound: [0.06, 0.18] },
    "distance-defaults": { deviation: [6.6e-2, 6.6e-2] },
    "distance-bounce": { deviation: [1.7e-2, 1.8e-3], rebound: [0.9, 0.9] },
    row, early, "solver-row": row, "solver-early": early,
  },
};
