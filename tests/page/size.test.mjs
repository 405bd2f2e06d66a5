import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { benchPage, withText } from './browser.mjs';
import { withReport } from './page.mjs';
import { synthetic } from './synthetic.mjs';

/// A page of a few cases, and one of all [bytes].
/// These cases are hit more often than those of the quick suite, whose page of all engines has less than 3 MB.
const quick = 3.5e6;
const full = 10e6;

/// What opening may add to the text of a page, in counts, which no machine changes: three times of what was measured
/// when they were set. Charts and most tables are made when they come into view.
const most = {
  nodes: 8000,      // made by scripts, beside those of the text: 1,900 to 2,600
  layouts: 15,      // of the page: 5 or 6
  listeners: 660,   // 217
  heap: 8,          // bytes of JavaScript's heap for each byte of the page: 1.9 to 2.6
};
/// The page's own processor time, of that of the same page without its scripts, measured in turns: 1.8 to 2.5.
const slower = 8;
/// The least of so many counts: another's load on the machine only ever adds.
const tries = 3;

const cases = Array.from({ length: 30 }, (_, i) => `breakwater/${i + 1}`);

/// The page of the program, its tables filled up with rows like its own to as many as the report has runs.
function largePage(report) {
  const page = withReport(readFileSync(benchPage(), 'utf8'), report);
  const rows = page.match(/<table id="cases-table"[\s\S]*?<\/table>/)[0].match(/<tr[^>]*>(?:(?!<\/tr>)[\s\S])*<td[\s\S]*?<\/tr>/g);
  const many = Array.from({ length: report.runs.length }, (_, i) => rows[i % rows.length]).join('\n');
  return page.replace(/(<table id="cases-table"[\s\S]*?<tbody>)/, (whole) => whole + many);
}

/// The impacts that a page has of one of so many runs: replay.cpp.
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

for (const [name, count, steps, bytes] of [['six cases', 6, [1e-2, 1e-3], quick], ['30 cases', 30, [1e-2, 1e-3, 1e-4], full]]) {
  test(`a page of ${name} and all engines is below ${bytes / 1e6} MB, and opening it adds little to its text`, async (context) => {
    const report = reportOf(count, steps);
    const text = largePage(report);
    const size = Buffer.byteLength(text);
    context.diagnostic(`${report.runs.length} runs, ${(size / 1e6).toFixed(2)} MB`);
    assert.ok(size < bytes);
    const open = (javaScriptEnabled) => withText(text, ({ opening }) => opening, { javaScriptEnabled });
    const [scripted, bare] = [[], []];
    for (let i = 0; i < tries; ++i) {
      scripted.push(await open(true));
      bare.push(await open(false));
    }
    const least = (all, metric) => Math.min(...all.map((one) => one[metric]));
    const counts = { nodes: least(scripted, 'Nodes') - least(bare, 'Nodes'), layouts: least(scripted, 'LayoutCount'),
      listeners: least(scripted, 'JSEventListeners'), heap: least(scripted, 'JSHeapUsedSize') / size };
    const ratio = least(scripted, 'TaskDuration') / least(bare, 'TaskDuration');
    context.diagnostic(`${JSON.stringify(counts)}, ${ratio.toFixed(2)} times the work of the text alone`);
    for (const [what, found] of Object.entries(counts)) {
      assert.ok(found <= most[what], `${what}: ${found}, ${most[what]} at most`);
    }
    assert.ok(ratio <= slower, `${ratio} times the work of the text alone, ${slower} at most`);
  });
}
