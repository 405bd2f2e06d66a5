// Every figure can be saved, as SVG and as CSV, from disk and without a network.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import test from 'node:test';
import { drawAll, drawnPages, onSharedPage, pages, settled, withPage } from './browser.mjs';

/// Chromium drops what a page saves beyond ten files a second.
const pause = 150; // [ms]

/// What a press of a button saves: {name, text}.
async function saved(page, button) {
  await page.waitForTimeout(pause);
  const [download] = await Promise.all([page.waitForEvent('download'), button.press('Enter')]);
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
}

/// The cells of each line of a CSV file; one with a comma is in quotes.
const linesOf = (text) => text.trim().split('\n').map((line) => line.match(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)
  .slice(0, line.endsWith(',') ? undefined : -1).map((cell) => cell.replace(/,$/, '')));

test('no chart has a button that needs a network, and each has two that save it', () => onSharedPage(async ({ page }) => {
  const charts = await page.evaluate(() => Object.entries(tautline.charts).filter(([, { body }]) => !body.hidden).map(([id, { element }]) => {
    let next = element.nextElementSibling;
    for (; next && next.className !== 'save'; next = next.nextElementSibling);
    return { id, bar: [...element.querySelectorAll('.modebar-btn')].map((one) => one.getAttribute('data-title')),
      save: [...(next?.querySelectorAll('button') ?? [])].map((one) => one.textContent) };
  }));
  assert.ok(charts.length >= 6);
  for (const { id, bar, save } of charts) {
    assert.deepEqual(bar, ['Zoom', 'Pan', 'Zoom in', 'Zoom out', 'Reset axes'], id);
    assert.deepEqual(save, ['Save as SVG', 'Save numbers as CSV'], id);
  }
}));

for (const file of pages()) {
  test(`${basename(file)}: what is saved of each chart is a picture and its numbers`, () => withPage(file, async ({ page, said }) => {
    await drawAll(page);
    const shown = page.locator('.save:visible');
    assert.ok(await shown.count() >= 5);
    for (const row of await shown.all()) {
      const picture = await saved(page, row.locator('button').first());
      assert.match(picture.name, /^tautline-[\w.-]+\.svg$/);
      assert.match(picture.text, /^<svg[^]*<path[^]*<\/svg>\s*$/);
      const numbers = await saved(page, row.locator('button').last());
      assert.equal(numbers.name, picture.name.replace(/svg$/, 'csv'));
      const [head, ...rows] = linesOf(numbers.text);
      assert.ok(head.length >= 4 && head.some((one) => /\[.+\]/.test(one)), numbers.text.slice(0, 200));
      assert.ok(rows.length > 0, numbers.name);
    }
    assert.deepEqual(said, []);
  }, { acceptDownloads: true }));
}

test('the saved numbers of error against step are those of the report', () => onSharedPage(async ({ page }) => {
  const name = await page.evaluate(() => tautline.report.cases[0].name);
  await page.evaluate((one) => { location.hash = `#error?case=${one}`; }, name);
  await settled(page);
  const { text } = await saved(page, page.locator('#chart-step ~ .save button').nth(1));
  const runs = await page.evaluate((the) => tautline.report.runs.filter((run) => run.case === the && run.status === 'finished'
    && run.metrics && run.engine !== 'exact'), name);
  const [head, ...rows] = linesOf(text);
  // a case of its own units has neither metres nor seconds
  assert.match(head.slice(0, 5).join(), /^case,engine,model,step \[[s-]\],early position error \[[m-]\]$/);
  assert.equal(rows.length, runs.length);
  for (const run of runs) {
    const row = rows.find((one) => one[1] === run.engine && one[2] === run.model && Number(one[3]) === run.step);
    assert.equal(Number(row[4]), run.metrics.early_position_error, row.join()); // rounding, too
  }
}));

for (const file of drawnPages()) {
  test(`${file}: its figures are saved as they are, with their numbers`, () => withPage(file, async ({ page, said, asked }) => {
    const rows = page.locator('figure.drawn + .save');
    assert.ok(await rows.count() > 0);
    assert.equal(await rows.count(), await page.locator('figure.drawn').count());
    for (const row of await rows.all()) {
      const picture = await saved(page, row.locator('button').first());
      assert.match(picture.text, /^<svg[^]*<\/svg>\s*$/);
      const [head, ...lines] = linesOf((await saved(page, row.locator('button').last())).text);
      assert.ok(head.length >= 3 && lines.length > 0);
      lines.forEach((line) => assert.equal(line.length, head.length, line.join()));
    }
    assert.deepEqual(said, []);
    assert.equal(asked.filter((url) => !/^(data|blob):/.test(url)).length, 1);
  }));
}
