// The impacts of a ball on a cable, and how far they can be trusted: node example.mjs
import { load } from "tautline";

const tautline = await load();
const ball = {
  name: "ball",
  duration: 2.7, // [s]
  gravity: [0, -1], // [m/s^2]
  body: { mass: 1, inertia: 0.4 }, // [kg], [kg m^2]
  cables: [{ anchor: [0, 2], attachment: [0, 0], length: 2, restitution: 0.5 }], // [m]
  initial: { position: [0, 0.5] }, // [m]
};
const motion = tautline.solve(ball);
const errors = motion.event_errors();
motion.events.forEach(({ kind, time }, k) => console.log(`${kind} at ${time} s, right to ${errors[k].time.toExponential(0)} s`));
motion.dispose();
