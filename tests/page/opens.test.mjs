import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import test from 'node:test';
import { benchPage, drawAll, onSharedPage, withPage } from './browser.mjs';

test('the page opens from disk, says nothing on the console and asks for nothing but itself', async () => {
  await withPage(benchPage(), async ({ page, said, asked }) => {
    await drawAll(page);
    assert.deepEqual(said, []);
    const own = pathToFileURL(benchPage()).href;
    const motions = own.replace(/index\.html$/, 'motions/');  // of the replay, beside the page
    assert.deepEqual(asked.filter((url) => !/^(data|blob):/.test(url) && !url.startsWith(motions)), [own]);
  });
});

test('no address of a network is in the page but names of XML namespaces and the text of the report', () => {
  const text = readFileSync(benchPage(), 'utf8').replace(/<script type="application\/json"[^<]*/, '');
  const addresses = text.match(/(https?|wss?|ftp):\/\/[\w./-]+/g) || [];
  assert.deepEqual(addresses.filter((one) => !/^http:\/\/www\.w3\.org\//.test(one)), []);
});

test('a script of another origin and a request are forbidden by the page itself', () => withPage(benchPage(), async ({ page }) => {
  const outcome = await page.evaluate(() => fetch('data:text/plain,x').then(() => 'allowed', () => 'refused'));
  assert.equal(outcome, 'refused');
}));

test('without JavaScript every table is there with all its rows', async () => {
  const count = ({ page }) => page.locator('tbody tr').count();
  const scripted = await onSharedPage(count);
  await withPage(benchPage(), async ({ page }) => {
    assert.equal(await count({ page }), scripted);
    for (const id of ['scorecards-table', 'answers-table', 'cases-table']) {
      const table = page.locator(`table#${id}`);
      const fold = page.locator(`details:has(> * #${id}) > summary`);
      if (await fold.count() > 0) {
        await fold.click();
      }
      assert.ok(await table.isVisible(), id);
      assert.ok(await table.locator('tbody tr').count() > 0, id);
    }
  }, { javaScriptEnabled: false });
});

test('the picture at the top is of the run that its caption names, with the numbers of its impact', () => onSharedPage(async ({ page }) => {
  // slack, taut, slack: only at the impact is the cable straight
  assert.deepEqual(await page.locator('.stills svg').evaluateAll((stills) => stills.map((one) =>
    [one.querySelectorAll('.taut').length, one.querySelectorAll('.struck.taut').length])), [[0, 0], [1, 1], [0, 0]]);
  const { runs, caption } = await page.evaluate(() => ({ runs: tautline.report.runs,
    caption: document.querySelector('.stills figcaption').textContent }));
  const [, name, engine, model, time] = /Case (\S+) in (\S+) (\S+), impact at t = ([\d.]+)/.exec(caption);
  const run = runs.find((one) => one.case === name && one.engine === engine && one.model === model);
  const at = run.impacts.time.findIndex((one) => Math.abs(one - Number(time)) < 6e-4);
  assert.ok(at >= 0, caption);
  const [, before, after] = /closes at ([\d.e-]*\d) and opens at ([\d.e-]*\d)/.exec(caption);
  // shown to three digits, and the page has six
  assert.ok(Math.abs(Number(before) + run.impacts.rate_before[at]) < 6e-3 * before, caption);
  assert.ok(Math.abs(Number(after) - run.impacts.rate_after[at]) < 6e-3 * after, caption);
  assert.ok(caption.includes(`asked: ${Number(run.impacts.requested[at].toPrecision(4))}`), caption);
}));
