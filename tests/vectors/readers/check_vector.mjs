// Checks an engine's samples against a test vector:  node check_vector.mjs VECTOR.json SAMPLES STEP
// SAMPLES has a line `time x y angle` for the start and each step, `-` is standard input; what follows on a line and
// lines that begin with # are ignored. Exit code 0: right, 1: wrong, 2: cannot be used. Or import `check`.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

/** What is right or wrong about `samples`: [time, x, y, angle] of the start and each step. */
export function check(vector, samples, step) {
  let place = 1, asked = 0, worst = 0, hit = 0;
  if (vector.format !== "tautline-vector-1") throw new Error("not a tautline-vector-1");
  for (const { time, state, growth, kind, step: longest } of vector.rows) {
    if (!(step <= longest * (1 + 1e-9))) break; // such a step cannot be judged here, nor later
    while (place < samples.length && samples[place][0] < time - 1e-9 * step) ++place;
    if (place >= samples.length) return { right: false, sentence: `wrong: no sample at t = ${time} or later` };
    const a = samples[place - 1], b = samples[place], part = b[0] > a[0] ? Math.min(1, (time - a[0]) / (b[0] - a[0])) : 1;
    const by = [1, 2, 3].map((i) => a[i] + part * (b[i] - a[i]) - state[i - 1]);
    const off = Math.hypot(by[0], by[1], vector.radius * by[2]), allowed = 2 * step * vector.fastest * growth;
    if (!(off <= allowed)) {
      const [is, may] = [off, allowed].map((number) => number.toPrecision(2));
      return { right: false,
        sentence: `wrong: at t = ${time} it is ${is} m off, ${may} m are allowed; the impact before is at t = ${hit}` };
    }
    ++asked; worst = Math.max(worst, off / allowed); if (kind === "impact") hit = time;
  }
  if (asked < 2) throw new Error("this step is too long for the vector");
  return { right: true, sentence: `right: ${asked} rows asked, at worst ${worst.toPrecision(2)} of what is allowed` };
}
if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    const lines = readFileSync(process.argv[3] === "-" ? 0 : process.argv[3], "utf8").split("\n");
    const rows = lines.filter((line) => line.trim() && line[0] !== "#").map((line) => line.trim().split(/\s+/).map(Number));
    if (rows.some((row) => row.length < 4)) throw new Error("a sample is not `time x y angle`");
    const { right, sentence } = check(JSON.parse(readFileSync(process.argv[2], "utf8")), rows, Number(process.argv[4]));
    console.log(sentence); process.exitCode = right ? 0 : 1;
  } catch (error) { console.error(error.message); process.exitCode = 2; }
}
