import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { benchPage, drawAll, withPage, withText } from './browser.mjs';
import { withReport } from './page.mjs';
import { synthetic } from './synthetic.mjs';

const names = ['<script>alert(1)</script><b id="injected">', '"><img src=x onerror=alert(2) id="injected">',
  '</script><script>alert(3)</script>', '<!--<script>', "';alert(4);//", '\u2028\u2029\u202e&amp;&lt;', 'x'.repeat(10000)];

async function isHarmless({ page, dialogs, said }) {
  await drawAll(page);
  // every select that offers the names takes each of them, and points at a mark for its text
  for (const box of await page.locator('#chart-cost select, #error .controls:first-of-type select, #audit-app select, #replay-app select:visible').all()) {
    const count = await box.locator('option').count();
    for (let index = 0; index < Math.min(count, names.length + 1); ++index) {
      await box.selectOption({ index });
    }
    await box.selectOption({ index: 0 });
  }
  const chart = page.locator('#chart-restitution');
  if (await chart.locator('.point').count() > 0) {
    await chart.scrollIntoViewIfNeeded();
    await chart.locator('.point').first().hover({ force: true });
    await page.waitForTimeout(100);
  }
  assert.deepEqual(dialogs, []);
  assert.deepEqual(said, []);
  assert.equal(await page.locator('#injected, img[src=x]').count(), 0);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
}

test('hostile names of cases do nothing in the charts, the audit and the replay', async () => {
  const report = synthetic({ cases: names, engines: ['exact', 'ode'], steps: [1e-2], duration: 3 });
  await withText(withReport(readFileSync(benchPage(), 'utf8'), report), isHarmless);
});

test('a page that the program wrote of a case with a hostile name is harmless', async () => {
  assert.ok(process.env.TAUTLINE_HOSTILE_PAGE, 'set TAUTLINE_HOSTILE_PAGE to the page of a hostile case');
  await withPage(process.env.TAUTLINE_HOSTILE_PAGE, async (opened) => {
    const name = await opened.page.evaluate(() => tautline.report.cases[0].name);
    assert.match(name, /<script>|onerror/);
    await isHarmless(opened);
  });
});
