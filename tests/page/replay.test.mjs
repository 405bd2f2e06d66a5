import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { readState, spellState } from '../../bench/playground/case.mjs';
import { benchPage, drawAll, reportOf, withPage } from './browser.mjs';
import { replay, settled } from './replay.mjs';

/// No run over the exact path.
async function exactAlone(page) {
  for (let i = 1; i <= 3; ++i) {
    await page.getByLabel(`Run ${i}`).selectOption('');
  }
}

const pixels = (page) => page.evaluate(() => document.querySelector('.replay-canvas').toDataURL());
const exactEvents = (page) => page.evaluate(() => tautline.report.cases[0].events.time);

test('play moves the body, pause stops it', () => replay(async ({ page, time }) => {
  const start = await pixels(page);
  await page.click('#replay-play');
  await page.waitForFunction(() => document.querySelector('#replay-app input[type=range]').value > 0.2);
  assert.notEqual(await pixels(page), start);
  await page.click('#replay-play');
  const stopped = await time();
  await page.waitForTimeout(200);
  assert.equal(await time(), stopped);
}));

test('dragging the slider shows that instant, and the cursor of the plots follows', () => replay(async ({ page, slider }) => {
  await page.locator('#chart-replay').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => tautline.charts['chart-replay'].body._fullLayout);
  const place = () => page.evaluate(() => document.querySelector('.time-cursor').getBoundingClientRect().x);
  const [start, before] = [await place(), await pixels(page)];
  await slider.evaluate((one) => one.scrollIntoView({ block: 'center' })); // clear of the contents above
  const box = await slider.boundingBox();
  await page.mouse.click(box.x + 0.3 * box.width, box.y + 0.5 * box.height);
  assert.notEqual(await pixels(page), before);
  const [moved, time] = [await place() - start, Number(await slider.inputValue())];
  const expected = await page.evaluate((at) => {
    const { xaxis } = tautline.charts['chart-replay'].body._fullLayout;
    return xaxis.l2p(at) - xaxis.l2p(0);
  }, time);
  assert.ok(Math.abs(moved - expected) < 1.5, `${moved} and ${expected} px`);
}));

test('a link leads to the case in the live page, with every bit of it', () => replay(async ({ page }) => {
  const shipped = JSON.parse(readFileSync(new URL('../../languages/python/src/tautline/cases.json', import.meta.url), 'utf8'));
  for (const { name } of reportOf(benchPage()).cases) {
    await page.evaluate((one) => tautline.replay.chooseCase(one), name);
    const [where, address] = (await page.locator('.replay-live').getAttribute('href')).split('#');
    assert.equal(where, '../live.html');
    const { state, problem } = readState(address, shipped);
    assert.equal(problem, undefined);
    assert.equal(spellState(state, shipped), `case=${name}`);
  }
}));

test('stepping by event goes through the events of the exact path, forth and back', () => replay(async ({ page, time }) => {
  await exactAlone(page);
  const events = (await exactEvents(page)).filter((at, i, all) => at > 1e-6 && (i === 0 || at - all[i - 1] > 1e-6));
  assert.ok(events.length > 2);
  for (const expected of events.slice(0, 3)) {
    await page.click('#replay-next');
    assert.equal(await time(), expected);
    assert.match(await page.locator('.replay-status').textContent(), /exact path: (impact|taut|slack)/);
  }
  await page.click('#replay-before');
  assert.equal(await time(), events[1]);
}));

test('an impact flashes', () => replay(async ({ page }) => {
  await exactAlone(page);
  const [at, flag] = await page.evaluate(() => {
    const { events } = tautline.report.cases[0];
    return [events.time[events.kind.indexOf('impact')], tautline.theme().flag];
  });
  const flagged = () => page.evaluate((colour) => {
    const canvas = document.querySelector('.replay-canvas');
    const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height });
    const brush = copy.getContext('2d', { willReadFrequently: true });
    brush.drawImage(canvas, 0, 0);
    const { data } = brush.getImageData(0, 0, copy.width, copy.height);
    const probe = document.createElement('canvas').getContext('2d');
    probe.fillStyle = colour;
    probe.fillRect(0, 0, 1, 1);
    const [r, g, b] = probe.getImageData(0, 0, 1, 1).data;
    let count = 0;
    for (let i = 0; i < data.length; i += 4) {
      count += data[i] === r && data[i + 1] === g && data[i + 2] === b && data[i + 3] > 200;
    }
    return count;
  }, flag);
  const before = await flagged();
  await page.click('#replay-next');
  assert.equal(Number(await page.locator('#replay-app input[type=range]').inputValue()), at);
  assert.ok(await flagged() > before + 20, `${before} and ${await flagged()} pixels`);
}));

test('the keys do what is written beside the replay', () => replay(async ({ page, slider, time }) => {
  await slider.focus();
  const end = Number(await slider.getAttribute('max'));
  await page.keyboard.press('End');
  assert.equal(await time(), end);
  await page.keyboard.press('Home');
  assert.equal(await time(), 0);
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs(await time() - end / 100) < 1e-9);
  await page.keyboard.press('ArrowLeft');
  assert.equal(await time(), 0);
  await page.keyboard.press('Shift+ArrowRight');
  assert.ok(await time() > 0 && await time() <= (await exactEvents(page))[0] + 1e-9);
  await page.keyboard.press(' ');
  await page.getByRole('button', { name: 'play or pause' }).getByText('Pause').waitFor();
  await page.keyboard.press(' ');
  await page.getByRole('button', { name: 'play or pause' }).getByText('Play').waitFor();
}));

test('everything in the replay is reached by tab, in the order it is read', () => replay(async ({ page }) => {
  await page.locator('#replay-app select').first().focus();
  const order = [];
  for (let i = 0; i < 13; ++i) {
    order.push(await page.evaluate(() => document.activeElement.getAttribute('aria-label')
      || document.activeElement.closest('label')?.firstChild.textContent || document.activeElement.tagName));
    await page.keyboard.press('Tab');
  }
  assert.deepEqual(order, ['Case', 'Run 1', 'Run 2', 'Run 3', 'the moving body', 'time [s]', 'to the start (Home)',
    'to the event before (Shift and arrow left)', 'play or pause (space)', 'to the next event (Shift and arrow right)',
    'to the end (End)', 'Speed', 'Gap of']);
}));

test('where less motion is asked for, play goes from event to event', () => replay(async ({ page, time }) => {
  const events = await page.evaluate(() => tautline.report.cases[0].events.time);
  assert.match(await page.locator('.replay-keys').textContent(), /less motion/);
  await exactAlone(page);
  await page.click('#replay-play');
  assert.ok(events.includes(await time()));
  await page.click('#replay-play');
}, { reducedMotion: 'reduce' }));

test('what comes after the horizon is grey behind the plots and named in words', () => replay(async ({ page }) => {
  const index = await page.evaluate(() => tautline.report.cases.findIndex((one) =>
    one.horizon < one.end_time));
  assert.notEqual(index, -1, 'the tests need a case with a horizon inside it');
  await page.locator('#replay-app select').first().selectOption({ index });
  await page.locator('#chart-replay').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => tautline.charts['chart-replay'].body._fullLayout?.shapes.length === 2);
  const [band, line] = await page.evaluate(() => tautline.charts['chart-replay'].body._fullLayout.shapes.map((one) =>
    ({ type: one.type, x0: one.x0, x1: one.x1 })));
  const { horizon } = await page.evaluate((i) => ({ horizon: tautline.report.cases[i].horizon }), index);
  assert.deepEqual([band.type, band.x0, line.type, line.x0, line.x1], ['rect', horizon, 'line', horizon, horizon]);
  await page.focus('.replay-canvas + input');
  await page.keyboard.press('End');
  assert.match(await page.locator('.replay-status').textContent(), /beyond the horizon/);
}));

/// The rows of a CSV file as objects.
function rowsOf(file) {
  const [head, ...lines] = readFileSync(file, 'utf8').trim().split('\n').map((line) => line.split(','));
  return lines.map((cells) => Object.fromEntries(head.map((name, i) => [name,
    name === 'event' ? cells[i] : Number(cells[i])])));
}
const folderOf = (run) => join(dirname(benchPage()), 'runs', run.case, run.engine, run.model, String(run.step));

test('a path is read as the program reads it', () => replay(async ({ page }) => {
  const shared = JSON.parse(readFileSync(new URL('../data/replay/path.json', import.meta.url), 'utf8'));
  const told = await page.evaluate(({ path, at }) => {
    const drawn = tautline.motions.drawn(path);
    return at.map(({ time }) => ({ ...tautline.motions.pose(drawn, time), taut: tautline.motions.isTaut(drawn, 0, time) }));
  }, shared);
  shared.at.forEach((row, i) => {
    assert.equal(told[i].taut, row.taut, `t = ${row.time}`);
    for (const name of ['x', 'y', 'angle']) {
      assert.ok(Math.abs(told[i][name] - row[name]) < 1e-14, `${name} at ${row.time}: ${told[i][name]}, not ${row[name]}`);
    }
  });
}));

test('sixty runs are drawn within a pixel of what was recorded, and as near as is said', () => replay(async ({ page }) => {
  const runs = reportOf(benchPage()).runs.filter((one) => one.impacts);
  assert.ok(runs.length >= 60, `${runs.length} runs`);
  // every so many, so that of each case, engine, model and step there are some
  const chosen = Array.from({ length: 60 }, (_, i) => runs[Math.floor(i * runs.length / 60)]).map((run) => ({
    case: run.case, engine: run.engine, model: run.model, step: run.step,
    samples: rowsOf(join(folderOf(run), 'trajectory.csv')).filter((row) => row.event !== 'after')
      .map(({ time, x, y, angle }) => [time, x, y, angle]) }));
  const offs = await page.evaluate((keys) => Promise.all(keys.map(async (key) => {
    const system = tautline.report.cases.find((one) => one.name === key.case);
    const found = (await tautline.motions.runsOf(system)).find((one) => one.engine === key.engine
      && one.model === key.model && one.step === key.step);
    const path = tautline.motions.drawn(found.path);
    const reach = Math.max(...system.geometry.map((cable) => Math.hypot(...cable.attachment)));
    return { pixel: 1e-3 * system.extent, said: path.error, off: Math.max(...key.samples.map(([time, x, y, angle]) => {
      const pose = tautline.motions.pose(path, time);
      return Math.hypot(pose.x - x, pose.y - y) + reach * Math.abs(pose.angle - angle);
    })) };
  })), chosen);
  offs.forEach(({ off, said, pixel }, i) => {
    const name = `${chosen[i].case} ${chosen[i].engine} ${chosen[i].model} ${chosen[i].step}`;
    assert.ok(off <= said * (1 + 1e-9), `${name}: ${off} m off, said to be ${said}`);
    assert.ok(off <= pixel, `${name}: ${off} m, a pixel is ${pixel}`);
  });
}));

test('exact event lies over the exact path at every instant', () => replay(async ({ page }) => {
  const offs = await page.evaluate(async () => {
    const { motions, report } = tautline;
    const result = [];
    for (const system of report.cases) {
      const exact = motions.exactMotion(system);
      const runs = (await motions.runsOf(system)).filter((one) => one.engine === 'exact' && one.model === 'event');
      for (const run of runs.map((one) => motions.runMotion(one))) {
        let worst = 0;
        for (let i = 0; i <= 20011; ++i) {
          const [a, b] = [exact, run].map((one) => one.pose(system.end_time * i / 20011));
          worst = Math.max(worst, Math.hypot(a.x - b.x, a.y - b.y));
        }
        result.push(worst / (1e-3 * system.extent));
      }
    }
    return result;
  });
  assert.ok(offs.length >= 4, `${offs.length} runs`);
  assert.ok(Math.max(...offs) < 1, `${offs} pixels`);
}));

test('taut is said where an event of the exact motion began it and none has ended it', () => replay(async ({ page, slider }) => {
  const report = reportOf(benchPage());
  let [taut, slack] = [0, 0];
  for (const [index, system] of report.cases.entries()) {
    await page.locator('#replay-app select').first().selectOption({ index });
    const changes = system.events.time.map((time, i) => ({ time, kind: system.events.kind[i], cables: system.events.cables[i] }))
      .filter(({ kind }) => kind !== 'impact');
    const bounds = [0, ...changes.map(({ time }) => time), system.end_time];
    for (let i = 0; i + 1 < bounds.length; ++i) {
      if (bounds[i + 1] - bounds[i] > 1e-3) {
        const held = new Set();
        changes.slice(0, i).forEach(({ kind, cables }) => cables.forEach((one) => held[kind === 'taut' ? 'add' : 'delete'](one)));
        await slider.evaluate((box, at) => { box.value = at; box.dispatchEvent(new Event('input')); },
          0.5 * (bounds[i] + bounds[i + 1]));
        const words = await page.locator('.replay-status').textContent();
        for (let cable = 0; cable < system.geometry.length; ++cable) {
          assert.match(words, new RegExp(`cable ${cable} ${held.has(cable) ? 'taut' : 'slack by'}`));
          held.has(cable) ? ++taut : ++slack;
        }
      }
    }
  }
  assert.ok(taut > 0 && slack > 0, `${taut} taut, ${slack} slack`);
}));

test('the gap panel shows the gap of a taut cable as it was recorded', () => replay(async ({ page }) => {
  const shown = await page.evaluate(() => {
    const { motions, report } = tautline;
    return report.cases.flatMap((system) => {
      const { path } = motions.exactMotion(system);
      return system.geometry.flatMap((cable, i) => {
        const { x, y } = motions.gapCurve(path, cable, i, motions.instants(path, 8));
        const { times, gapTimes } = path.cables[i];
        return gapTimes.length ? x.map((time, k) => [time, y[k]]).filter(([time]) => times.some((from, k) => k % 2 === 0
          && times[k + 1] - from > 0.01 * system.end_time && time >= from && time <= times[k + 1])).map(([, value]) => value) : [];
      });
    });
  });
  assert.ok(shown.length > 20, `${shown.length} values`);
  assert.ok(Math.max(...shown.map(Math.abs)) < 1e-9, `${Math.max(...shown.map(Math.abs))} m on a taut cable`);
}));

test('how near each motion is drawn stands beside it, and how many of its impacts', () => replay(async ({ page }) => {
  const report = reportOf(benchPage());
  for (const [index, system] of report.cases.entries()) {
    await page.locator('#replay-app select').first().selectOption({ index });
    await settled(page);
    const told = await page.locator('.replay-note li').allTextContents();
    const impacts = system.events.kind.filter((kind) => kind === 'impact').length;
    assert.match(told[0], new RegExp(system.events.left_out
      ? `${impacts} of ${(impacts + system.events.left_out).toLocaleString('en')} impacts are shown, the fastest`
      : `All ${impacts} impacts are shown`));
    assert.ok(told.length > 1);
    for (const text of told.slice(1)) {
      const [, engine, model, step] = /^(\S+) (\S+), step (\S+) s: drawn within [\d.e-]+ \([\d.e-]+ pixel\)/.exec(text);
      const all = rowsOf(join(folderOf({ case: system.name, engine, model, step }), 'events.csv'))
        .filter((row) => -row.rate_before > report.options.count_speed).length;
      const counted = `impacts faster than ${report.options.count_speed}( m/s)? are shown`;
      assert.match(text, new RegExp(all > 300 ? `300 of ${all.toLocaleString('en')} ${counted}, the fastest` : `All ${all} ${counted}`));
    }
  }
}));

test('the motions of the runs are loaded when they are shown, from files beside the page', () => withPage(benchPage(), async ({ page, said, asked }) => {
  const own = pathToFileURL(benchPage()).href;
  const folder = own.slice(0, own.lastIndexOf('/') + 1);
  const others = () => asked.filter((url) => url !== own && !/^(data|blob):/.test(url));
  const cases = reportOf(benchPage()).cases;
  assert.deepEqual(others(), []);
  await settled(page);
  assert.deepEqual(others(), [folder + cases[0].motions]);
  await page.locator('#replay-app select').first().selectOption({ index: 1 });
  await settled(page);
  await page.locator('#replay-app select').first().selectOption({ index: 0 });
  await settled(page);
  assert.deepEqual(others(), [folder + cases[0].motions, folder + cases[1].motions]);
  assert.deepEqual(said, []);
}));

test('without those files the page says so and everything else works', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'tautline-page-'));
  try {
    copyFileSync(benchPage(), join(folder, 'index.html'));
    await withPage(join(folder, 'index.html'), async ({ page, said }) => {
      await settled(page);
      const [{ motions }] = reportOf(benchPage()).cases;
      assert.match(await page.locator('.replay-note').textContent(),
        new RegExp(`The motions of the runs are not available: ${motions} is missing next to this page`));
      const start = await pixels(page);
      await page.focus('.replay-canvas + input');
      await page.keyboard.press('End');
      assert.notEqual(await pixels(page), start);
      await drawAll(page);
      assert.deepEqual(said.filter((text) => !/ERR_FILE_NOT_FOUND/.test(text)), []);
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('the page of a single case has the motions of its runs in itself', async () => {
  const single = process.env.TAUTLINE_HOSTILE_PAGE;
  assert.ok(single, 'set TAUTLINE_HOSTILE_PAGE to the page of a single case');
  await withPage(single, async ({ page, said, asked }) => {
    await settled(page);
    await page.getByLabel('Run 1').selectOption({ index: 1 });
    assert.match(await page.locator('.replay-note').textContent(), /exact \S+, step 0.01 s: drawn within/);
    assert.deepEqual(asked.filter((url) => !/^(data|blob):/.test(url)), [pathToFileURL(single).href]);
    assert.deepEqual(said, []);
  });
});
