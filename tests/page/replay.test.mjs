import assert from 'node:assert/strict';
import test from 'node:test';
import { benchPage, withPage } from './browser.mjs';

/// Opens the page at its replay; `time` reads the time shown [s].
const replay = (action, context) => withPage(benchPage(), async ({ page, said }) => {
  await page.locator('#replay-app').scrollIntoViewIfNeeded();
  await page.locator('.replay-status:not(:empty)').waitFor();
  const slider = page.locator('#replay-app input[type=range]');
  const time = async () => Number(await slider.inputValue());
  await action({ page, slider, time });
  assert.deepEqual(said, []);
}, context);
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

test('the speed is obeyed', () => replay(async ({ page, time }) => {
  const advance = async (speed) => {
    await page.getByLabel('Speed').selectOption(speed);
    await page.focus('.replay-canvas + input');
    await page.keyboard.press('Home');
    const start = Date.now();
    await page.click('#replay-play');
    await page.waitForTimeout(700);
    const reached = await time();
    const rate = reached / ((Date.now() - start) / 1000);
    await page.click('#replay-play');
    return rate;
  };
  const [slow, fast] = [await advance('0.25'), await advance('4')];
  // sixteen times on a quiet machine; a busy one is late by a frame or two at either end
  assert.ok(fast / slow > 8 && fast / slow < 32, `${slow} and ${fast} s/s`);
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
    one.path && one.horizon < one.path.time.at(-1)));
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
