import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { drawAll, withPage } from './browser.mjs';

const file = process.env.TAUTLINE_CHAPTER_PAGE;
if (!file) {
  throw new Error('set TAUTLINE_CHAPTER_PAGE to a chapter.html that `tautline reproduce` wrote');
}
/// The same numbers, as the program writes them for scripts.
const chapter = JSON.parse(readFileSync(join(dirname(file), 'chapter.json'), 'utf8'));

test('the page opens from disk, says nothing on the console and asks for nothing but itself', async () => {
  await withPage(file, async ({ page, said, asked }) => {
    await drawAll(page);
    assert.deepEqual(said, []);
    assert.deepEqual(asked.filter((url) => !/^(data|blob):/.test(url)), [pathToFileURL(file).href]);
  });
});

test('every figure is drawn, with a unit on each axis, and its motion fills the plot', async () => {
  await withPage(file, async ({ page }) => {
    await drawAll(page);
    const drawn = await page.evaluate(() => Object.entries(tautline.charts).map(([name, { body }]) => {
      const { xaxis, yaxis } = body._fullLayout;
      const curves = body._fullData.filter((one) => /^(case|cable) /.test(one.name));
      const filled = (key, { range }) => {
        const values = curves.flatMap((one) => [...one[key]]);
        return (Math.max(...values) - Math.min(...values)) / (range[1] - range[0]);
      };
      return { name, x: xaxis.title.text, y: yaxis.title.text, fills: [filled('x', xaxis), filled('y', yaxis)] };
    }));
    assert.deepEqual(drawn.map(({ name, x, y }) => ({ name, x, y })),
      chapter.figures.map(({ name, x, y }) => ({ name, x: x.replace('sqrt', '√'), y: y.replace('sqrt', '√') })));
    for (const { name, x, y, fills } of drawn) {
      assert.match(`${x} ${y}`, /\[[^\]]+\].*\[[^\]]+\]/, name);
      assert.ok(Math.min(...fills) > 0.8 && Math.max(...fills) < 1, `${name}: ${fills}`);
    }
  });
});

test('marks stand at their instants, and only where time is the abscissa', async () => {
  await withPage(file, async ({ page }) => {
    await drawAll(page);
    const marked = await page.evaluate(() => Object.entries(tautline.charts).map(([name, { body }]) => ({ name,
      marks: body._fullData.filter((one) => one.line?.dash === 'dot').map((one) => ({ time: one.x[0], meaning: one.name })) })));
    assert.deepEqual(marked, chapter.figures.map(({ name, x, marks }) => ({ name, marks: x.startsWith('t ') ? marks : [] })));
  });
});

test('no name in a legend leaves its plot on a narrow screen', async () => {
  await withPage(file, async ({ page }) => {
    await drawAll(page);
    const outside = await page.evaluate(() => [...document.querySelectorAll('.legendtext')].filter((text) => {
      const plot = text.closest('.chart').getBoundingClientRect();
      const own = text.getBoundingClientRect();
      return own.left < plot.left || own.right > plot.right || own.top < plot.top;
    }).map((text) => text.textContent));
    assert.deepEqual(outside, []);
  }, { width: 400 });
});

test('links lead to files that were written with the page', async () => {
  await withPage(file, async ({ page }) => {
    const links = await page.evaluate(() => [...document.querySelectorAll('a')].map((one) => one.getAttribute('href')));
    const files = links.filter((link) => !link.startsWith('#'));
    assert.equal(files.length, chapter.tables.length + chapter.figures.length);
    assert.deepEqual(files.filter((link) => !existsSync(join(dirname(file), link))), []);
    const ids = links.filter((link) => link.startsWith('#'));
    assert.ok(ids.length >= 5);
    for (const id of ids) {
      assert.equal(await page.locator(id).count(), 1, id);
    }
  });
});

test('without JavaScript every table is there with all its rows', async () => {
  await withPage(file, async ({ page }) => {
    for (const { name, rows } of chapter.tables) {
      const table = page.locator(`#${name.toLowerCase().replace(/[ .]/g, '-')}`);
      assert.ok(await table.isVisible(), name);
      assert.equal(await table.locator('tbody tr').count(), rows.length, name);
    }
    assert.equal(await page.locator('figcaption').count(), chapter.figures.length);
  }, { javaScriptEnabled: false });
});
