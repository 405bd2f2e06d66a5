// A complete engine: one body under gravity, whose cables are rows made by hand. `tautline check` holds it to its word.

import { serve } from "../engine.mjs"; // "tautline-engine" where the kit is installed by npm
import { cableRow, restitution } from "../cable.mjs"; // "tautline-engine/cable"

/** The part of an overstretch that is taken out in one step [-]. */
const correction = 0.2;

/** Passes over the rows of all cables: each undoes a part of what the others have done. */
const passes = 50;

function start({ body, cables, gravity, initial }, { step: usualStep }) {
  const { mass, inertia } = body;
  let state = [...initial.position, initial.angle, ...initial.velocity, initial.spin];

  /** Impulses [N s] of the overstretched cables: each gap opens as fast as its bounce asks, or its overstretch. */
  function pull(rows) {
    const wanted = rows.map(({ gap, rate }, i) =>
      Math.max(restitution(cables[i], rate) * Math.max(0, -rate), (correction * Math.max(0, -gap)) / usualStep));
    const impulses = cables.map(() => 0);
    for (let pass = 0; pass < passes; ++pass) {
      rows.forEach(({ nx, ny, moment, gap }, i) => {
        if (gap > 0) return;
        const turning = inertia > 0 ? moment / inertia : 0; // a point mass has no inertia
        const rate = nx * state[3] + ny * state[4] + moment * state[5];
        const more = Math.max(-impulses[i], (wanted[i] - rate) / (1 / mass + moment * turning));
        impulses[i] += more;
        state[3] += (more * nx) / mass;
        state[4] += (more * ny) / mass;
        state[5] += more * turning;
      });
    }
    return impulses;
  }

  return {
    state: () => state,
    step(dt) { // semi-implicit Euler
      const rows = cables.map((cable) => cableRow(cable, state)); // with the velocity before gravity's
      state[3] += dt * gravity[0];
      state[4] += dt * gravity[1];
      const impulses = pull(rows);
      for (const k of [0, 1, 2]) state[k] += dt * state[k + 3];
      return impulses;
    },
  };
}

const row = {
  name: "row",
  sentence: "A one-sided row for each cable in the steps that start overstretched.",
  maker: "by_hand",
  drive: "steps",
  follows_speed: true,
  tension: true,
  settings: [],
  start,
};
serve({ name: "example-js", version: "1", precision: "float64", models: [row] });
