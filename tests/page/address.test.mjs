import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { benchPage, drawAll, onSharedPage, settled, withPage } from './browser.mjs';

const chip = (page, name) => page.locator('.engine-filter button', { hasText: new RegExp(`^${name}$`) });
/// The engines in the shown rows of a table, of its plain bodies.
const enginesIn = (page, id) => page.evaluate((table) => [...new Set([...document.getElementById(table).tBodies]
  .filter((body) => body.className === '').flatMap((body) => [...body.rows]).filter((row) => !row.hidden)
  .map((row) => row.cells[table === 'cases-table' ? 2 : 0].firstChild.textContent))].sort(), id);
const tables = ['scorecards-table', 'answers-table', 'cases-table'];

test('one filter of engines holds for every table, stands in the address, and is there again on load and on back', async () => {
  await withPage(benchPage(), async ({ page }) => {
    for (const id of tables) {
      assert.deepEqual(await enginesIn(page, id), ['chipmunk', 'ode'], id);
    }
    await chip(page, 'ode').click();
    const linked = page.url();
    assert.match(linked, /engines=ode/);
    for (const id of tables) {
      assert.deepEqual(await enginesIn(page, id), ['ode'], id);
    }
    await page.reload();
    for (const id of tables) {
      assert.deepEqual(await enginesIn(page, id), ['ode'], `${id} after a reload`);
    }
    assert.equal(await chip(page, 'ode').getAttribute('aria-pressed'), 'true');
    // the contents keep the state; back leads to what was
    await page.locator('nav a', { hasText: 'Causes' }).click();
    assert.deepEqual(await enginesIn(page, 'cases-table'), ['ode']);
    await page.goBack();
    assert.equal(page.url(), linked);
    await chip(page, 'all').click();
    assert.deepEqual(await enginesIn(page, 'answers-table'), ['chipmunk', 'ode']);
  });
});

test('a row leads on to its replay, settings, causes and files, and to the command that repeats it', async () => {
  await withPage(benchPage(), async ({ page, said }) => {
    await drawAll(page);
    // by keyboard: what comes into view on the way there moves the fold, and a slow pointer misses it
    await page.locator('#cases-table-fold > summary').press('Enter');
    const row = page.locator('#cases-table tbody tr', { hasText: 'slide-joint' }).first();
    await row.scrollIntoViewIfNeeded(); // the buttons come with the table into view
    await row.locator('button.lead').press('Enter');
    const dialog = page.locator('dialog.lead-on');
    const [name, engine, model, step] = await row.evaluate((one) => [0, 2, 3, 4].map((i) =>
      one.cells[i].dataset.value ?? one.cells[i].firstChild.textContent));
    assert.equal(await dialog.locator('.command code').textContent(),
      `tautline run ${name} --engine ${engine} --model ${model} --step ${step}`);
    const files = await dialog.locator('a[target=_blank]').evaluateAll((links) => links.map((one) => one.getAttribute('href')));
    assert.equal(files.length, 4);
    assert.deepEqual(files.filter((file) => !existsSync(join(dirname(benchPage()), decodeURI(file)))), []);
    await dialog.locator('a', { hasText: 'replay' }).press('Enter');
    await page.locator('.replay-status:not(:empty)').waitFor();
    await settled(page);
    await page.locator('.replay-note li', { hasText: `${engine} ${model}, step ${step} s: drawn within` }).waitFor();
    assert.equal(await page.getByLabel('Run 1').inputValue(), `${engine} ${model} ${step}`);
    assert.equal(await page.locator('#replay-app select').first().inputValue(), name);
    await page.goBack();
    assert.ok(await row.isVisible(), 'a step back leads to the row');
    await row.locator('button.lead').press('Enter');
    await dialog.getByText('its settings').press('Enter');
    assert.ok(await page.locator(`[id="settings-of-${engine}"]`).isVisible());
    assert.deepEqual(said, []);
  });
});

test('the replay’s case, runs and instant are in the address, and a link shows them', async () => {
  await withPage(benchPage(), async ({ page }) => {
    await page.locator('#replay-app').scrollIntoViewIfNeeded();
    await page.locator('.replay-status:not(:empty)').waitFor();
    const cases = page.locator('#replay-app select').first();
    await cases.selectOption({ index: 1 });
    await page.getByLabel('Run 2').selectOption('');
    await page.focus('.replay-canvas + input');
    await page.keyboard.press('ArrowRight');
    await settled(page, 300);
    const seen = async () => [await cases.inputValue(), await page.getByLabel('Run 1').inputValue(),
      await page.getByLabel('Run 2').inputValue(), Number(await page.locator('#replay-app input[type=range]').inputValue()).toFixed(3)];
    const before = await seen();
    assert.ok(Number(before[3]) > 0);
    const linked = page.url();
    await page.reload();
    await page.locator('#replay-app').scrollIntoViewIfNeeded();
    await page.locator('.replay-status:not(:empty)').waitFor();
    await settled(page);
    assert.deepEqual(await seen(), before, linked);
  });
});

test('no table shows more than 40 rows without a fold that counts them', () => withPage(benchPage(), async ({ page }) => {
  const found = await page.evaluate(() => [...document.querySelectorAll('table')].map((table) => ({ id: table.id,
    rows: [...table.tBodies].flatMap((body) => [...body.rows]).filter((row) => !row.hidden).length,
    fold: table.closest('details'), said: table.closest('details')?.querySelector('summary').textContent ?? '' }))
    .map((one) => ({ ...one, fold: one.fold ? !one.fold.open : false })));
  assert.ok(found.some(({ rows }) => rows > 40), 'the tests need a long table');
  for (const { id, rows, fold, said } of found.filter((one) => one.rows > 40)) {
    assert.ok(fold, `${id} shows ${rows} rows`);
    assert.match(said, /\d+/);
  }
}));

test('where every case has units of its own, no number has metres, seconds or joules', () => onSharedPage(async ({ page }) => {
  assert.ok(await page.evaluate(() => tautline.ownUnits), 'the tests need such cases');
  const text = await page.evaluate(() => ['engines', 'trust', 'error', 'replay', 'answers', 'cases']
    .map((id) => [...document.getElementById(id).querySelectorAll('thead, .replay-status, .stills, text')]
      .map((one) => one.textContent).join('\n')).join('\n'));
  assert.deepEqual(text.match(/(\[(m|s|J|m\/s)\]|\d (m|s|J|m\/s)\b)/g) ?? [], []);
}));
