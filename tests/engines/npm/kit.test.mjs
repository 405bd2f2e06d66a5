// The kit for node, engines/protocol/javascript: what it reads and writes, and what it keeps from the protocol.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { restitution } from "../../../engines/protocol/javascript/cable.mjs";
import { bodiesOf, given, numbersOf, plus, systemRow, turned } from "../../../engines/protocol/javascript/space.mjs";
import { startChild } from "./client.mjs";
import { exact, standardCase } from "./standard_case.mjs";

const kit = fileURLToPath(new URL("../../../engines/protocol/javascript", import.meta.url));
const work = mkdtempSync(join(tmpdir(), "tautline-kit-"));
after(() => rmSync(work, { recursive: true }));

// an engine that returns what it is given, prints, and throws
writeFileSync(join(work, "engine.mjs"), `
import { serve, Unsupported } from "${kit}/engine.mjs";
import { writeSync } from "node:fs";
console.log("noise from console.log"); console.info("noise"); console.table([1]);
process.stdout.write("noise from process.stdout\\n");
writeSync(1, "noise past both\\n");
let state = [0, 0, 0, 0, 0, 0], freed = 0;
const run = () => ({ state: () => state, place: (wanted) => (state = wanted), free: () => ++freed,
  step(dt) { if (dt === 2) throw new Error("kaputt"); if (dt === 3) this.stopped = { time: 3, reason: "worn out" }; return [dt]; },
  fly(dt) { throw new Unsupported("wings: none"); }, solve: (cables, rates) => rates.concat(freed) });
const model = (name, more) => ({ name, sentence: "\u00dcml\u00e4ut.", maker: "by_hand", settings: [], start: run, ...more });
serve({ name: "echo", version: "1", precision: "float64", models: [model("echo", { tension: true }), model("other")] });
`);

const started = async () => {
  const child = startChild(work);
  await child.ask("start", { case: standardCase, model: "echo", step: 1 });
  return child;
};

test("is no longer than a page, and an engine by it than sixty lines", () => {
  const lines = (path) => readFileSync(join(kit, path), "utf8").split("\n").length - 1;
  assert.ok(lines("engine.mjs") <= 100, `${lines("engine.mjs")} lines`);
  assert.ok(lines("example/engine.mjs") <= 60, `${lines("example/engine.mjs")} lines`);
});

test("keeps what libraries print from the protocol", async () => {
  const child = await started();
  const info = await child.ask("info");
  assert.equal(info.protocol, 2);
  assert.equal(info.models[0].sentence, "\u00dcml\u00e4ut.");
  assert.equal(info.models[0].start, undefined);
  assert.equal(await child.end(), 0);
});

test("passes on which models tell their tensions", async () => {
  for (const [folder, tensions] of [[work, [true, undefined]], [join(kit, "example"), [true]]]) {
    const child = startChild(folder);
    assert.deepEqual((await child.ask("info")).models.map(({ tension }) => tension), tensions);
    await child.end();
  }
});

test("brings every number back as it was", async () => {
  const child = await started();
  const states = [
    ["-0", "NaN", "Infinity", "-Infinity", 5e-324, 1.7976931348623157e308],
    [0, 0.1, 1 / 3, -2.2250738585072014e-308, 123456789.12345679, 0.10000000149011612],
  ];
  for (const state of states) assert.deepEqual((await child.ask("place", { state })).state, state);
  assert.match(await child.say('{"jsonrpc":"2.0","id":9,"method":"place","params":{"state":[-0.0,0,0,0,0,0]}}'), /"state":\["-0",0/);
  await child.end();
});

test("answers with the error that the protocol has for it", async () => {
  const child = await started();
  await assert.rejects(child.ask("no-such"), { code: -32601, message: 'no method "no-such"' });
  await assert.rejects(child.ask("constructor"), { code: -32601 });
  await assert.rejects(child.ask("fly", { dt: 1 }), { code: -32602, message: "unsupported: wings: none" });
  await assert.rejects(child.ask("step", { dt: 2, count: 1 }), { code: -32000, message: "kaputt" });
  await assert.rejects(child.ask("start", { case: standardCase, model: "third" }), { code: -32602, message: /there are echo, other$/ });
  await assert.rejects(child.ask("step", { dt: 1, count: 1 }), { code: -32000, message: '"step" before "start"' });
  assert.match(await child.say("no JSON"), /"id":null,"error"/);
  await child.end();
});

test("steps as often as it is asked to, less where a run stops, and frees the run before", async () => {
  const child = await started();
  assert.equal((await child.ask("step", { dt: 1, count: 100 })).steps.length, 100);
  assert.deepEqual(await child.ask("step", { dt: 3, count: 100 }), { steps: [], stopped: { time: 3, reason: "worn out" } });
  await child.ask("start", { case: standardCase, model: "other", step: 1 });
  assert.deepEqual((await child.ask("solve", { cables: [0], rates: [7] })).impulses, [7, 1]);
  await child.end();
});

test("looks a restitution up in a table: linear between its points, constant beyond them", () => {
  const cable = { restitution: [[0.1, 0], [0.3, 0.8], [1, 0.6]] };
  const found = [0.05, -0.1, 0.2, -0.3, 0.65, 1, 9].map((rate) => restitution(cable, rate));
  [0, 0, 0.4, 0.8, 0.7, 0.6, 0.6].forEach((e, k) => assert.ok(Math.abs(found[k] - e) < 1e-15, `${found}`));
  assert.equal(restitution({ restitution: 0.9 }, -1), 0.9);
});

test("knows a cable through a ring, whose ends and length move: its gap, the two rates of it, and its wrench", () => {
  const motion = { pieces: [{ from: 0.1, polynomial: [[0, 0, 0], [0.2, 0.1, 0], [0, 0, 0.4]] }], waves: [{ amplitude: [0.1, 0, 0.2], frequency: 3, phase: 0.4 }] };
  const length = { pieces: [{ from: 0, polynomial: [[3], [-0.2], [0.1], [0.05]] }, { from: 5, polynomial: [[9]] }], waves: [] };
  const cable = { ends: [{ body: 0, at: [0.1, -0.2, 0.3] }, { body: 1, at: [0, 0.1, 0.05] }, { at: [0.3, 0.2, 1.5], motion }], length, restitution: 0.5, cut_at: 4 };
  const numbers = [0, 0, 0, 0.5, 0.5, -0.5, 0.5, 0.3, -0.4, 0.2, 1, -2, 0.5, 0.6, 0.3, 0.9, 0.6, 0, 0.8, 0, -0.1, 0.2, 0.5, -0.7, 0.3, 1.1];
  const bodies = bodiesOf(numbers), time = 0.7, h = 1e-4;
  assert.deepEqual(numbersOf(bodies), numbers);
  const after = (t) => systemRow(cable, bodies.map((body) => ({ ...body, position: plus(body.position, body.velocity, t),
    orientation: turned(body.orientation, body.spin.map((one) => t * one)) })), time + t);
  const { gap, rate, acceleration, wrench } = after(0);
  const near = (found, wanted, what) => assert.ok(Math.abs(found - wanted) < 1e-6, `${what}: ${found}, not ${wanted}`);
  near((after(h).gap - after(-h).gap) / (2 * h), rate, "rate");
  near((after(h).rate - after(-h).rate) / (2 * h), acceleration, "acceleration");
  const pulled = bodies.map(({ velocity, spin, ...pose }, i) => ({ ...pose, velocity: plus(velocity, wrench.slice(6 * i, 6 * i + 3)), spin: plus(spin, wrench.slice(6 * i + 3, 6 * i + 6)) }));
  near(systemRow(cable, pulled, time).rate - rate, wrench.reduce((sum, one) => sum + one * one, 0), "wrench");
  assert.ok(Number.isFinite(gap) && systemRow(cable, bodies, 4).gap === Infinity);
  assert.deepEqual(given(motion, 0)[0].slice(0, 2), [0.1 * Math.cos(0.4), 0]); // its value at the first knot
});

test("carries an engine that follows the exact motion", async () => {
  const child = startChild(join(kit, "example"));
  const step = 1e-3, until = 2;
  await child.ask("start", { case: standardCase, model: "row", step });
  let worst = 0;
  for (let done = 0; done < until / step; ) {
    for (const [x, y] of (await child.ask("step", { dt: step, count: 100 })).steps) {
      const wanted = exact(++done * step);
      worst = Math.max(worst, Math.hypot(x - wanted[0], y - wanted[1]));
    }
  }
  // an impact is late by up to a step at a closing speed of .25 to .4 m/s: some 4e-4 at each of seven impacts
  assert.ok(worst < 3e-3, `it is off by ${worst}`);
  await child.end();
});
