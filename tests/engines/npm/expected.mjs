// What each fixed-step model does on the standard case, as it was measured apart from these engines' folders: the largest
// distance from the exact motion up to t = 2 at steps of 1e-2, 1e-3 and 1e-4, and of the first impact at each step the rebound, as
// a part of the closing speed. A test holds an engine to these within a factor of 2, or of what no digit tells apart.

const of = (...deviation) => ({ deviation, rebound: deviation.map(() => 0.9) });
const row = of(1.7e-2, 1.3e-3, 1.4e-4);
const early = of(5.7e-3, 6.8e-4, 6.8e-5);
// an impulse before a step of four substeps meets a quarter of gravity at once; single precision shows at 1e-4
const substeppedRow = (finest) => of(1.9e-2, 2.3e-3, finest);
const substeppedEarly = (finest) => of(1.1e-2, 1.0e-3, finest);
const bounce = (finest) => of(1.1e-2, 3.0e-4, finest);
const lost = { deviation: [6.6e-2, 6.6e-2], rebound: [0, 0, 0] };

export const expected = {
  rapier2d: { rope: lost, "rope-bounce": bounce(1.9e-4), row: substeppedRow(1.6e-4), early: substeppedEarly(1.2e-4) },
  rapier3d: { rope: lost, "rope-bounce": bounce(4.5e-4), row: substeppedRow(7.0e-4), early: substeppedEarly(6.3e-4) },
  jolt: {
    distance: lost, "distance-defaults": lost, "distance-bounce": of(1.6e-2, 2.4e-3, 2.3e-4),
    "limit-spring": { deviation: [1.0e-1] }, "limit-spring-tuned": { deviation: [8.9e-2] }, // bounces of 45 steps
    row: of(1.7e-2, 1.3e-3, 2.1e-4), early: of(5.7e-3, 6.8e-4, 7.4e-5),
  },
  physx: {
    distance: lost, "distance-bounce": bounce(1.2e-4), row: of(1.7e-2, 1.3e-3, 2.1e-4), early: of(5.7e-3, 6.8e-4, 7.5e-5),
    "distance-defaults": { deviation: [8e-2, 6.6e-2], rebound: [0, 0, 0] },
    d6: { deviation: [6.6e-2, 6.0e-2], rebound: [0.69, 0.003, 0.84] },
    "d6-toggled": { deviation: [2.2e-2, 3.1e-3, 3.1e-4], rebound: [0.91, 0.9011, 0.9001] },
  },
  havok: {
    distance: { ...lost, rebound: [0, 0, 0.023] }, "distance-defaults": { ...lost, rebound: [0, 0, 0.023] },
    row: substeppedRow(2.5e-4), early: substeppedEarly(1.2e-4), "distance-bounce": of(8.9e-3, 1.1e-3, 2.2e-2),
  },
  mujoco3: {
    "tendon-limit": { deviation: [1.0e-1, 1.6e-2], rebound: [0.75, 0.897] },
    "tendon-limit-defaults": { deviation: [6.6e-2, 6.6e-2], rebound: [0.05, 0.08] },
    row, early,
  },
  box2d3: {
    "distance-joint": lost, row: substeppedRow(2.5e-4), early: substeppedEarly(1.7e-4),
    "distance-joint-bounce": of(1.1e-2, 1.5e-3, 2.2e-4),
    "distance-joint-rod": { deviation: [2e-1, 1.3e-1] },
  },
  planck: { rope: lost, "rope-bounce": bounce(8.1e-5), row, early, "solver-row": row, "solver-early": early },
  matter: {
    row, early,
    "constraint-toggled": { deviation: [2e-1, 1.1e-1], rebound: [0.41, 0.68, 0.81] },
    constraint: { deviation: [1.5e-1, 1.7e-1] }, // pushes as it pulls
    "row-defaults": { deviation: [6.7e-2, 6.8e-2] }, // the air stops it
  },
  cannon: {
    row, early, "solver-row": row, "solver-early": early,
    contact: { deviation: [4.7e-2, 5.3e-2], rebound: [0.84, 0.996, 0.81] },
  },
  p2: {
    distance: { deviation: [6.6e-2, 6.6e-2], rebound: [0.06, 0.18, 0.50] },
    "distance-defaults": { deviation: [6.6e-2, 6.6e-2] },
    "distance-bounce": of(1.7e-2, 1.8e-3, 1.0e-4),
    row, early, "solver-row": row, "solver-early": early,
  },
};
