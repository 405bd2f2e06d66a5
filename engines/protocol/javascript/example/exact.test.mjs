// Compares the example with the exact motion in node's own test runner: node --test

import assert from "node:assert/strict";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { bar, dull_bar, lateness } from "../exact.mjs"; // "tautline-engine/exact" where the kit is installed by npm

const { load } = await import(process.env.TAUTLINE_MODULE ?? "tautline");
const tautline = await load(), folder = fileURLToPath(new URL(".", import.meta.url));
const late = (options) => lateness(tautline, ["node", "engine.mjs"], folder, bar, { model: "row", ...options });

for (const step of [1e-2, 1e-3, 1e-4]) {
  test(`row is on the exact path with steps of ${step} s`, () => assert.ok(late({ step }) < 1));
}

test("3 % of the restitution would be noticed", () => assert.ok(late({ step: 1e-4, exact_case: dull_bar }) > 1));
