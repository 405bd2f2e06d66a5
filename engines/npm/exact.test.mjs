// Compares the engines whose packages npm has brought with the exact motion, in node's own test runner: node --test

import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { bar, dull_bar, lateness } from "../protocol/javascript/exact.mjs";

const { load } = await import(process.env.TAUTLINE_MODULE ?? "tautline");
const tautline = await load();
const folder = (engine) => fileURLToPath(new URL(`${engine}/`, import.meta.url));
/** The command of an engine.toml. */
const command = (engine) => JSON.parse(/^command = (.*)$/m.exec(readFileSync(`${folder(engine)}engine.toml`, "utf8"))[1]);
const engines = readdirSync(folder(".")).filter((engine) => existsSync(`${folder(engine)}node_modules`));

for (const engine of engines) {
  const late = (options) => lateness(tautline, command(engine), folder(engine), bar, { model: "row", ...options });
  test(`${engine}: row is on the exact path`, () => {
    for (const step of [1e-2, 1e-3]) assert.ok(late({ step }) < 1, `step ${step} s`);
  });
  test(`${engine}: 3 % of the restitution would be noticed`, () => assert.ok(late({ step: 1e-4, exact_case: dull_bar }) > 1));
}

test("there is an engine to compare", () => assert.notEqual(engines.length, 0, "run: scripts/install-packages npm-engines"));
