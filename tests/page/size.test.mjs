import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { benchPage, withText } from './browser.mjs';
import { withReport } from './page.mjs';
import { synthetic } from './synthetic.mjs';

/// A page of a few cases, and one of all: bytes, and milliseconds to open.
const quick = { bytes: 4e6, milliseconds: 1000 };
const full = { bytes: 10e6, milliseconds: 3000 };
/// The page's own processor time is held to the limit, and the fastest counts: what else the machine does
/// is no fault of the page.
const tries = 3;

const cases = Array.from({ length: 21 }, (_, i) => `breakwater/${i + 1}`);

/// The page of the program, its tables filled up with rows like its own to as many as the report has runs.
function largePage(report) {
  const page = withReport(readFileSync(benchPage(), 'utf8'), report);
  const rows = page.match(/<table id="cases-table"[\s\S]*?<\/table>/)[0].match(/<tr[^>]*>(?:(?!<\/tr>)[\s\S])*<td[\s\S]*?<\/tr>/g);
  const many = Array.from({ length: report.runs.length }, (_, i) => rows[i % rows.length]).join('\n');
  return page.replace(/(<table id="cases-table"[\s\S]*?<tbody>)/, (whole) => whole + many);
}

/// The fewest impacts of a run that a page has: thinning.cpp.
const mostImpacts = 24;

/// A report of so many cases as a page has it: without the motions of its runs, which lie beside it, and with
/// few impacts of each.
function reportOf(count, steps) {
  const report = synthetic({ cases: cases.slice(0, count), duration: 20, steps, samples: 40 });
  const thinned = (impacts) => impacts.map((column) => (Array.isArray(column) ? column.slice(0, mostImpacts) : column));
  return { ...report, runs: report.runs.map(({ details, ...run }) => ({ ...run, impacts: thinned(run.impacts) })) };
}

for (const [name, count, steps, most] of [['six cases', 6, [1e-2, 1e-3], quick], ['21 cases', 21, [1e-2, 1e-3], full]]) {
  test(`a page of ${name} and all engines is below ${most.bytes / 1e6} MB and opens in ${most.milliseconds / 1000} s`, async (context) => {
    const report = reportOf(count, steps);
    const text = largePage(report);
    context.diagnostic(`${report.runs.length} runs, ${(Buffer.byteLength(text) / 1e6).toFixed(1)} MB`);
    assert.ok(Buffer.byteLength(text) < most.bytes);
    const times = [];
    for (let i = 0; i < tries && !(Math.min(...times.map(({ worked }) => worked)) < most.milliseconds); ++i) {
      await withText(text, ({ waited, worked }) => times.push({ waited, worked }));
    }
    context.diagnostic(`opened in ${times.map(({ waited, worked }) =>
      `${waited.toFixed(0)} ms (worked for ${worked.toFixed(0)} ms)`).join(', ')}`);
    assert.ok(Math.min(...times.map(({ worked }) => worked)) < most.milliseconds);
  });
}
