import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { benchPage, withText } from './browser.mjs';
import { withReport } from './page.mjs';
import { synthetic } from './synthetic.mjs';

/// A page of a few cases, and one of all: bytes, and milliseconds to open.
/// These cases are hit more often than those of the quick suite, whose page of all engines has less than 3 MB.
const quick = { bytes: 3.5e6, milliseconds: 1000 };
const full = { bytes: 10e6, milliseconds: 3000 };
/// The page's own processor time is held to the limit, and the fastest counts: what else the machine does
/// is no fault of the page.
const tries = 3;

const cases = Array.from({ length: 30 }, (_, i) => `breakwater/${i + 1}`);

/// The page of the program, its tables filled up with rows like its own to as many as the report has runs.
function largePage(report) {
  const page = withReport(readFileSync(benchPage(), 'utf8'), report);
  const rows = page.match(/<table id="cases-table"[\s\S]*?<\/table>/)[0].match(/<tr[^>]*>(?:(?!<\/tr>)[\s\S])*<td[\s\S]*?<\/tr>/g);
  const many = Array.from({ length: report.runs.length }, (_, i) => rows[i % rows.length]).join('\n');
  return page.replace(/(<table id="cases-table"[\s\S]*?<tbody>)/, (whole) => whole + many);
}

/// The impacts that a page has of one of so many runs: thinning.cpp.
const impactsOf = (runs) => Math.max(3, Math.floor(800000 / runs / 70));

/// A number with the digits that a report has of a cause or a cost.
const short = (value) => Number(value.toPrecision(4));

/// A report of so many cases as a page has it: without the motions of its runs, which lie beside it, with few
/// impacts of each, and with the audit of one run in forty, since most have nothing to show.
function reportOf(count, steps) {
  const report = synthetic({ cases: cases.slice(0, count), duration: 20, steps, samples: 40 });
  const thinned = (impacts) => impacts.map((column) => (Array.isArray(column) ? column.slice(0, impactsOf(report.runs.length)) : column));
  return { ...report, runs: report.runs.map(({ details, audit, attribution, ...run }, i) => ({ ...run, impacts: thinned(run.impacts),
    cost: run.cost?.map(short), ...(i % 40 === 0 && { audit }),
    ...(attribution && { attribution: { ...attribution, parts: attribution.parts?.map(short) } }) })) };
}

for (const [name, count, steps, most] of [['six cases', 6, [1e-2, 1e-3], quick], ['30 cases', 30, [1e-2, 1e-3, 1e-4], full]]) {
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
