import assert from 'node:assert/strict';
import test from 'node:test';
import { benchPage, drawAll, withPage } from './browser.mjs';

/// Of every drawn chart: {id, axes: [{title, type}], traces}.
const drawn = () => Object.entries(tautline.charts).filter(([, one]) => !one.body.hidden).map(([id, { body }]) => ({ id,
  axes: Object.keys(body._fullLayout).filter((key) => /^[xy]axis\d*$/.test(key)).map((key) => ({
    title: body._fullLayout[key].title.text, type: body._fullLayout[key].type })),
  traces: body._fullData.map((one) => one.x.length).filter((length) => length > 0).length }));

test('every chart has curves, and on every axis a title with its unit', async () => {
  await withPage(benchPage(), async ({ page }) => {
    await drawAll(page);
    const charts = await page.evaluate(drawn);
    for (const id of ['chart-cost', 'chart-step', 'chart-replay', 'chart-restitution', 'chart-arm', 'chart-impulse']) {
      assert.ok(charts.some((chart) => chart.id === id), `${id} is not drawn`);
    }
    for (const { id, axes, traces } of charts) {
      assert.ok(traces > 0, `${id} is empty`);
      assert.ok(axes.length >= 2, id);
      for (const { title, type } of axes) {
        assert.match(title, type === 'category' ? /\w/ : /\w.* \[[^\]]+\]$/, `${id}: "${title}"`);
      }
    }
  });
});

test('engines and models differ by symbol or dash, not by colour alone', async () => {
  await withPage(benchPage(), async ({ page }) => {
    const marks = await page.evaluate(() => tautline.engines.flatMap((engine) => tautline.modelsOf(engine)
      .map((model) => tautline.mark(engine, model))).map(({ symbol, dash }) => `${symbol} ${dash}`));
    assert.ok(marks.length > 2);
    assert.equal(new Set(marks).size, marks.length, marks.join('\n'));
  });
});

test('the points of error against step are the numbers of the report', async () => {
  await withPage(benchPage(), async ({ page }) => {
    await drawAll(page);
    await page.locator('#error select').nth(2).selectOption({ index: 1 });
    const wrong = await page.evaluate(() => {
      const name = tautline.report.cases[0].name;
      const { body } = tautline.charts['chart-step'];
      const runs = tautline.report.runs.filter((run) => run.case === name && run.status === 'finished' && run.metrics);
      return runs.filter((run) => {
        const trace = body._fullData.find((one) => one.name === `${run.engine} ${run.model}`);
        const at = [...trace.x].indexOf(run.step);
        const error = run.metrics.early_position_error;
        // rounding, up to 1e-9 m, is drawn at the foot
        return error > 1e-9 ? trace.y[at] !== error : trace.y[at] > Math.min(...trace.y);
      }).map((run) => `${run.engine} ${run.model} ${run.step}`);
    });
    assert.deepEqual(wrong, []);
  });
});

test('the points of error against cost over all cases are the medians of the report', async () => {
  await withPage(benchPage(), async ({ page }) => {
    await drawAll(page);
    const { wrong, compared } = await page.evaluate(() => {
      const { report } = tautline;
      const { body } = tautline.charts['chart-cost'];
      const rows = report.summary.filter((row) => row.metrics.early_position_error?.median > 1e-9); // the rest is at the foot
      return { compared: rows.length, wrong: rows.filter((row) => {
        const same = (one) => one.engine === row.engine && one.model === row.model && one.step === row.step;
        const trace = body._fullData.find((one) => one.name === `${row.engine} ${row.model}`);
        const at = [...trace.x].indexOf(report.context.costs.find(same).second_cost);
        return trace.y[at] !== row.metrics.early_position_error.median;
      }).map((row) => `${row.engine} ${row.model} ${row.step}`) };
    });
    assert.ok(compared > 2);
    assert.deepEqual(wrong, []);
  });
});

test('a button of the legend takes its model off the chart and puts it back', async () => {
  await withPage(benchPage(), async ({ page }) => {
    await drawAll(page);
    const button = page.locator('#chart-step + .legend button[aria-pressed]').last();
    const shown = () => page.evaluate(() => tautline.charts['chart-step'].body._fullData.filter((one) => one.visible === true).length);
    const before = await shown();
    await button.press('Enter');
    assert.equal(await button.getAttribute('aria-pressed'), 'false');
    assert.equal(await shown(), before - 1);
    await button.press(' ');
    assert.equal(await shown(), before);
  });
});

test('charts take the colours of the scheme when it changes', async () => {
  await withPage(benchPage(), async ({ page }) => {
    await drawAll(page);
    const ink = () => page.evaluate(() => tautline.charts['chart-step'].body._fullLayout.font.color);
    const light = await ink();
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.waitForFunction((before) => tautline.charts['chart-step'].body._fullLayout.font.color !== before, light);
    assert.equal(await ink(), await page.evaluate(() => tautline.theme().ink));
  });
});
