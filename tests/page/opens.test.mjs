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

test('the picture at the top has the largest error of a rebound, beside the exact motion from the same start', () => onSharedPage(async ({ page }) => {
  // before the impact and at it the two are one; after it they have parted
  const apart = await page.locator('.stills svg').evaluateAll((stills) => stills.map((one) => {
    const [exact, engine] = ['.is-exact circle', '.is-engine circle'].map((name) => one.querySelector(name).getBoundingClientRect());
    return Math.hypot(exact.x + exact.width / 2 - engine.x - engine.width / 2, exact.y + exact.height / 2 - engine.y - engine.height / 2);
  }));
  assert.ok(apart[0] < 4 && apart[1] < 4 && apart[2] > 6, apart.join());
  const { hero, runs, caption } = await page.evaluate(() => ({ hero: { ...document.querySelector('.stills').dataset }, runs: tautline.report.runs,
    caption: document.querySelector('.stills figcaption').textContent }));
  const run = runs.find((one) => one.case === hero.case && one.engine === hero.engine && one.model === hero.model && String(one.step) === hero.step);
  assert.ok(caption.includes(`${hero.engine} ${hero.model}`) && caption.includes(hero.case), caption);
  const [, asked, got] = /asked: ([\d.e-]*\d); got: ([\d.e-]*\d)/.exec(caption);
  assert.ok(run.impacts.time.some((_, i) => Math.abs(run.impacts.requested[i] - asked) < 0.006
    && Math.abs(run.impacts.rate_after[i] / -run.impacts.rate_before[i] - got) < 0.006), caption);
}));
