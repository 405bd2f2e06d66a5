import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { benchPage, drawAll, onSharedPage, reportOf, settled, withPage, withText } from './browser.mjs';
import { withReport } from './page.mjs';

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

/// What the first screen says of the engines: {engine, look, fault, advice, bars: [[name, value, look]], head}.
const firstScreen = (page) => page.evaluate(() => [...document.querySelectorAll('ul.engines > li')].filter((one) => !one.hidden)
  .map((one) => ({ engine: one.dataset.engine, model: one.dataset.model, look: one.querySelector('b').className,
    fault: one.querySelector('.fault').textContent, advice: one.querySelector('.advice').textContent,
    head: one.querySelector('.bars .head').textContent, bars: [...one.querySelectorAll('.bars .bar')].map((bar) =>
      [bar.previousSibling.textContent, parseFloat(bar.nextSibling.textContent), bar.className.replace('bar ', '')]) })));

test('each engine of the first screen has bars of the restitution asked and got, with the numbers of the report', () => onSharedPage(async ({ page }) => {
  const shown = await firstScreen(page);
  assert.deepEqual(shown.map((one) => one.engine).sort(), ['chipmunk', 'ode']);
  const runs = await page.evaluate(() => tautline.report.runs.filter((run) => run.e));
  for (const { engine, model, head, bars } of shown) {
    const [, name, step] = /^Restitution in (\S+), median, step (\S+) s$/.exec(head);
    assert.ok(bars.length >= 2, engine);
    assert.deepEqual([bars[0][0], bars[1][0]], ['asked', model]);
    for (const [of, value, look] of bars.slice(1)) {
      const { e } = runs.find((run) => run.engine === engine && run.model === of && run.case === name && String(run.step) === step);
      assert.equal(bars[0][1], Number(e[1].toFixed(2)));
      assert.equal(value, Number(e[2].toFixed(2)));
      assert.equal(look, ['sound', 'problem', 'too-few-to-tell', 'problem', 'problem'][e[0]]);
    }
  }
}));

/// `page` with these numbers instead of its own: of its runs [case, engine, model, asked, word, got], and of its models.
function withBars(page, rows, models) {
  const report = reportOf(page);
  const [one] = report.cases;
  const restitution = (asked) => one.geometry.map((cable) => ({ ...cable, restitution: asked }));
  const asked = new Map(rows.map((row) => [row[0], row[3]]));
  return withReport(readFileSync(page, 'utf8'), { ...report, models,
    cases: [...report.cases, ...[...asked].map(([name, e]) => ({ ...one, name, geometry: restitution(e) }))],
    runs: rows.map(([name, engine, model, , word, got]) => ({ ...report.runs[0], case: name, engine, model, step: 0.001, e: [word, got] })) });
}

test('the bars are of a case that is off like the sentence, or of one that asks for a rebound, and are rounded once', async () => {
  const { chipmunk, ode } = Object.fromEntries(await onSharedPage(async ({ page }) => (await firstScreen(page)).map(({ engine, model }) => [engine, model])));
  const text = withBars(benchPage(), [['keeps', 'chipmunk', chipmunk, 0, 0, 0.4], ['far', 'chipmunk', chipmunk, 0.5, 1, 0.9],
    ['near', 'chipmunk', chipmunk, 0, 1, 0.1455], ['lost', 'chipmunk', chipmunk, 0.9, 3, 1.045],
    ['falls', 'ode', ode, 0, 0, 0], ['less', 'ode', ode, 0.3, 0, 0.3], ['more', 'ode', ode, 0.7, 0, 0.7], ['few', 'ode', ode, 0.8, 2, 0.8]],
  [{ engine: 'chipmunk', model: chipmunk, e: [1, 0.15] }, { engine: 'ode', model: ode, e: [0, 0] }]);
  await withText(text, async ({ page }) => {
    const shown = Object.fromEntries((await firstScreen(page)).map(({ engine, head, bars }) => [engine, [head.split(/[ ,]/)[2], bars]]));
    assert.deepEqual(shown, { chipmunk: ['near', [['asked', 0, 'asked'], [chipmunk, 0.15, 'problem']]],
      ode: ['more', [['asked', 0.7, 'asked'], [ode, 0.7, 'sound']]] });
  });
});

test('model, case and step reach the sentences, the bars, the slopes and the causes; what is of all says so', () => onSharedPage(async ({ page }) => {
  const before = await firstScreen(page);
  const name = await page.evaluate(() => tautline.report.cases[1].name);
  await page.evaluate((hash) => { location.hash = hash; }, `#engines?case=${name}&model=slide-joint&step=0.003&engines=chipmunk`);
  await settled(page);
  const [one, ...others] = await firstScreen(page);
  assert.deepEqual([one.engine, others.length], ['chipmunk', 0]);
  assert.match(one.head, new RegExp(`^Restitution in ${name}, median, step 0.003 s$|^No case`));
  assert.match(one.fault, /^slide-joint: .* 1 of 1 run has a problem\.$/);
  assert.equal(one.advice, `Of all cases and steps: ${before.find(({ engine }) => engine === 'chipmunk').advice}`);
  const rows = (id) => page.evaluate((table) => [...document.getElementById(table).tBodies].filter((body) => body.className === '')
    .flatMap((body) => [...body.rows]).filter((row) => !row.hidden).map((row) => [...row.cells].slice(0, 3)
      .map((cell) => cell.dataset.value ?? cell.firstChild.textContent)), id);
  assert.deepEqual((await rows('slopes-table')).map((row) => row.slice(0, 2)), [['chipmunk', 'slide-joint']]);
  assert.deepEqual(await rows('attribution-table'), [['chipmunk', 'slide-joint', '0.003']]);
  assert.equal((await rows('scorecards-table')).length, 1);
  assert.deepEqual(await rows('steps-table').then((found) => found.map(([first]) => first)), [name]);
  const notes = await page.evaluate(() => [...document.querySelectorAll('.of-all')].filter((note) => !note.hidden).map((note) => note.textContent));
  assert.ok(notes.includes('This table is of all cases and steps, whichever case and step you chose.'), notes.join('\n'));
  await page.locator('.page-filter > button').click();
  await settled(page);
  assert.deepEqual(await firstScreen(page), before);
}));

test('the replay opens on the pair of the picture', () => withPage(benchPage(), async ({ page }) => {
  const hero = await page.evaluate(() => ({ ...document.querySelector('.stills').dataset }));
  assert.ok(hero.case, 'the tests need an error that is seen');
  await page.locator('.stills a').click();
  await page.locator('.replay-status:not(:empty)').waitFor();
  await settled(page);
  assert.equal(await page.locator('#replay-app select').first().inputValue(), hero.case);
  assert.equal(await page.getByLabel('Run 1').inputValue(), `${hero.engine} ${hero.model} ${hero.step}`);
  assert.equal(await page.getByLabel('Run 2').inputValue(), '');
}));

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
