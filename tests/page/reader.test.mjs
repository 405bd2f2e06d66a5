// What any reader needs: paper, a keyboard, a screen reader.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { benchPage, drawAll, drawnPages, onSharedPage, pages, withPage } from './browser.mjs';

const axe = readFileSync(new URL('./node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
/// Of paper, for a small report with every section open: 16.
const mostPages = 18;

/// Draws what is drawn by script, and opens every fold.
async function unfolded(page) {
  if (await page.evaluate(() => Boolean(window.tautline?.charts))) {
    await drawAll(page);
  }
  await page.evaluate(() => document.querySelectorAll('details').forEach((one) => { one.open = true; }));
}

for (const [file, colorScheme] of [...pages(), ...drawnPages()].flatMap((one) => [[one, 'light'], [one, 'dark']])) {
  test(`axe finds nothing in the ${colorScheme} scheme of ${file}`, async () => {
    await withPage(file, async ({ page }) => {
      await unfolded(page);
      await page.evaluate(axe);
      // what is in the charts is held to its contrast in legible.test.mjs
      const found = await page.evaluate(() => axe.run({ exclude: ['.js-plotly-plot'] },
        { resultTypes: ['violations'], rules: { 'target-size': { enabled: true } } }));
      assert.deepEqual(found.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 200)).join('\n')}`), []);
    }, { colorScheme });
  });
}

for (const file of [...pages(), ...drawnPages()]) {
  test(`${file}: the first tab leads past what repeats, and nothing to press is smaller than 24 px`, () => withPage(file, async ({ page }) => {
    await unfolded(page);
    await page.evaluate(() => { document.activeElement?.blur(); scrollTo(0, 0); });
    await page.keyboard.press('Tab');
    const skip = await page.evaluate(() => ({ text: document.activeElement.textContent, seen: document.activeElement.getBoundingClientRect().width }));
    assert.equal(skip.text, 'Skip to the content');
    assert.ok(skip.seen > 24);
    await page.keyboard.press('Enter');
    assert.equal(await page.evaluate(() => document.activeElement.tagName), 'MAIN');
    const small = await page.evaluate(() => [...document.querySelectorAll('button, select, input, summary, nav a, svg a')]
      .filter((one) => one.checkVisibility()).map((one) => [one, one.getBoundingClientRect()])
      .filter(([, { width, height }]) => width < 23.9 || height < 23.9)
      .map(([one, { width, height }]) => `${one.outerHTML.slice(0, 80)}: ${width} x ${height}`));
    assert.deepEqual(small, []);
  }));
}

test('on paper the page is light, with every chart whole, and short', async () => {
  await withPage(benchPage(), async ({ page, said }) => {
    const pdf = await page.pdf({ preferCSSPageSize: true });
    const pages = (pdf.toString('latin1').match(/\/Type\s*\/Page\b/g) ?? []).length;
    assert.ok(pages >= 3 && pages <= mostPages, `${pages} pages`);
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    const paper = await page.evaluate(() => ({ back: getComputedStyle(document.documentElement).backgroundColor,
      charts: Object.entries(tautline.charts).filter(([, one]) => !one.body.hidden && one.element.checkVisibility())
        .map(([id, { body }]) => ({ id, width: body.querySelector('.main-svg')?.getBoundingClientRect().width ?? 0,
          height: body.querySelector('.main-svg')?.getBoundingClientRect().height ?? 0,
          ink: body._fullLayout.font.color, points: body.querySelectorAll('.point').length })) }));
    // every fold is open, and the replay stands still
    const { closed, hidden, stills } = await page.evaluate(() => ({
      closed: [...document.querySelectorAll('main details')].filter((one) => !one.open).length,
      hidden: [...document.querySelectorAll('main section')].filter((one) => !one.checkVisibility()).map((one) => one.id),
      stills: [...document.querySelectorAll('.print-stills figure')].map((one) => ({ text: one.textContent,
        width: one.querySelector('img').getBoundingClientRect().width })) }));
    assert.deepEqual([closed, hidden], [0, []]);
    assert.equal(stills.length, 4);
    stills.forEach(({ text, width }, i) => assert.ok(width > 200 && text.startsWith(i === 0 ? 't = 0' : 't = '), text));
    assert.equal(paper.back, 'rgb(253, 252, 249)');
    assert.ok(paper.charts.length >= 5);
    for (const { id, width, height, ink, points } of paper.charts) {
      assert.ok(width > 300 && width <= 703, `${id}: ${width} px`); // A4 less its margins
      assert.ok(height < 1017, `${id}: ${height} px`);
      assert.equal(ink, '#1c1b19', id);
      assert.ok(points > 0, id);
    }
    assert.deepEqual(said, []);
  }, { colorScheme: 'dark' });
});

test('every control is reached by tab, and seen where it is', () => onSharedPage(async ({ page }) => {
  const expected = await page.evaluate(() => {
    document.activeElement?.blur();
    scrollTo(0, 0);
    const all = [...document.querySelectorAll('a[href], button, select, input, summary, [tabindex="0"]')]
      .filter((one) => one.checkVisibility() && !one.closest('dialog'));
    all.forEach((one, i) => { one.dataset.expected = i; });
    return all.length;
  });
  assert.ok(expected > 40);
  const reached = new Set();
  const unseen = [];
  await page.evaluate(() => { document.body.tabIndex = -1; document.body.focus(); });
  for (let i = 0; i < 2 * expected && reached.size < expected; ++i) { // rows that come into view have buttons of their own
    await page.keyboard.press('Tab');
    const { at, seen, html } = await page.evaluate(() => {
      const one = document.activeElement;
      const style = getComputedStyle(one);
      return { at: one.dataset.expected, seen: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0,
        html: one.outerHTML.slice(0, 120) };
    });
    if (at !== undefined) {
      reached.add(at);
      if (!seen) {
        unseen.push(html);
      }
    }
  }
  assert.deepEqual(unseen, []);
  const missed = await page.evaluate((found) => [...document.querySelectorAll('[data-expected]')]
    .filter((one) => !found.includes(one.dataset.expected)).map((one) => one.outerHTML.slice(0, 120)), [...reached]);
  assert.deepEqual(missed, []);
}));

test('a wide table scrolls by keyboard', async () => {
  await withPage(benchPage(), async ({ page }) => {
    const box = page.locator('.table-box:has(#answers-table)');
    await page.evaluate(() => { const fold = document.getElementById('answers-table').closest('details'); if (fold) { fold.open = true; } });
    await box.focus();
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction(() => document.querySelector('.table-box:has(#answers-table)').scrollLeft > 0);
  }, { width: 400 });
});
