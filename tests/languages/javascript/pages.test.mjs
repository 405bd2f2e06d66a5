// What the pages for users of JavaScript show runs: in node, and in a browser with a worker.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { package_folder, root } from "./support.mjs";

const work = mkdtempSync(path.join(tmpdir(), "tautline-pages-"));
after(() => rmSync(work, { recursive: true }));
mkdirSync(path.join(work, "node_modules"));
symlinkSync(package_folder(), path.join(work, "node_modules/tautline"));

/** The blocks of a page: {language, code}; the language may have a second word, as in "js worker". */
const blocks = (page) => [...readFileSync(path.join(root, page), "utf8").matchAll(/^```(js[ \w]*)\n([\s\S]*?)^```/gm)]
  .map(([, language, code]) => ({ language, code }));

/** What a block prints. */
function run(code) {
  writeFileSync(path.join(work, "block.mjs"), code);
  return execFileSync("node", ["block.mjs"], { cwd: work, encoding: "utf8" });
}

test("the README of the package runs", () => {
  const [{ code }, ...others] = blocks("languages/javascript/README.md");
  assert.equal(others.length, 0);
  assert.match(run(code), /^\[ 1, 2, 2\.5 \]\nFloat64Array\(6\) \[[^\]]*\]\nInfinity true\n$/);
});

test("the block of the project's README runs", () => {
  const [{ code }, ...others] = blocks("README.md");
  assert.equal(others.length, 0);
  assert.ok(code.split("\n").length <= 11);
  assert.equal(run(code), "[ 1, 2, 2.5 ]\n");
});

test("the blocks of the guide run", () => {
  const [first, many, ...others] = blocks("docs/guides/javascript.md").filter(({ language }) => language === "js");
  assert.equal(others.length, 0);
  assert.match(run(first.code), /^417 reached_duration 8\.12\d\d\nimpact \[ \d \] \d\.\d+ true\n0\.07\n$/);
  assert.match(run(many.code), /^50 0\.8 locked\n$/);
});

test("the test of the kit's README runs, and passes", () => {
  const kit = path.join(root, "engines/protocol/javascript");
  symlinkSync(kit, path.join(work, "node_modules/tautline-engine"));
  writeFileSync(path.join(work, "engine.mjs"), `import ${JSON.stringify(path.join(kit, "example/engine.mjs"))};`);
  const { code } = blocks("engines/protocol/javascript/README.md").at(-1);
  assert.ok(code.split("\n").length <= 12);
  writeFileSync(path.join(work, "kit.test.mjs"), code);
  const { NODE_TEST_CONTEXT: _, ...env } = process.env; // or it would report to this test
  assert.match(execFileSync("node", ["--test", "kit.test.mjs"], { cwd: work, encoding: "utf8", env }), /pass 1\n/);
});

const browser = path.join(root, "tests/page/node_modules/playwright-core/index.mjs");
const chromium = process.env.TAUTLINE_CHROMIUM || "/usr/bin/chromium";
test("the page of the guide solves in a worker", { skip: !existsSync(browser) || !existsSync(chromium) }, async () => {
  const block = (language) => blocks("docs/guides/javascript.md").find((one) => one.language === language).code;
  for (const name of ["tautline.mjs", "tautline.wasm"]) copyFileSync(path.join(package_folder(), name), path.join(work, name));
  writeFileSync(path.join(work, "worker.mjs"), block("js worker"));
  writeFileSync(path.join(work, "page.html"), `<!doctype html><script type="module">${block("js page")}</script>`);
  const server = createServer((question, answer) => {
    const file = path.join(work, path.basename(question.url));
    if (!existsSync(file)) return answer.writeHead(404).end();
    answer.setHeader("content-type", file.endsWith(".html") ? "text/html" : file.endsWith(".mjs") ? "text/javascript" : "application/wasm");
    answer.end(readFileSync(file));
  }).listen(0, "127.0.0.1");
  const { chromium: driver } = await import(browser);
  const opened = await driver.launch({ executablePath: chromium, timeout: 120_000,
    args: ["--disable-dev-shm-usage", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])] });
  try {
    const page = await opened.newPage();
    await page.goto(`http://127.0.0.1:${server.address().port}/page.html`);
    await page.waitForFunction(() => document.title !== "", undefined, { timeout: 120_000 });
    assert.equal(await page.title(), "3 impacts, at rest on the cable: y = 0");
  } finally {
    await opened.close();
    server.close();
  }
});
