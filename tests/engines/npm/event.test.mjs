// node event.test.mjs ENGINE PROGRAM: the model `event` of one engine of engines/npm, run by the program to the end of the
// standard case. Exit code 77 says that the engine's package is not here.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { engineFolder, isFetched } from "./client.mjs";
import { exact } from "./standard_case.mjs";

const [, , name, program] = process.argv;
if (!isFetched(name)) {
  console.log(`skipped: the package of ${name} is not here; scripts/install-packages npm-engines brings it`);
  process.exit(77);
}

const work = mkdtempSync(join(tmpdir(), "tautline-npm-"));
after(() => rmSync(work, { recursive: true }));

const inDouble = ["mujoco3", "planck", "matter", "cannon", "p2"].includes(name);

/** The largest distance from the exact motion up to t = 2 [m]: rounding in double, and in float that of every step. */
const largest = inDouble ? 1e-11 : 2e-5;

/** The largest distance up to `end` [s] of what the program wrote to `path`: time, x, y, ... */
function deviation(path, end) {
  const rows = readFileSync(path, "utf8").trim().split("\n").slice(1).map((line) => line.split(",").map(Number));
  const distances = rows.filter(([time]) => time <= end).map(([time, x, y]) => Math.hypot(x - exact(time)[0], y - exact(time)[1]));
  assert.ok(distances.length > 10);
  return Math.max(...distances);
}

for (const step of ["1e-2", "1e-3"]) {
  test(`is exact to its precision in steps of ${step} s, and finds each impact`, () => {
    const out = join(work, step);
    const run = JSON.parse(execFileSync(program, ["run", "breakwater/1910121100", "--engine", `${engineFolder(name)}/engine.toml`,
      "--model", "event", "--step", step, "--out", out, "--json", "-"], { maxBuffer: 1 << 28 }));
    assert.equal(run.status, "finished", run.reason);
    const found = deviation(join(out, "runs/breakwater/1910121100", name, "event", String(Number(step)), "trajectory.csv"), 2);
    assert.ok(found <= largest, `off by ${found}, ${largest} at most`);
    const { exact: all, found: seen, matched } = run.details.whole;
    console.log(`  off by ${found} up to t = 2; ${matched} of ${all} impacts matched, ${seen} found`);
    if (inDouble) assert.deepEqual([seen, matched], [all, 79]);
  });
}
