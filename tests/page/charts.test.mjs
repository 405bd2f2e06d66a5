import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { benchPage, drawAll, onSharedPage, settled, withPage, withText } from './browser.mjs';
import { withReport } from './page.mjs';
import { modelNames, synthetic } from './synthetic.mjs';

/// Puts the page into the state of an address, as a link does.
async function go(page, hash) {
  await page.evaluate((text) => { location.hash = text; }, hash);
  await settled(page);
}

/// Of every drawn chart: {id, axes: [{letter, title, type, matches}], traces}.
const drawn = () => Object.entries(tautline.charts).filter(([, one]) => !one.body.hidden).map(([id, { body }]) => ({ id,
  axes: Object.keys(body._fullLayout).filter((key) => /^[xy]axis\d*$/.test(key)).map((key) => ({ letter: key[0],
    title: body._fullLayout[key].title.text, type: body._fullLayout[key].type, shown: body._fullLayout[key].showticklabels })),
  traces: body._fullData.map((one) => one.x.length).filter((length) => length > 0).length }));

test('every chart has curves, and every axis with numbers has a title with its unit', () => onSharedPage(async ({ page }) => {
  const charts = await page.evaluate(drawn);
  for (const id of ['chart-cost', 'chart-step', 'chart-replay', 'chart-restitution', 'chart-arm', 'chart-impulse']) {
    assert.ok(charts.some((chart) => chart.id === id), `${id} is not drawn`);
  }
  for (const { id, axes, traces } of charts) {
    assert.ok(traces > 0, `${id} is empty`);
    for (const letter of ['x', 'y']) {
      assert.ok(axes.some((axis) => axis.letter === letter && axis.shown), `${id} ${letter}`);
    }
    for (const { title, type, shown } of axes.filter((axis) => axis.shown)) {
      assert.match(title, type === 'category' ? /\w/ : /\w.* \[[^\]]+\]$/, `${id}: "${title}", ${shown}`);
    }
  }
}));

test('no two models of all engines share a marker', async () => {
  const report = synthetic({ cases: ['one'], steps: [1e-2], duration: 1 });
  await withText(withReport(readFileSync(benchPage(), 'utf8'), report), async ({ page }) => {
    const symbols = await page.evaluate(() => tautline.engines.flatMap((engine) => tautline.modelsOf(engine)
      .map((model) => tautline.mark(engine, model).symbol)));
    assert.equal(symbols.length, Object.values(modelNames).flat().length);
    assert.ok(symbols.length >= 48);
    assert.equal(new Set(symbols).size, symbols.length, symbols.sort().join('\n'));
  });
});

test('the ladder of bounces has e^(2n) at n, and no more decades than have a label', async () => {
  const report = synthetic({ cases: ['one'], engines: ['ode'], steps: [1e-2], duration: 1 });
  for (const { audit } of report.runs.filter((run) => run.audit.ladder)) {
    audit.ladder.exact = Array.from({ length: 120 }, (_, i) => 0.25 ** (i + 1));
    audit.ladder.heights = [0.24, 0.06, 1e-40, 0];
  }
  await withText(withReport(readFileSync(benchPage(), 'utf8'), report), async ({ page }) => {
    await drawAll(page);
    const { x, y, labels } = await page.evaluate(() => {
      const { body } = tautline.charts['chart-ladder'];
      const { x: n, y: height } = body._fullData.find((one) => one.name === 'e^(2n)');
      return { x: [...n], y: [...height], labels: body.querySelectorAll('.ytick text').length };
    });
    assert.ok(x.length > 5);
    x.forEach((n, i) => assert.equal(y[i], 0.25 ** n));
    assert.ok(labels >= 3 && labels <= 9, `${labels} labels`);
  });
});

/// The points of a chart's own curves (not of the grey ones): {name, step?, x, y}.
const own = (id) => tautline.charts[id].body._fullData.filter((one) => / /.test(one.name) && one.hoverinfo !== 'skip'
  && one.visible === true).map((one) => ({ name: one.name, x: [...one.x], y: [...one.y], text: [...one.text],
  spread: one.error_x?.array ? { up: [...one.error_x.array], down: [...one.error_x.arrayminus] } : null,
  ringed: [...one.marker.size].map((size) => size > 8) }));

test('the points of error against step are the numbers of the report', () => onSharedPage(async ({ page }) => {
  const name = await page.evaluate(() => tautline.report.cases[0].name);
  await go(page, `#error?case=${name}`);
  const { runs, curves } = await page.evaluate(([the, read]) => ({ curves: eval(read)('chart-step'),
    runs: tautline.report.runs.filter((run) => run.case === the && run.status === 'finished' && run.metrics && run.engine !== 'exact') }),
  [name, `(${own})`]);
  assert.ok(runs.length > 10);
  for (const run of runs) {
    const curve = curves.find((one) => one.name === `${run.engine} ${run.model}`);
    const at = curve.x.indexOf(run.step);
    const error = run.metrics.early_position_error;
    // rounding, up to 1e-9 m, is drawn at the foot
    assert.ok(error > 1e-9 ? curve.y[at] === error : curve.y[at] <= Math.min(...curves.flatMap((one) => one.y)), curve.name);
  }
}));

test('the points of error against cost over all cases are the medians of the report, their bars the quartiles', () => onSharedPage(async ({ page }) => {
  const { report, curves } = await page.evaluate((read) => ({ curves: eval(read)('chart-cost'), report: {
    summary: tautline.report.summary, costs: tautline.report.context.costs } }), `(${own})`);
  // the rest is at the foot; the control has no curve
  const rows = report.summary.filter((row) => row.engine !== 'exact' && row.metrics.early_position_error?.median > 1e-9);
  assert.ok(rows.length > 2);
  for (const row of rows) {
    const same = (one) => one.engine === row.engine && one.model === row.model && one.step === row.step;
    const curve = curves.find((one) => one.name === `${row.engine} ${row.model}`);
    const { second_cost: cost, second_spread: spread } = report.costs.find(same);
    const at = curve.x.indexOf(cost);
    assert.equal(curve.y[at], row.metrics.early_position_error.median, curve.name);
    assert.ok(Math.abs(curve.spread.up[at] - (spread.upper - cost)) < 1e-12 && spread.upper >= cost, curve.name);
    assert.ok(Math.abs(curve.spread.down[at] - (cost - spread.lower)) < 1e-12 && spread.lower <= cost, curve.name);
  }
}));

test('of one case the points are the medians of its repetitions, their bars the quartiles', () => onSharedPage(async ({ page }) => {
  const name = await page.evaluate(() => tautline.report.cases[0].name);
  await go(page, `#error?case=${name}`);
  const { runs, curves } = await page.evaluate(([the, read]) => ({ curves: eval(read)('chart-cost'),
    runs: tautline.report.runs.filter((run) => run.case === the && run.metrics && run.engine !== 'exact') }), [name, `(${own})`]);
  assert.ok(runs.length > 10);
  for (const run of runs) {
    const curve = curves.find((one) => one.name === `${run.engine} ${run.model}`);
    const [cost, lower, upper] = run.cost;
    const at = curve.x.indexOf(cost);
    assert.ok(at >= 0 && lower <= cost && cost <= upper, `${curve.name}: ${run.cost}`);
    assert.deepEqual([curve.spread.up[at], curve.spread.down[at]], [upper - cost, cost - lower], curve.name);
  }
}));

test('a ring marks exactly the points that no other is both cheaper and more accurate than', () => onSharedPage(async ({ page }) => {
  const curves = await page.evaluate((read) => eval(read)('chart-cost'), `(${own})`);
  const points = curves.flatMap((curve) => curve.x.map((x, i) => ({ x, y: curve.y[i], ringed: curve.ringed[i], name: curve.name })));
  assert.ok(points.filter((point) => point.ringed).length > 0);
  for (const point of points) {
    const beaten = points.some((other) => other.x <= point.x && other.y <= point.y && (other.x < point.x || other.y < point.y));
    assert.equal(point.ringed, !beaten, `${point.name} ${point.x} ${point.y}`);
  }
}));

test('what is drawn at the foot stands on a tick that says so', () => onSharedPage(async ({ page }) => {
  for (const id of ['chart-cost', 'chart-step']) {
    const { ticks, texts, foot, rounding } = await page.evaluate(([chart, read]) => {
      const axis = tautline.charts[chart].body._fullLayout.yaxis;
      return { ticks: axis.tickvals, texts: axis.ticktext, foot: Math.min(...eval(read)(chart).flatMap((one) => one.y)),
        rounding: tautline.report.summary.some((row) => row.metrics.early_position_error?.median <= 1e-9 && row.engine !== 'exact') };
    }, [id, `(${own})`]);
    assert.ok(rounding, 'the tests need a model at rounding');
    assert.ok(Math.abs(ticks[0] / foot - 1) < 1e-9, `${ticks[0]} and ${foot}`);
    assert.match(texts[0], /^≤ 10<sup>−9<\/sup>$/);
    // the other ticks are where their texts say
    texts.slice(1).forEach((text, i) => assert.equal(text, `10<sup>${String(Math.round(Math.log10(ticks[i + 1]))).replace('-', '−')}</sup>`));
  }
}));

test('a panel stands for each engine shown, and panels and legends follow the one filter', () => onSharedPage(async ({ page }) => {
  const panels = () => page.evaluate(() => tautline.charts['chart-cost'].body._fullLayout.annotations.map((one) => one.text.replace(/<[^>]*>/g, '')));
  const legends = (id) => page.locator(`#${id} + .legend .key.engine`).allTextContents();
  await go(page, '#error?engines=');
  assert.deepEqual(await panels(), ['chipmunk', 'ode']);
  await page.locator('.engine-filter button', { hasText: /^ode$/ }).press('Enter');
  await settled(page);
  assert.deepEqual(await panels(), ['ode']);
  for (const id of ['chart-cost', 'chart-step']) {
    assert.deepEqual(await legends(id), ['ode'], id);
  }
  const grey = await page.evaluate(() => tautline.charts['chart-cost'].body._fullData[0]);
  assert.equal(grey.name, 'the other engines');
  assert.ok(grey.x.length > 0);
}));

test('a button of a legend takes its model off every chart, is struck in both, and puts it back', () => onSharedPage(async ({ page }) => {
  const shown = (id) => page.evaluate(([chart, read]) => eval(read)(chart).length, [id, `(${own})`]);
  const button = (id) => page.locator(`#${id} + .legend button[aria-pressed]`).last();
  const before = [await shown('chart-cost'), await shown('chart-step')];
  await button('chart-step').press('Enter');
  await settled(page);
  for (const id of ['chart-cost', 'chart-step']) {
    assert.equal(await button(id).getAttribute('aria-pressed'), 'false', id);
    assert.match(await button(id).evaluate((one) => getComputedStyle(one).textDecorationLine), /line-through/);
  }
  assert.deepEqual([await shown('chart-cost'), await shown('chart-step')], before.map((count) => count - 1));
  await button('chart-step').press(' ');
  await settled(page);
  assert.deepEqual([await shown('chart-cost'), await shown('chart-step')], before);
}));

test('tooltips name the metric as its list does, and say what it means', () => onSharedPage(async ({ page }) => {
  const { curves, meanings } = await page.evaluate((read) => ({ curves: eval(read)('chart-cost'),
    meanings: Object.fromEntries(tautline.report.metrics.map((one) => [one.name, one.meaning])) }), `(${own})`);
  const text = curves[0].text[0].replace(/<br>/g, ' ');
  assert.match(text, /early position error: /);
  assert.ok(text.includes(meanings.early_position_error), text);
}));

test('every chart of the audit has a legend with what is drawn in it', () => onSharedPage(async ({ page }) => {
  for (const id of ['chart-restitution', 'chart-arm', 'chart-impulse']) {
    const [names, entries] = await page.evaluate((chart) => {
      const { body } = tautline.charts[chart];
      return [[...new Set(body._fullData.map((one) => one.name))].sort(),
        [...body.querySelectorAll('.legendtext')].map((one) => one.textContent).sort()];
    }, id);
    assert.ok(names.length > 1, id);
    assert.deepEqual(entries, names, id);
  }
}));

test('the bar of buttons covers no curve, and is not there on a narrow screen', async () => {
  const overlap = () => Object.values(tautline.charts).filter((one) => !one.body.hidden).map(({ body }) => {
    const bar = body.querySelector('.modebar-container .modebar');
    return bar && bar.children.length ? bar.getBoundingClientRect().bottom - body.getBoundingClientRect().top - body._fullLayout._size.t : null;
  });
  await onSharedPage(async ({ page }) => {
    const found = await page.evaluate(overlap);
    assert.ok(found.some((one) => one !== null));
    assert.deepEqual(found.filter((one) => one > 0), []);
  });
  await withPage(benchPage(), async ({ page }) => {
    await drawAll(page);
    assert.deepEqual((await page.evaluate(overlap)).filter((one) => one !== null), []);
  }, { width: 400 });
});

test('charts take the colours of the scheme when it changes', () => onSharedPage(async ({ page }) => {
  const ink = () => page.evaluate(() => tautline.charts['chart-step'].body._fullLayout.font.color);
  const light = await ink();
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.waitForFunction((before) => tautline.charts['chart-step'].body._fullLayout.font.color !== before, light);
  assert.equal(await ink(), await page.evaluate(() => tautline.theme().ink));
  await page.emulateMedia({ colorScheme: 'light' });
}));
