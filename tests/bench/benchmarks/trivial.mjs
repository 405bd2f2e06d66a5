// A child that costs next to nothing: a body that flies, in the fewest words that the protocol allows.
import { readSync, writeSync } from "node:fs";

let x, y, angle, vx, vy, spin, gravity;
const calls = {
  info: () => ({
    protocol: 1, name: "trivial", version: "1", precision: "float64",
    models: [{ name: "flight", sentence: "It flies.", maker: "by_hand" }],
  }),
  start({ case: { initial, gravity: g } }) {
    [x, y] = initial.position, angle = initial.angle, [vx, vy] = initial.velocity, spin = initial.spin;
    gravity = g;
    return { state: [x, y, angle, vx, vy, spin] };
  },
  step({ dt, count }) {
    const steps = [];
    for (let k = 0; k < count; ++k) {
      vx += dt * gravity[0], vy += dt * gravity[1], x += dt * vx, y += dt * vy, angle += dt * spin;
      steps.push([x, y, angle, vx, vy, spin, 0, 0]);
    }
    return { steps };
  },
};

const chunk = Buffer.allocUnsafe(1 << 16);
for (let size, rest = ""; (size = readSync(0, chunk)) > 0; ) {
  rest += chunk.toString("utf8", 0, size);
  for (let end; (end = rest.indexOf("\n")) >= 0; rest = rest.slice(end + 1)) {
    const { id, method, params } = JSON.parse(rest.slice(0, end));
    const answer = Buffer.from(JSON.stringify({ jsonrpc: "2.0", id, result: calls[method](params) }) + "\n");
    for (let at = 0; at < answer.length; ) at += writeSync(1, answer, at);
  }
}
