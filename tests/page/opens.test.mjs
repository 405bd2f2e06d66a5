import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import test from 'node:test';
import { benchPage, drawAll, withPage } from './browser.mjs';

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

test('a script of another origin and a request are forbidden by the page itself', async () => {
  await withPage(benchPage(), async ({ page }) => {
    const outcome = await page.evaluate(() => fetch('data:text/plain,x').then(() => 'allowed', () => 'refused'));
    assert.equal(outcome, 'refused');
  });
});

test('without JavaScript every table is there with all its rows', async () => {
  const count = ({ page }) => page.locator('tbody tr').count();
  const scripted = await withPage(benchPage(), count);
  await withPage(benchPage(), async ({ page }) => {
    assert.equal(await count({ page }), scripted);
    for (const id of ['answers-table', 'cases-table']) {
      const table = page.locator(`table#${id}`);
      assert.ok(await table.isVisible(), id);
      assert.ok(await table.locator('tbody tr').count() > 0, id);
    }
  }, { javaScriptEnabled: false });
});
