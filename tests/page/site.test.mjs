// The site of the documentation (scripts/site), opened from disk.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { withPage } from './browser.mjs';

const site = process.env.TAUTLINE_SITE;
const axe = readFileSync(new URL('./node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
const leastTarget = 24; // [px]

/// One page of each kind: prose, tables in lists, wide tables, equations, a source.
const kinds = ['index.html', 'docs/index.html', 'docs/guides/cables.html', 'docs/results/engines.html', 'analytic/index.html',
  'analytic/loop/solve.cpp.html'];

for (const kind of kinds) {
  for (const [width, colorScheme] of [[400, 'dark'], [400, 'light'], [1280, 'dark'], [1280, 'light']]) {
    test(`${kind} at ${width} px, ${colorScheme}: fits, is accessible, and asks for nothing but its files`, async () => {
      await withPage(join(site, kind), async ({ page, said, asked }) => {
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width);
        await page.evaluate(axe);
        const found = await page.evaluate(() => axe.run({ preload: false }));
        assert.deepEqual(found.violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), []);
        const small = await page.evaluate((least) => [...document.querySelectorAll('header a, input, nav a, summary')]
          .filter((one) => one.checkVisibility() && one.getBoundingClientRect().height < least)
          .map((one) => one.textContent), leastTarget);
        assert.deepEqual(small, []);
        assert.deepEqual(said, []);
        assert.ok(asked.every((url) => url.startsWith('file:')), asked);
      }, { width, colorScheme });
    });
  }
}

test('the search finds a word on another page, and the keyboard leads there', async () => {
  await withPage(join(site, 'docs/guides/cables.html'), async ({ page }) => {
    await page.keyboard.press('/');
    await page.keyboard.type('predictability horizon');
    await page.waitForSelector('#found li');
    assert.match(await page.textContent('#found li'), /horizon/i);
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    await page.waitForURL(/exact-motion\.html#the-predictability-horizon$/);
    await page.keyboard.press('/');
    await page.keyboard.type('no such word anywhere');
    await page.waitForFunction(() => document.querySelector('#found p')?.textContent.startsWith('Nothing'));
    await page.keyboard.press('Escape');
    assert.equal(await page.isVisible('#found'), false);
  });
});

test('the first stop of the keyboard leads past the list of pages', async () => {
  await withPage(join(site, 'docs/reference/glossary.html'), async ({ page }) => {
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.className), 'skip');
    await page.keyboard.press('Enter');
    assert.equal(await page.evaluate(() => document.activeElement.id), 'main');
  });
});

test('paper has the text alone, and all of a wide block', async () => {
  await withPage(join(site, 'docs/guides/cables.html'), async ({ page }) => {
    await page.emulateMedia({ media: 'print' });
    assert.equal(await page.isVisible('nav.pages'), false);
    assert.equal(await page.isVisible('header'), false);
    assert.deepEqual(await page.evaluate(() => [...document.querySelectorAll('pre')]
      .filter((one) => one.scrollWidth > one.clientWidth + 1).length), 0);
  }, { width: 700 });
});

test('without scripts every page is there to read', async () => {
  await withPage(join(site, 'docs/index.html'), async ({ page }) => {
    assert.equal(await page.isVisible('nav.pages a'), true);
    assert.equal(await page.isVisible('input'), false);
  }, { javaScriptEnabled: false, width: 400 });
});
