// What the tests of the package share: where it is, and the cases that come with tautline.
import { readFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const root = fileURLToPath(new URL("../../..", import.meta.url));

function variable(name) {
  if (!process.env[name]) throw new Error(`set ${name}: ctest does`);
  return process.env[name];
}
/** The folder of the package that the build has put together. */
export const package_folder = () => variable("TAUTLINE_PACKAGE");
/** The program of tests/languages/javascript/motions.cpp. */
export const motions_program = () => variable("TAUTLINE_MOTIONS");
/** The program `tautline`. */
export const program = () => variable("TAUTLINE_PROGRAM");

export const { load, cables_of } = await import(pathToFileURL(path.join(package_folder(), "tautline.mjs")));
export const cases = JSON.parse(readFileSync(path.join(root, "languages/python/src/tautline/cases.json"), "utf8"));
export const shipped = (name) => structuredClone(cases.find((one) => one.name === name));

/** Fails at the first number that has other bits; any NaN is as good as another. */
export function expect_same_bits(got, expected, what) {
  if (got.length !== expected.length) throw new Error(`${what}: has ${got.length} numbers, not ${expected.length}`);
  for (let k = 0; k < got.length; ++k) {
    if (!Object.is(got[k], expected[k])) throw new Error(`${what}[${k}] = ${got[k]}, not ${expected[k]}`);
  }
}
