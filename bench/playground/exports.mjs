// The forms in which a case leaves the page. Each is text() and the name of a file().

import { shippedAs } from "./case.mjs";

/// `page`: state, shipped, motion.
export function formsOf(page) {
  const name = () => page.state.the_case.name.replace(/[^\w.-]+/g, "-").replace(/^-+|-+$/g, "") || "case";
  const shipped = () => shippedAs(page.state.the_case, page.shipped);
  const law = (text) => (page.state.law === "simultaneous" ? "" : text(page.state.law));
  // the text of a motion that was solved; an impossible case has none
  const solved = (text) => () => (page.impossible ? `# ${page.impossible}\n` : page.motion?.toml ? text() : "");
  const file = () => (shipped() ? "" : `cat > ${name()}.toml <<'END'\n${page.motion.toml}END\n`);
  const called = () => (shipped() ? page.state.the_case.name : `${name()}.toml`);
  const command = (word) => `${file()}tautline ${word} ${called()}${law((one) => ` --law ${one}`)}`;
  return {
    "case file": { text: solved(() => page.motion.toml), file: () => `${name()}.toml` },
    "command": { text: solved(() => `${command("solve")}\n`), file: () => `${name()}.sh` },
    "Python": { file: () => `${name().replaceAll("-", "_")}.py`, text: solved(() => {
      // JSON's text is also a text of Python
      const one = shipped() ? `tl.Case.shipped(${JSON.stringify(page.state.the_case.name)})`
        : `tl.Case.from_json(${JSON.stringify(page.motion.json.replace(/\n\s*/g, " ").trim())})`;
      return `import tautline as tl; motion = tl.solve(${one}${law((text) => `, law="${text}"`)})\n`;
    }) },
    "test vector": { file: () => `${name()}.sh`, text: solved(() =>
      `# Run this: it solves the case in many digits, and writes the vector to ${name()}.json\n${command("vector")} --json ${name()}.json\n`) },
    "events": { text: solved(() => eventTable(page.motion)), file: () => `${name()}-events.csv` },
    "link": { text: () => `${location.href}\n`, file: () => `${name()}.txt` },
  };
}

/// The events to the last bit, as `tautline solve --json` has them.
function eventTable({ events, the_case: { cables } }) {
  const state = ["x", "y", "angle", "vx", "vy", "spin"];
  const rows = [["time", "kind", "cables", ...state.map((one) => `${one}_before`), ...state.map((one) => `${one}_after`), ...cables.map((_, i) => `impulse_${i}`)]];
  for (let i = 0; i < events.count; ++i) {
    rows.push([events.time[i], events.kind[i], cables.map((_, k) => k).filter((k) => (events.cables[i] >> k) & 1).join("+"),
      ...events.before.subarray(6 * i, 6 * i + 6), ...events.after.subarray(6 * i, 6 * i + 6),
      ...events.impulses.subarray(cables.length * i, cables.length * (i + 1)).map((one) => Math.max(0, one))]); // below are gravity's
  }
  return `${rows.map((row) => row.join(",")).join("\n")}\n`;
}
