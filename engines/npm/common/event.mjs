// What tautline's event driver asks of an engine: to fly exactly, to be placed, and to solve an impact.

import { cableRow } from "../../protocol/javascript/cable.mjs";
import { checkCaps, checkNumbers, initialState } from "./caps.mjs";
import { fly } from "./flight.mjs";
import { impulsesFor } from "./impulses.mjs";

/** What an engine in float leaves near cables a few metres long [-]: two and some twenty roundings. */
const floatRounding = { gap: 3e-7, rate: 3e-6 };

export function startEvent(engine, theCase, options) {
  const { body, cables } = theCase;
  checkNumbers(engine, theCase);
  const world = engine.world(theCase, { ...options, exact: true });
  world.place(initialState(theCase));
  let now = world.state();
  const capped = { ...engine, flight: { speed: engine.flight.speed } }; // the others are met by shorter flights
  return {
    rounding: engine.precision === "float32" ? floatRounding : undefined,
    state: () => now,
    place(state) {
      world.place(state);
      now = world.state();
    },
    fly(dt) {
      checkCaps(capped, theCase, now, dt);
      fly(engine, world, theCase, now, dt);
      now = world.state();
    },
    solve(which, rates) {
      const rows = which.map((index) => cableRow(cables[index], now));
      const impulses = impulsesFor(rows, body, rates.map((rate, k) => rate - rows[k].rate));
      impulses.forEach((impulse, k) => {
        const { nx, ny, px, py } = rows[k];
        if (impulse > 0) world.push(impulse * nx, impulse * ny, px, py);
      });
      now = world.state();
      return impulses;
    },
    free: () => world.free?.(),
  };
}
