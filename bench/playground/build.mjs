// Makes the page, one HTML file.
//
//   node build.mjs JAVASCRIPT OUT [--rapier]
//
// JAVASCRIPT is the folder of the built JavaScript package, OUT the file to write.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { buildSync as plain, build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url)), root = resolve(here, "../..");
const [javascript, out, ...flags] = process.argv.slice(2), rapier = flags.includes("--rapier");
if (!out || flags.some((flag) => flag !== "--rapier")) {
  console.error("usage: node build.mjs JAVASCRIPT OUT [--rapier]");
  process.exit(2);
}
const text = (path) => readFileSync(resolve(here, path), "utf8");
const json = (path) => JSON.parse(text(path));

/// The plug-ins in the page, and the packages that they run.
const plugins = { planck: "planck", ...(rapier && { rapier2d: "@dimforge/rapier2d-compat" }) };
const versions = Object.fromEntries(Object.entries(plugins).map(([plugin, name]) => {
  const [ours, theirs] = ["package.json", `../../engines/npm/${plugin}/package.json`].map((path) => json(path).dependencies[name]);
  if (ours !== theirs) throw new Error(`${name} is ${ours} in bench/playground and ${theirs} in engines/npm/${plugin}`);
  return [name, ours];
}));

/// A module and what it imports as one text, a script: Chromium starts no module in a worker of a page from disk. The
/// engines wait at their top level, so it is a function.
async function bundle(entry, define = {}) {
  const instead = { name: "instead", setup({ onResolve }) {
    onResolve({ filter: /protocol\/javascript\/engine\.mjs$|common\/version\.mjs$/ }, () => ({ path: join(here, "engine_host.mjs") }));
    onResolve({ filter: /^tautline$/ }, () => ({ path: resolve(javascript, "tautline.mjs") }));
  } };
  const { outputFiles: [file] } = await build({ ...entry, bundle: true, format: "esm", target: "es2022", minify: true, write: false, charset: "utf8",
    legalComments: "none", plugins: [instead], nodePaths: [join(here, "node_modules")], define: { "import.meta.url": '""', ...define } });
  return `(async () => {${file.text}})().catch(({ message }) => postMessage({ failed: message }));`;
}

const solver = await bundle({ entryPoints: [join(here, "worker.mjs")] });
const engines = await bundle({ stdin: { resolveDir: here, contents: [
  ...Object.keys(plugins).map((plugin) => `import "../../engines/npm/${plugin}/engine.mjs";`), 'import "./engines.mjs";'].join("\n") } },
{ VERSIONS: JSON.stringify(versions) });
const app = await bundle({ entryPoints: [join(here, "app.mjs")] }, { SOLVER_SOURCE: JSON.stringify(solver), ENGINES_SOURCE: JSON.stringify(engines),
  CASES: JSON.stringify(json("../../languages/python/src/tautline/cases.json")) });
const style = plain({ entryPoints: [join(here, "style.css")], minify: true, write: false, logLevel: "error" }).outputFiles[0].text;

const licences = [["tautline", join(root, "LICENSE")], ["tautline.wasm", resolve(javascript, "NOTICE")], ...Object.values(plugins).map((name) =>
  [`${name} ${versions[name]}`, join(here, "node_modules", name, name === "planck" ? "LICENSE.txt" : "LICENSE")])]
  .map(([name, path]) => `${name}\n\n${readFileSync(path, "utf8")}`).join("\n\n").replaceAll("-->", "-- >");
const parts = {
  STYLE: style,
  WASM: gzipSync(readFileSync(resolve(javascript, "tautline.wasm")), { level: 9 }).toString("base64"),
  APP: app.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--"),
  RAPIER: rapier ? "" : "A page with Rapier is larger than this one: <code>scripts/playground --rapier</code> makes it.",
  LICENCES: `<!--\n${licences}\n-->`,
};
const page = text("page.html").replace(/<!--([A-Z]+)-->/g, (_, name) => parts[name]);
mkdirSync(dirname(resolve(out)), { recursive: true });
writeFileSync(out, page);
const kb = (bytes) => `${(bytes.length / 1000).toFixed(0)} kB`;
console.log(`${out}: ${kb(Buffer.from(page))}, ${kb(gzipSync(page, { level: 9 }))} gzip; solver ${kb(parts.WASM)} of it, engines ${kb(engines)}`);
