// What tautline's event driver asks of an engine: to fly exactly, to be placed, and to solve an impact.

import { checkNumbers } from "./caps.mjs";
import { kindOf } from "./kinds.mjs";

/** What an engine in float leaves near cables a few metres long [-]: two and some twenty roundings. */
const floatRounding = { gap: 3e-7, rate: 3e-6 };

export function startEvent(engine, theCase, options) {
  const kind = kindOf(theCase);
  checkNumbers(engine, theCase);
  const world = kind.world(engine, theCase, { ...options, exact: true });
  world.place(kind.initial(theCase));
  let now = world.state();
  const capped = { ...engine, flight: { speed: engine.flight.speed } }; // the others are met by shorter flights
  return {
    rounding: engine.precision === "float32" ? floatRounding : undefined,
    state: () => kind.numbers(now),
    place(numbers, time) {
      world.place(kind.stateOf(numbers, time));
      now = world.state();
    },
    fly(dt) {
      kind.checkCaps(capped, theCase, now, dt);
      kind.fly(engine, world, theCase, now, dt);
      now = world.state();
    },
    solve(which, rates) {
      const rows = which.map((index) => kind.row(theCase, index, now));
      const impulses = kind.impulsesFor(theCase, rows, rates.map((rate, k) => rate - rows[k].rate));
      impulses.forEach((impulse, k) => {
        if (impulse > 0) kind.push(world, rows[k], impulse, theCase);
      });
      now = world.state();
      return impulses;
    },
    free: () => world.free?.(),
  };
}
