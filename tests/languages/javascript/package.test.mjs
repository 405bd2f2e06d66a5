// The package of JavaScript: cases and motions, what is refused, memory, types, and what is packed.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { setImmediate as soon } from "node:timers/promises";
import { fileURLToPath, pathToFileURL } from "node:url";
import v8 from "node:v8";
import vm from "node:vm";
import { Worker } from "node:worker_threads";
import { gzipSync } from "node:zlib";
import { cables_of, cases, expect_same_bits, load, package_folder, program, root, shipped } from "./support.mjs";

/** What the module may take of a page's traffic [bytes], compressed as servers do. */
const LARGEST_MODULE = 200_000;
/** What one motion after the other may leave in the module [bytes]. */
const LARGEST_MEMORY = 32 << 20;

const work = mkdtempSync(path.join(tmpdir(), "tautline-javascript-"));
after(() => rmSync(work, { recursive: true }));

/** Another module, with its memory, and the functions that it calls. */
async function with_memory(source) {
  const instantiate = WebAssembly.instantiate;
  let memory, calls;
  WebAssembly.instantiate = async (module, imports) => {
    const instance = await instantiate(module, imports);
    ({ memory } = instance.exports);
    calls = imports.tautline;
    return instance;
  };
  try {
    return { tautline: await load(source), memory, calls, bytes: () => memory.buffer.byteLength };
  } finally {
    WebAssembly.instantiate = instantiate;
  }
}

const tautline = await load();
const standard = shipped("breakwater/1910121100"), ball = { ...shipped("bouncing-ball"), duration: 2.7 };
const refused = (act) => {
  let found;
  assert.throws(act, (error) => ((found = error), error instanceof RangeError));
  return found.message.split("\n");
};

test("the first motion of the README", () => {
  const motion = tautline.solve(ball);
  assert.deepEqual(motion.events.map(({ time }) => time), [1, 2, 2.5]);
  assert.equal(motion.ending, "reached_duration");
  assert.deepEqual(tautline.coordinates.map(({ name, unit }) => `${name} [${unit}]`),
    ["x [m]", "y [m]", "angle [rad]", "vx [m/s]", "vy [m/s]", "spin [rad/s]"]);
  assert.equal(tautline.version, JSON.parse(readFileSync(path.join(package_folder(), "package.json"))).version);
});

test("each public name is in the types, and each type is there", () => {
  const text = readFileSync(path.join(package_folder(), "tautline.d.ts"), "utf8");
  /** The members of an interface. */
  const members = (name) => {
    const body = new RegExp(`^export interface ${name}\\b[^{]*\\{\\n([\\s\\S]*?)^\\}`, "m").exec(text)[1];
    return [...body.matchAll(/^ {2}(?:readonly )?(\w+)\??[:(]/gm)].map(([, member]) => member).sort();
  };
  const names = (thing) => Object.keys(thing).sort();
  assert.deepEqual([...text.matchAll(/^export function (\w+)/gm)].map(([, name]) => name).sort(), names({ cables_of, load }));
  assert.deepEqual(members("Tautline"), names(tautline));
  const motion = tautline.solve(standard), one = tautline.sweep(standard, { x: [0.1] }, { settling: true, times: [0] });
  const of_motion = Object.getOwnPropertyNames(Object.getPrototypeOf(motion)).filter((name) => name !== "constructor").sort();
  assert.deepEqual(members("Motion"), of_motion);
  for (const [name, thing] of Object.entries({ Summary: motion.summary, Settling: motion.settling, Swing: motion.settling.swing,
    Event: motion.events[0], EventErrors: motion.event_errors()[0], Arc: motion.arcs[0], Accumulation: motion.accumulations[0],
    Unsure: motion.unsure[0], Sweep: one, SweptSettlings: one.settlings, Coordinate: tautline.coordinates[0] })) {
    assert.deepEqual(members(name), names(thing), name);
  }
  const kinds = (type) => new RegExp(`export type ${type} =\\s+([^;]*);`).exec(text)[1].match(/\w+/g);
  const [of_law] = refused(() => tautline.solve(ball, { law: "none" }));
  assert.equal(of_law, `law "none" must be one of ${kinds("Law").join(", ")}`);
  const [of_option] = refused(() => tautline.solve(ball, { lw: 1 }));
  assert.deepEqual(of_option.split("one of ")[1].split(", ").sort(), members("Options"));
  const case_keys = [...members("Case")].sort();
  const [of_key] = tautline.problems({ ...ball, qqqqqqqqqqqqq: 1 });
  assert.deepEqual(of_key.split("must be ")[1].replace(" or ", ", ").split(", ").sort(), case_keys);
});

const typescript = path.join(path.dirname(fileURLToPath(import.meta.url)), "node_modules/typescript/bin/tsc");
test("TypeScript takes the types: without the library dom, as old and new programs find them", (context) => {
  if (!existsSync(typescript)) return context.skip("no typescript; run: npm ci --prefix tests/languages/javascript");
  const user = path.join(work, "typed");
  mkdirSync(path.join(user, "node_modules"), { recursive: true });
  symlinkSync(package_folder(), path.join(user, "node_modules/tautline"));
  writeFileSync(path.join(user, "package.json"), '{"type": "module"}');
  writeFileSync(path.join(user, "user.ts"), `import { cables_of, load, type Case, type Motion } from "tautline";
    const gravity: number[] = [0, -1];
    const ball = { name: "ball", duration: 2.7, gravity, body: { mass: 1, inertia: 0.4 }, initial: { position: Float64Array.of(0, 0.5), velocity: [0, 0] as const },
      cables: [{ anchor: [0, 2], attachment: [0, 0], length: 2, restitution: 0.5, restitution_table: [[0, 1], [1, 0.5]] }] };
    export async function use(bytes: Uint8Array): Promise<number[]> {
      const tautline = await load(bytes), swept = tautline.sweep(ball, { x: [0.5] }, { times: new Set([0]).size === 1 ? [0] : [], law: "poisson" });
      const read: Case = tautline.read(tautline.write(ball)), [gx, gy] = read.gravity;
      const motion: Motion = tautline.solve(read);
      motion[Symbol.dispose]();
      // @ts-expect-error: no such law
      tautline.solve(ball, { law: "none" });
      // @ts-expect-error: no body
      tautline.problems({ name: "ball" });
      // @ts-expect-error: a scalar
      motion.states(3);
      // @ts-expect-error: no source
      await load(7);
      return [gx!, gy!, swept.count, ...cables_of(3)];
    }\n`);
  writeFileSync(path.join(user, "page.ts"), `import { load } from "tautline";
    export const all = [load(), load(new URL("https://example.org/tautline.wasm")), load(new WebAssembly.Module(new Uint8Array()))];\n`);
  for (const [file, ...words] of [
    ["user.ts", "--module", "nodenext", "--lib", "es2022"],
    ["user.ts", "--module", "esnext", "--moduleResolution", "bundler", "--lib", "es2022", "--exactOptionalPropertyTypes"],
    ["user.ts", "--module", "esnext", "--moduleResolution", "node10", "--lib", "es2022"],
    ["page.ts", "--module", "esnext", "--moduleResolution", "bundler", "--lib", "es2022,dom"]]) {
    const { status, stdout } = spawnSync("node", [typescript, "--noEmit", "--strict", "--target", "es2022", "--typeRoots", "none", ...words, file], { cwd: user, encoding: "utf8" });
    assert.equal(status, 0, `${[file, ...words].join(" ")}\n${stdout}`);
  }
});

test("every number of the types has a unit", () => {
  const lines = readFileSync(path.join(package_folder(), "tautline.d.ts"), "utf8").split("\n");
  const known = /\[|number of each|How many|Rows|> 0|of each|row/;
  lines.forEach((line, k) => {
    if (!/^ {2,4}(readonly )?\w+\??: (number|Pair)\b/.test(line)) return;
    if (/readonly (events|impacts|arcs|accumulations|count|largest): /.test(line)) return;
    assert.match(lines[k - 1], known, line);
  });
});

test("text reads back to the same bits", () => {
  const odd = [-0, 5e-324, 0.1, 1e20, 12345678901234567000, 2 ** 53 + 2, 1 / 3, 1e-7, 12345.678e-200];
  const all = [...cases, ...odd.map((x) => ({ ...ball, initial: { ...ball.initial, spin: x, velocity: [x, -x] } }))];
  for (const one of all) {
    for (const format of ["toml", "json"]) assert.deepStrictEqual(tautline.read(tautline.write(one, format)), one);
  }
  assert.match(tautline.write({ ...ball, name: 'a "b" \\ \n ü' }), /^name = "a \\"b\\" \\\\ \\u000A ü"\n/);
});

test("text is refused with the sentences of the program", () => {
  const whole = tautline.write(standard);
  const wrong = ["length = -1\nlenght = 3\n", "mass = 1.0", "[body", "x = 1979-05-27T07:32:00.25+01:30", "x = 07:32:00", "x = 0x1F",
    "x = [true, 1979-05-27, 1e22, 1e-7, -0.0, 123456789012345680000.0, 5e-324]", "x = inf", "x = nan", "x = -inf", "x = 1e400",
    "x = 1e-400", 'x = "text"', "x = 1_000.5", "x = 1979-05-27T07:32:00Z", "x = +12.5", "x = 0.001", "x = 1e300"].flatMap((line) =>
    [`${line}\n${whole}`, whole.replace("mass = 1.0", line.replace(/^x/, "mass"))]);
  wrong.push(whole.replace("length = 1.5", "length = 0.1"), whole.replace("restitution = 0.9", "restitution = 1.2"), "{", "{}",
    tautline.write(standard, "json").replace("1.5", "-1e-7"), '{"name": 1e400}', '{"name": 1e-400}', '{"name": -1e5}', "", "\u0000");
  let count = 0;
  for (const text of wrong) {
    const file = path.join(work, "wrong.toml");
    writeFileSync(file, text);
    const done = spawnSync(program(), ["solve", file], { encoding: "utf8" });
    if (done.status === 0) {
      tautline.read(text, file);
      continue;
    }
    ++count;
    const told = done.stderr.trimEnd().split("\n");
    assert.deepEqual(refused(() => tautline.read(text, file)), told.map((line) => line.replace(/^tautline: /, "")), text);
  }
  assert.ok(count > 35, `${count} are refused`);
});

test("numbers in sentences are those of the C++ library", async () => {
  const { memory, calls } = await with_memory();
  const room = memory.grow(1) * 65536;
  const text = (value, digits) => new TextDecoder().decode(new Uint8Array(memory.buffer, room, calls.write_number(value, digits, room)));
  for (const [value, digits, expected] of [[0.125, 2, "0.12"], [0.375, 2, "0.38"], [-0.125, 2, "-0.12"], [2.5, 1, "2"], [3.5, 1, "4"], [9.5, 1, "1e+01"],
    [8.5, 1, "8"], [0.1, 1, "0.1"], [0.35, 1, "0.3"], [0.45, 1, "0.5"], [1e22, 3, "1e+22"], [2 ** 53 + 2, 17, "9007199254740994"], [100, 3, "100"],
    [1000, 3, "1e+03"], [0.0001, 3, "0.0001"], [0.00001, 3, "1e-05"], [-0, 3, "-0"], [0, 3, "0"], [-0, 0, "-0"], [Number.MAX_VALUE, 2, "1.8e+308"],
    [Number.MAX_VALUE, 1, "2e+308"], [Number.MAX_VALUE, 17, "1.7976931348623157e+308"], [5e-324, 3, "4.94e-324"], [5e-324, 0, "5e-324"],
    [1e20, 0, "1e+20"], [123456789012345680000, 0, "123456789012345683968"], [12.5, 0, "12.5"], [Infinity, 3, "inf"]]) {
    assert.equal(text(value, digits), expected, `${value} to ${digits} digits`);
  }
  // a tie in a sentence of both
  const tie = { ...ball, cables: [{ anchor: [0, 0], attachment: [0, 0], length: 200, restitution: 0, taut: true }], initial: { position: [0, -199.875] } };
  writeFileSync(path.join(work, "tie.toml"), `${tautline.write({ ...tie, cables: [{ ...tie.cables[0], taut: false }] }).trim()}\n`.replace(/^length = .*$/m, "$&\ntaut = true"));
  const { stderr } = spawnSync(program(), ["solve", path.join(work, "tie.toml")], { encoding: "utf8" });
  assert.deepEqual(tautline.notes(tie), [stderr.trim().split("\n")[0].replace(/^.*?toml:\d+: /, "")]);
});

test("a start on taut cables is moved, and the note says how far", () => {
  const one = structuredClone(standard);
  one.cables[0].length = 1.486; // its ends are 1.4866 m apart
  one.cables[0].taut = true;
  assert.match(tautline.notes(one).join(), /^cable 0 starts taut: the start changes its position by [\d.e-]+ m/);
  assert.deepEqual(tautline.notes(standard), []);
  assert.notDeepEqual([...tautline.solve(one).states([0]).subarray(0, 2)], one.initial.position);
});

test("wrong objects, options and times are named", () => {
  for (const [thing, sentence] of [
    [null, "the case: must be an object with the keys of a case file"],
    ["text", "the case: must be an object with the keys of a case file"],
    [[ball], "the case: is an array, must be an object with the keys of a case file"],
    [{ ...ball, duration: NaN }, "duration: is NaN, must be a finite number"],
    [{ ...ball, gravity: [0, -Infinity] }, "gravity[1]: is -Infinity, must be a finite number"],
    [{ ...ball, ceiling: null }, "ceiling: is null, leave the key out instead"],
    [{ ...ball, name: 7n }, "name: is a bigint, must be a number, text, a flag, an array or an object"],
    [{ ...ball, body: { ...ball.body, mass: -1e-7 } }, "body.mass = -1e-07: must be a finite number above 0 [kg]"],
  ]) {
    assert.deepEqual(tautline.problems(thing), [sentence]);
    assert.deepEqual(refused(() => tautline.solve(thing)), [sentence]);
  }
  const ring = { ...ball, initial: { ...ball.initial } };
  ring.initial.of = ring;
  assert.deepEqual(tautline.problems(ring), ["initial.of: contains itself"]);
  let deep = 1;
  for (let k = 0; k < 100_000; ++k) deep = [deep];
  assert.match(tautline.problems({ ...ball, duration: deep })[0], /^duration(\[0\])+: is in 8 arrays and objects, deeper than anything of a case$/);
  const half = String.raw`"a\ud800" has half of a pair of UTF-16 (a lone surrogate), which is no character`;
  assert.deepEqual(tautline.problems({ ...ball, name: "a\ud800" }), [`name: ${half}`]);
  assert.deepEqual(tautline.problems({ ...ball, "a\ud800": 1 }), [`the case: ${half}`]);
  assert.deepEqual(tautline.problems({ ...ball, name: "a\ud83e\udea2" }), []);
  assert.deepEqual(refused(() => tautline.read('name = "\udc00"')), ["case: has half of a pair of UTF-16 (a lone surrogate), which is no character"]);
  assert.deepEqual(tautline.problems({ ...ball, ceiling: undefined }), []);
  assert.deepEqual(tautline.problems({ ...ball, gravity: Float64Array.of(0, -1) }), []);
  assert.deepEqual(refused(() => tautline.solve(ball, { max_events: 0, completion_error: 0, until_locked: 1, max_steps: 2 ** 31 })), [
    "max_events 0 must be an integer above 0", "completion_error 0 must be a number above 0", "until_locked 1 must be true or false",
    "max_steps 2147483648 must be an integer above 0"]);
  assert.deepEqual(refused(() => tautline.solve(ball, { completion_error: 2 })), ["completion_error 2 must be 0, for the default, to 1"]);
  for (const [value, told] of [["1e-12", '"1e-12"'], [[1e-12], "(an array)"], [1n, "1n"], [null, "null"], [{}, "(an object)"], [Symbol("one"), "(a symbol)"],
    [Object.create(null), "(an object)"]]) {
    assert.deepEqual(refused(() => tautline.solve(ball, { completion_error: value })), [`completion_error ${told} must be a number above 0`]);
    assert.deepEqual(refused(() => tautline.sweep(ball, {}, { max_events: value })), [`max_events ${told} must be an integer above 0`]);
  }
  for (const [options, told] of [[null, "null"], ["poisson", '"poisson"'], [["law"], "(an array)"], [3n, "3n"]]) {
    for (const act of [() => tautline.solve(ball, options), () => tautline.sweep(ball, {}, options)]) {
      assert.deepEqual(refused(act), [`options ${told} must be an object`]);
    }
  }
  assert.deepEqual(refused(() => tautline.sweep(ball, {}, { settling: "yes" })), ['settling "yes" must be true or false']);
  const motion = tautline.solve(ball);
  for (const [times, message] of [[1, "times 1 must be an array of numbers"], ["12", 'times "12" must be an array of numbers'],
    [undefined, "times undefined must be an array of numbers"], [null, "times null must be an array of numbers"], [{}, "times (an object) must be an array of numbers"],
    [[0, "1"], 'times[1] "1" must be a number'], [[null], "times[0] null must be a number"], [[0, , 1], "times[1] undefined must be a number"],
    [BigInt64Array.of(1n), "times[0] 1n must be a number"]]) {
    for (const ask of ["states", "taut", "tensions", "energy", "state_errors", "energy_errors"]) assert.throws(() => motion[ask](times), { name: "TypeError", message });
    if (times !== undefined) assert.throws(() => tautline.sweep(ball, {}, { times }), { name: "TypeError", message });
    assert.throws(() => tautline.sweep(ball, { x: times }), { name: "TypeError", message: message.replace("times", "x") });
  }
  for (const [values, told] of [[0.5, "0.5"], [[1], "(an array)"], [undefined, "undefined"], [null, "null"]]) {
    assert.throws(() => tautline.sweep(ball, values), { name: "TypeError", message: `values ${told} must be an object with an array for each quantity` });
  }
  expect_same_bits(motion.states(new Set([0, 1])), motion.states(Float32Array.of(0, 1)), "states");
  for (const [time, text] of [[3, "3"], [-1e-9, "-1e-9"], [NaN, "NaN"]]) {
    for (const ask of ["states", "taut", "tensions", "energy", "state_errors", "energy_errors"]) {
      assert.deepEqual(refused(() => motion[ask]([0, time])), [`times[1] = ${text} is outside of the motion, which lasts from 0 to 2.7 s`]);
    }
  }
  assert.throws(() => tautline.write(ball, "yaml"), /format "yaml" must be "toml" or "json"/);
  motion.dispose();
  motion.dispose();
  assert.throws(() => motion.states([0]), /this motion has been disposed/);
});

test("a sweep has the bits of motions solved one by one", () => {
  const x = Float64Array.from({ length: 40 }, (_, k) => 0.02 * k), vy = [...x].reverse(), times = [0, 3.25, 19];
  const swept = tautline.sweep(standard, { x, vy, length_1: x.map(() => 1.5) }, { times, settling: true, law: "poisson" });
  assert.equal(swept.count, 40);
  assert.ok(swept.solved.includes(0) && swept.solved.includes(1));
  x.forEach((at, k) => {
    const one = structuredClone(standard), width = 6 * times.length;
    one.initial.position[0] = at;
    one.initial.velocity[1] = vy[k];
    const states = swept.states.subarray(width * k, width * k + width);
    assert.equal(Boolean(swept.solved[k]), tautline.problems(one).length === 0);
    if (!swept.solved[k]) return assert.deepEqual([swept.ending[k], swept.end_time[k], states[0]], ["", NaN, NaN]);
    const motion = tautline.solve(one, { law: "poisson" }), { summary, settling } = motion;
    expect_same_bits(states, motion.states(times), "states");
    assert.deepEqual([swept.ending[k], swept.end_time[k], swept.end_energy[k], swept.impacts[k], cables_of(swept.taut[k]), swept.settlings.time[k]],
      [summary.ending, summary.end_time, summary.end_energy, summary.impacts, summary.taut, settling.time ?? NaN]);
    assert.deepEqual([...swept.settlings.last_impact_time.subarray(2 * k, 2 * k + 2)], settling.last_impacts.map(({ time }) => time ?? NaN));
    motion.dispose();
  });
  assert.deepEqual(refused(() => tautline.sweep(standard, { x: [0], y: [1, 2] })), ["y has 2 values, x has 1: all must have as many"]);
  assert.deepEqual(refused(() => tautline.sweep(standard, { y: [0], lenght: [1] })), ["lenght: no number of the case has this name"]);
  assert.deepEqual(refused(() => tautline.sweep(standard, { y: [0] }, { times: [0, -1] })), ["times[1] = -1 must be at least 0 and finite"]);
  const table = structuredClone(standard);
  table.cables[1].restitution_table = [[0, 1], [1, 0.5]];
  for (const name of ["restitution", "restitution_1"]) {
    assert.match(refused(() => tautline.sweep(table, { [name]: [0.5] }))[0], /^restitution\w*: a cable has a restitution_table/);
  }
  assert.equal(tautline.sweep(table, { restitution_0: [0.5] }).count, 1);
  assert.equal(tautline.sweep(standard, { x: [] }).count, 0);
});

test("memory stays where it was", async () => {
  const { tautline: other, bytes } = await with_memory();
  for (let k = 0; k < 20_000; ++k) other.solve(ball).dispose();
  for (let k = 0; k < 300; ++k) other.solve(standard).dispose();
  for (let k = 0; k < 1000; ++k) refused(() => other.solve({ ...ball, duration: -1 }));
  const motion = other.solve(standard);
  const states = motion.states(Float64Array.from({ length: 1_000_000 }, (_, k) => 20e-6 * k));
  assert.deepEqual([...states.subarray(-6)], [...motion.states([20e-6 * 999_999])]);
  other.sweep(standard, { x: new Float64Array(200) }, { times: Float64Array.from({ length: 2000 }, (_, k) => 0.01 * k) });
  assert.ok(bytes() <= LARGEST_MEMORY, `${bytes()} bytes`);
});

test("after a thousand traps a module goes on, and so do its motions", async () => {
  // a call of JavaScript that throws leaves the module as a trap does: in the middle of what it does
  let traps = false;
  const instantiate = WebAssembly.instantiate;
  WebAssembly.instantiate = (module, { tautline: { write_number, read_number } }) => instantiate(module, { tautline: { read_number,
    write_number: (...words) => {
      if (traps) throw new WebAssembly.RuntimeError("unreachable");
      return write_number(...words);
    } } });
  const other = await load();
  WebAssembly.instantiate = instantiate;
  const motion = other.solve(standard);
  traps = true;
  for (let k = 0; k < 1000; ++k) {
    assert.throws(() => other.problems({ ...ball, body: { mass: -0.5 - k, inertia: 1 } }), ({ message, cause }) => cause instanceof WebAssembly.RuntimeError
      && /^tautline: tautline_\w+ has failed \(unreachable\); this is a mistake in tautline/.test(message));
  }
  traps = false;
  const deep = () => (other.problems(ball), deep()); // where JavaScript's stack ends within the module
  for (let k = 0; k < 3; ++k) assert.throws(deep, /Maximum call stack size exceeded/);
  const again = other.solve(standard), times = [0, 5, 20];
  expect_same_bits(again.states(times), tautline.solve(standard).states(times), "states");
  expect_same_bits(motion.states(times), again.states(times), "states");
  assert.equal(motion.horizon, again.horizon);
  assert.deepEqual(other.problems({ ...ball, duration: -1 }), tautline.problems({ ...ball, duration: -1 }));
});

test("a body that turns too fast to solve on has a motion, and no swing", () => {
  const [one] = cases.filter(({ name }) => name === "caught-swing");
  for (const spin of [-1e20, 1e20]) {
    const { settling } = tautline.solve({ ...one, initial: { ...one.initial, spin } });
    assert.deepEqual([settling.swing, settling.permanent], [null, false]);
  }
});

test("a motion that nobody holds gives its memory back", async () => {
  const { tautline: other, bytes } = await with_memory();
  v8.setFlagsFromString("--expose-gc");
  const collect = vm.runInNewContext("gc");
  for (let k = 0; k < 1500; ++k) {
    other.solve(standard);
    if (k % 50 === 0) {
      collect();
      await soon();
    }
  }
  assert.ok(bytes() <= LARGEST_MEMORY, `${bytes()} bytes`);
});

test("loads from an address, a path, bytes and a module", async () => {
  const file = path.join(package_folder(), "tautline.wasm"), bytes = readFileSync(file);
  const address = `data:application/wasm;base64,${bytes.toString("base64")}`;
  for (const source of [file, pathToFileURL(file), pathToFileURL(file).href, bytes, new Uint8Array(bytes).buffer,
    new WebAssembly.Module(bytes), address, new URL(address)]) {
    assert.equal((await load(source)).solve(ball).events.length, 3);
  }
  await assert.rejects(load(path.join(work, "none.wasm")), /ENOENT/);
  await assert.rejects(load(new Uint8Array(8)), WebAssembly.CompileError);
});

test("a worker takes the compiled module", async () => {
  const code = `import { parentPort, workerData } from "node:worker_threads";
    const { load } = await import(workerData.address), tautline = await load(workerData.module);
    parentPort.postMessage(tautline.solve(workerData.the_case).states([20]));`;
  const module = new WebAssembly.Module(readFileSync(path.join(package_folder(), "tautline.wasm")));
  const worker = new Worker(new URL(`data:text/javascript,${encodeURIComponent(code)}`),
    { workerData: { address: pathToFileURL(path.join(package_folder(), "tautline.mjs")).href, module, the_case: standard } });
  const states = await new Promise((resolve, reject) => worker.once("message", resolve).once("error", reject));
  expect_same_bits(states, tautline.solve(standard).states([20]), "states");
  await worker.terminate();
});

test("the module is small, and needs nothing but numbers as text", () => {
  const bytes = readFileSync(path.join(package_folder(), "tautline.wasm")), size = gzipSync(bytes, { level: 9 }).length;
  assert.ok(size <= LARGEST_MODULE, `${size} bytes with gzip`);
  const imports = WebAssembly.Module.imports(new WebAssembly.Module(bytes)).map(({ module, name }) => `${module}.${name}`);
  assert.deepEqual(imports.sort(), ["tautline.read_number", "tautline.write_number"]);
});

test("what npm packs installs without a network, and has the licences", (context) => {
  if (spawnSync("npm", ["--version"]).status !== 0) return context.skip("no npm");
  const npm = (...words) => execFileSync("npm", words, { cwd: work, encoding: "utf8" });
  const [packed] = JSON.parse(npm("pack", "--json", package_folder()));
  assert.deepEqual(packed.files.map((file) => file.path).sort(),
    ["LICENSE", "NOTICE", "README.md", "cases.json", "example.mjs", "package.json", "tautline.d.ts", "tautline.mjs", "tautline.wasm"]);
  assert.deepEqual(packed.files.map((file) => file.path).sort(), readdirSync(package_folder()).sort());
  const links = [...readFileSync(path.join(package_folder(), "README.md"), "utf8").matchAll(/\]\(([^)#]+)\)/g)].map(([, link]) => link);
  assert.ok(links.length > 0);
  for (const link of links) assert.ok(packed.files.some((file) => file.path === link), `README.md: ${link} is not in the package`);
  const notice = readFileSync(path.join(package_folder(), "NOTICE"), "utf8");
  for (const words of ["Eigen", "MPL-2.0", "musl", "libc++", "LLVM exception", "toml++", "JSON for Modern C++", "MIT"]) assert.ok(notice.includes(words), words);
  const user = path.join(work, "user");
  mkdirSync(user);
  writeFileSync(path.join(user, "package.json"), "{}");
  npm("install", "--prefix", user, "--offline", "--no-audit", "--no-fund", path.join(work, packed.filename));
  const example = execFileSync("node", ["node_modules/tautline/example.mjs"], { cwd: user, encoding: "utf8" });
  assert.match(example, /^impact at 1 s, right to 5e-15 s\n/);
  writeFileSync(path.join(user, "user.mjs"), `import { load } from "tautline";
    import { createRequire } from "node:module";
    const require = createRequire(import.meta.url), [first] = require("tautline/cases.json");
    console.log((await load(require.resolve("tautline/tautline.wasm"))).solve(first).ending);`);
  assert.equal(execFileSync("node", ["user.mjs"], { cwd: user, encoding: "utf8" }), "reached_duration\n");
});
