import assert from 'node:assert/strict';
import test from 'node:test';
import { benchPage, onSharedPage, withPage } from './browser.mjs';

/// The column `index` of the shown rows of the plain bodies of a table, from top to bottom.
const column = (page, id, index) => page.evaluate(([table, i]) => [...document.getElementById(table).tBodies]
  .filter((body) => body.className === '').flatMap((body) => [...body.rows]).filter((row) => !row.hidden)
  .map((row) => row.cells[i]).map((cell) => ({ text: cell.textContent, ...cell.dataset, plain: cell.className === 'n' }))
  .map(({ text, value, plain }) => (value === '' ? null : value !== undefined ? Number(value)
    : plain && Number.isFinite(Number(text)) ? Number(text) : text)), [id, index]);

/// The index of the column of a heading with this key.
const indexOf = (page, id, key) => page.evaluate(([table, wanted]) => {
  const [upper, lower = []] = [...document.getElementById(table).tHead.rows].map((row) => [...row.cells]);
  return upper.flatMap((cell) => (cell.scope === 'colgroup' ? lower.splice(0, cell.colSpan) : [cell]))
    .findIndex((cell) => cell.dataset.key === wanted);
}, [id, key]);

const numbers = (values) => values.filter((value) => typeof value === 'number');

/// Keys of the columns that hold different numbers.
async function sortable(page, id) {
  const keys = await page.evaluate((table) => [...document.getElementById(table).tHead.querySelectorAll('th[data-key]')]
    .map((cell) => cell.dataset.key), id);
  const found = [];
  for (const key of keys) {
    if (new Set(numbers(await column(page, id, await indexOf(page, id, key)))).size > 2) {
      found.push(key);
    }
  }
  return found;
}

for (const id of ['scorecards-table', 'answers-table', 'cases-table']) {
  test(`#${id} sorts by every column of numbers, up and down, by keyboard too`, () => onSharedPage(async ({ page }) => {
    await page.evaluate((table) => { const fold = document.getElementById(table).closest('details'); if (fold && !fold.open) { fold.querySelector('summary').click(); } }, id);
    const keys = await sortable(page, id);
    assert.ok(keys.length > (id === 'scorecards-table' ? 1 : 2), keys.join());
    for (const [place, key] of keys.entries()) {
      const index = await indexOf(page, id, key);
      const heading = page.locator(`#${id} th[data-key="${key}"]`);
      // a key once; the rest of a wide table in the page itself
      const press = (by) => (place === 0 ? by() : heading.locator('button').evaluate((button) => button.click()));
      await press(() => heading.locator('button').press('Enter'));
      assert.equal(await heading.getAttribute('aria-sort'), 'ascending');
      const up = numbers(await column(page, id, index));
      assert.deepEqual(up, [...up].sort((a, b) => a - b), key);
      await press(() => heading.locator('button').click());
      assert.equal(await heading.getAttribute('aria-sort'), 'descending');
      assert.deepEqual(numbers(await column(page, id, index)), [...up].reverse(), key);
    }
  }));
}

test('words filter the rows, and what is chosen stands in the address', async () => {
  await withPage(benchPage(), async ({ page }) => {
    const index = await indexOf(page, 'cases-table', 'model');
    await page.locator('section#cases input[name=text]').fill('event');
    const left = await column(page, 'cases-table', index);
    assert.ok(left.length > 0);
    await page.reload();
    assert.deepEqual(await column(page, 'cases-table', index), left);
  });
});

test('the exact control stays apart however the table is sorted, and below the engines', () => onSharedPage(async ({ page }) => {
  const [key] = await sortable(page, 'answers-table');
  await page.locator(`#answers-table th[data-key="${key}"] button`).evaluate((button) => button.click());
  const bodies = await page.evaluate(() => [...document.getElementById('answers-table').tBodies].map((body) => body.className));
  assert.ok(bodies.indexOf('control') > bodies.indexOf(''), bodies.join());
  const control = await page.locator('#answers-table tbody.control tr').allTextContents();
  assert.ok(control.length > 0);
  assert.ok(control.every((row) => row.includes('exact')), control.join('\n'));
}));
