// Systems in space in the replay: what its picture shows, and how a reader turns it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { benchPage, drawAll, reportOf, withPage } from './browser.mjs';
import { settled } from './replay.mjs';

const axe = readFileSync(new URL('./node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');

const spacePage = () => {
  assert.ok(process.env.TAUTLINE_SPACE_PAGE, 'set TAUTLINE_SPACE_PAGE to an index.html of systems in space');
  return process.env.TAUTLINE_SPACE_PAGE;
};

/// A driver that draws in software warns of reading its picture: no defect of the page.
const own = (said) => said.filter((text) => !/GPU stall due to ReadPixels/.test(text));

/// Opens the page of systems at its replay; without WebGL, the browser has none.
const space = (action, { webGL = true, ...context } = {}) => withPage(spacePage(), async ({ page, said, asked }) => {
  if (!webGL) {
    await page.addInitScript(() => {
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        return /webgl/.test(kind) ? null : getContext.call(this, kind, ...more);
      };
    });
    await page.reload();
  }
  await settled(page);
  await action({ page, asked });
  assert.deepEqual(own(said), []);
}, context);

const systems = () => reportOf(spacePage()).cases.filter((one) => one.system);
async function choose(page, name) {
  await page.locator('#replay-app select').first().selectOption(name);
  await settled(page);
}
const pixels = (page) => page.evaluate(() => document.querySelector('.replay-canvas').toDataURL());
const seen = (page) => page.evaluate(() => tautline.replay.picture().seen());

// ---- the data by code of its own

const decoded = ({ start, scale, steps }) => steps.reduce((all, step) => [...all, (all.at(-1) ?? 0) + step], [])
  .map((place) => start + scale * place);

/// The centre of a body, and the matrix that turns its axes to the world's, from its columns in the report.
function placeOf(body, time) {
  const times = body.times ??= decoded(body.time);
  const last = times.length - 1;
  let i = 0;
  while (i < last - 1 && times[i + 1] <= time) {
    i += 1;
  }
  const s = last < 1 ? 0 : Math.min(1, Math.max(0, (time - times[i]) / (times[i + 1] - times[i])));
  const [x, y, z, a, b, c, d] = ['x', 'y', 'z', 'qw', 'qx', 'qy', 'qz'].map((name) => {
    const places = body[`${name} numbers`] ??= decoded(body[name]);
    const bends = body[`${name} bends`] ??= decoded(body[`${name}_bends`]);
    if (last < 1) {
      return places[0];
    }
    // Bernstein's form of the cubic
    const [from, to] = [places[i], places[i + 1]];
    const [one, two] = [from + (to - from) / 3 + bends[2 * i], from + 2 * (to - from) / 3 + bends[2 * i + 1]];
    return (1 - s) ** 3 * from + 3 * s * (1 - s) ** 2 * one + 3 * s * s * (1 - s) * two + s ** 3 * to;
  });
  const n = 2 / (a * a + b * b + c * c + d * d);
  return { centre: [x, y, z], matrix: [[1 - n * (c * c + d * d), n * (b * c - a * d), n * (b * d + a * c)],
    [n * (b * c + a * d), 1 - n * (b * b + d * d), n * (c * d - a * b)],
    [n * (b * d - a * c), n * (c * d + a * b), 1 - n * (b * b + c * c)]] };
}

/// The centre and the ends of the axes, `lever` [m] long.
function tipsOf({ centre, matrix }, lever) {
  return [centre, ...[0, 1, 2].map((k) => centre.map((value, row) => value + lever * matrix[row][k]))];
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const less = (a, b) => a.map((value, k) => value - b[k]);
const unit = (a) => a.map((value) => value / Math.hypot(...a));

/// A pixel of the camera, by its matrix.
function onStage({ camera: { eye, target, up, fov }, width, height }, point) {
  const back = unit(less(eye, target));
  const right = unit(cross(up, back));
  const view = [right, cross(back, right), back].map((axis) => dot(axis, less(point, eye)));
  const scale = 1 / Math.tan(fov * Math.PI / 360);
  return [width * (0.5 + 0.5 * scale * height / width * view[0] / -view[2]), height * (0.5 - 0.5 * scale * view[1] / -view[2])];
}

/// A pixel of a projection.
const onPane = ({ left, top, w, h, scale, axis, up, centre }, point) => [left + w / 2 + scale * dot(axis, less(point, centre)),
  top + h / 2 - scale * dot(up, less(point, centre))];

/// The runs of a case, from the file next to the page.
function runsOf(system) {
  const text = readFileSync(join(dirname(spacePage()), system.motions), 'utf8');
  return JSON.parse(text.slice(text.indexOf(', [') + 2, text.lastIndexOf(')')));
}

/// Shows every system at `instants` random instants each, with the runs that it begins with, and returns how far its
/// bodies are from the data, at most [px].
async function compared(page, instants) {
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  let [worst, count] = [0, 0];
  for (const system of systems()) {
    await choose(page, system.name);
    const runs = runsOf(system);
    for (let i = 0; i < instants; ++i) {
      const time = random() * system.end_time;
      const shown = await page.evaluate((at) => {
        tautline.replay.show(at);
        return { ...tautline.replay.picture().seen(), time: tautline.replay.state.time };
      }, time);
      assert.ok(shown.bodies.length >= system.system.bodies.length);
      for (const { name, body, at } of shown.bodies) {
        const path = name === 'exact path' ? system.path
          : runs.find((run) => name === `${run.engine} ${run.model}, step ${run.step} s`).path;
        const tips = tipsOf(placeOf(path.bodies[body], shown.time), shown.lever);
        at.forEach((points, pane) => points.forEach((point, k) => {
          const [x, y] = shown.stage ? onStage(shown, tips[k]) : onPane(shown.panes[pane], tips[k]);
          worst = Math.max(worst, Math.hypot(point[0] - x, point[1] - y));
          count += 1;
        }));
      }
    }
  }
  return { worst, count };
}

test('bodies on the stage are within a pixel of the data at 60 random instants', (context) => space(async ({ page }) => {
  assert.ok((await seen(page)).stage, 'the tests need WebGL');
  const { worst, count } = await compared(page, Math.ceil(60 / systems().length));
  context.diagnostic(`${worst} px at most, of ${count} points`);
  assert.ok(worst <= 1, `${worst} px`);
}));

test('the stage is painted where its bodies are', () => space(async ({ page }) => {
  const painted = await page.evaluate(() => {
    const { bodies } = tautline.replay.picture().seen();
    const canvas = document.querySelector('.replay-canvas');
    const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height });
    const brush = copy.getContext('2d', { willReadFrequently: true });
    brush.drawImage(canvas, 0, 0);
    const alpha = ([x, y]) => brush.getImageData(Math.round(x * devicePixelRatio), Math.round(y * devicePixelRatio), 1, 1).data[3];
    return { centres: bodies.map(({ at }) => alpha(at[0][0])), corner: alpha([4, 4]) };
  });
  assert.ok(painted.centres.every((one) => one > 200), `${painted.centres}`);
  assert.equal(painted.corner, 0);
}));

test('without WebGL projections show the same, and the page says why', (context) => space(async ({ page }) => {
  assert.equal((await seen(page)).stage, false);
  assert.match(await page.locator('.replay-cables').textContent(), /Without WebGL/);
  const { worst, count } = await compared(page, Math.ceil(60 / systems().length));
  context.diagnostic(`${worst} px at most, of ${count} points`);
  assert.ok(worst <= 1, `${worst} px`);
  const start = await pixels(page);
  await page.evaluate(() => tautline.replay.show(0));
  assert.notEqual(await pixels(page), start);
}, { webGL: false }));

test('a reader who prefers projections chooses them', () => space(async ({ page }) => {
  const before = await pixels(page);
  await page.getByLabel('Picture').selectOption('flat');
  assert.equal((await seen(page)).stage, false);
  assert.notEqual(await pixels(page), before);
  await page.getByLabel('Picture').selectOption('space');
  assert.ok((await seen(page)).stage);
}));

// on a busy machine in no more time than the page itself takes to open there
test('the first frame comes within a second', async (context) => {
  const took = [];
  for (let i = 0; i < 3; ++i) {
    await space(async ({ page }) => {
      took.push(await page.evaluate(() => [performance.getEntriesByName('replay shown')[0].duration,
        performance.getEntriesByType('navigation')[0].loadEventEnd].map(Math.round)));
    });
  }
  const told = `${took.map(([frame, opening]) => `${frame} (page ${opening})`).join(', ')} ms`;
  context.diagnostic(told);
  assert.ok(took.some(([frame, opening]) => frame <= Math.max(1000, opening)), told);
});

test('keys, buttons and a dragging pointer turn the view and leave the data', () => space(async ({ page }) => {
  await page.evaluate(() => tautline.replay.show(0.3));
  const data = () => page.evaluate(() => JSON.stringify([tautline.replay.state.time,
    tautline.replay.state.motions.map((one) => one.pose(tautline.replay.state.time))]));
  const places = async () => JSON.stringify((await seen(page)).bodies);
  const [first, view] = [await data(), await places()];
  const changed = async (act, what) => {
    const before = await places();
    await act();
    assert.notEqual(await places(), before, what);
    assert.equal(await data(), first, what);
  };
  const canvas = page.locator('.replay-canvas');
  await canvas.evaluate((one) => one.scrollIntoView({ block: 'center' }));
  await canvas.focus();
  for (const key of ['a', 'd', 'd', 'w', 's', 's', '+', '-', '-']) {
    await changed(() => page.keyboard.press(key), key);
  }
  await changed(() => page.keyboard.press('0'), '0');
  assert.equal(await places(), view);
  const box = await canvas.boundingBox();
  await changed(async () => {
    await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.5 * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.6 * box.height, { steps: 4 });
    await page.mouse.up();
  }, 'drag');
  const wheel = (ctrlKey) => () => canvas.evaluate((one, ctrl) => one.dispatchEvent(new WheelEvent('wheel',
    { deltaY: -200, ctrlKey: ctrl, bubbles: true, cancelable: true })), ctrlKey);
  await changed(wheel(true), 'Ctrl and the wheel');
  const zoomed = await places();
  await wheel(false)();
  assert.equal(await places(), zoomed, 'the wheel alone scrolls the page');
  for (const name of ['look from the front', 'look from the side', 'look from above']) {
    await changed(() => page.getByRole('button', { name }).click(), name);
  }
}));

test('two fingers zoom the picture', () => space(async ({ page }) => {
  const before = JSON.stringify((await seen(page)).camera);
  await page.evaluate(() => {
    const canvas = document.querySelector('.replay-canvas');
    canvas.setPointerCapture = () => {};
    const send = (kind, pointerId, clientX) => canvas.dispatchEvent(new PointerEvent(kind, { pointerId, clientX, clientY: 100,
      button: 0, pointerType: 'touch', bubbles: true }));
    send('pointerdown', 1, 100);
    send('pointerdown', 2, 200);
    send('pointermove', 2, 300);
    send('pointerup', 1, 100);
    send('pointerup', 2, 300);
  });
  const { camera } = await seen(page);
  assert.ok(camera.distance < 0.6 * JSON.parse(before).distance, `${camera.distance}, before ${before}`);
}));

test('the slider moves the picture and the cursor of the charts', () => space(async ({ page }) => {
  await page.locator('#chart-replay').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => tautline.charts['chart-replay'].body._fullLayout);
  const place = () => page.evaluate(() => document.querySelector('.time-cursor').getBoundingClientRect().x);
  const slider = page.locator('#replay-app input[type=range]');
  await slider.evaluate((box) => { box.value = 0; box.dispatchEvent(new Event('input')); });
  const [start, before] = [await place(), JSON.stringify((await seen(page)).bodies)];
  const time = await slider.evaluate((box) => {
    box.value = 0.4 * box.max;
    box.dispatchEvent(new Event('input'));
    return Number(box.value);
  });
  assert.notEqual(JSON.stringify((await seen(page)).bodies), before);
  const expected = await page.evaluate((at) => {
    const { xaxis } = tautline.charts['chart-replay'].body._fullLayout;
    return xaxis.l2p(at) - xaxis.l2p(0);
  }, time);
  assert.ok(Math.abs(await place() - start - expected) < 1.5, `${await place() - start} and ${expected} px`);
  const titles = await page.evaluate(() => [1, 3].map((i) =>
    tautline.charts['chart-replay'].body._fullLayout[`yaxis${i === 1 ? '' : i}`].title.text));
  assert.match(titles[0], /gap 0/);
  assert.match(titles[1], /turn of|height of/);
}));

test('cables are taut where an event of the exact motion began it, and the legend says their tensions', () => space(async ({ page }) => {
  let [taut, slack] = [0, 0];
  for (const system of systems()) {
    await choose(page, system.name);
    const changes = system.events.time.map((time, i) => ({ time, kind: system.events.kind[i], cables: system.events.cables[i] }))
      .filter(({ kind }) => kind !== 'impact');
    const bounds = [0, ...changes.map(({ time }) => time), system.end_time];
    for (let i = 0; i + 1 < bounds.length && i < 8; ++i) {
      if (bounds[i + 1] - bounds[i] > 1e-2) {
        const held = new Set();
        changes.slice(0, i).forEach(({ kind, cables }) => cables.forEach((one) => held[kind === 'taut' ? 'add' : 'delete'](one)));
        await page.evaluate((at) => tautline.replay.show(at), 0.5 * (bounds[i] + bounds[i + 1]));
        const words = await page.locator('.replay-status').textContent();
        for (let cable = 0; cable < system.system.cables.length; ++cable) {
          assert.match(words, new RegExp(`cable ${cable} (${held.has(cable) ? 'taut' : 'slack by'}|cut|not yet)`), system.name);
          held.has(cable) ? ++taut : ++slack;
        }
      }
    }
    const tensions = system.path.cables.flatMap((cable) => (cable.tension ? decoded(cable.tension.value) : []));
    const legend = await page.locator('.replay-cables').textContent();
    assert.match(legend, Math.max(0, ...tensions) > 0 ? /tension 0 to / : /^taut/, system.name);
    assert.match(legend, /slack/);
  }
  assert.ok(taut > 0 && slack > 0, `${taut} taut, ${slack} slack`);
}));

test('a case in the plane next to a system is drawn as by itself, and the system after it', async () => {
  const mixed = process.env.TAUTLINE_MIXED_PAGE;
  assert.ok(mixed, 'set TAUTLINE_MIXED_PAGE to the page of a system and a case in the plane');
  await withPage(mixed, async ({ page, said }) => {
    await settled(page);
    const { cases } = reportOf(mixed);
    for (const one of [...cases, ...cases]) {
      await choose(page, one.name);
      const label = await page.locator('.replay-canvas').getAttribute('aria-label');
      const shows = async (locator) => assert.equal(await locator.isVisible(), Boolean(one.system), one.name);
      await shows(page.locator('.replay-cables'));
      await shows(page.getByRole('button', { name: 'look from above' }));
      if (one.system) {
        assert.match(label, /the moving bodies in space/);
        assert.ok((await seen(page)).stage);
      } else {
        assert.equal(label, 'the moving body');
      }
      assert.match(await page.locator('.replay-note').textContent(), /exact path: drawn within/);
    }
    assert.deepEqual(own(said), []);
  });
});

test('a page of systems asks for nothing but its own files, and names three.js and its licence', () => space(async ({ page, asked }) => {
  await drawAll(page);
  const folder = pathToFileURL(dirname(spacePage())).href;
  assert.deepEqual(asked.filter((url) => !/^(data|blob):/.test(url) && !url.startsWith(folder)), []);
  assert.match(await page.locator('footer').textContent(), /three\.js, under the MIT licence/);
}));

test('a page of cases in the plane has nothing of space in it', () => {
  const text = readFileSync(benchPage(), 'utf8');
  for (const word of ['WebGLRenderer', 'id="three"', 'id="space-scripts"', 'three.js']) {
    assert.ok(!text.includes(word), word);
  }
  assert.ok(readFileSync(spacePage(), 'utf8').includes('WebGLRenderer'));
});

for (const colorScheme of ['light', 'dark']) {
  test(`axe finds nothing in the replay of a system in the ${colorScheme} scheme`, () => space(async ({ page }) => {
    await page.evaluate(axe);
    const found = await page.evaluate(() => axe.run({ include: ['#replay-app'], exclude: ['.js-plotly-plot'] },
      { resultTypes: ['violations'], rules: { 'target-size': { enabled: true } } }));
    assert.deepEqual(found.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 200)).join('\n')}`), []);
  }, { colorScheme }));
}

for (const width of [400, 1280]) {
  test(`at ${width} px the picture and its controls are on the screen`, () => space(async ({ page }) => {
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width);
    const boxes = await page.evaluate(() => [...document.querySelectorAll('#replay-app :is(button, select, canvas)')]
      .filter((one) => one.checkVisibility()).map((one) => one.getBoundingClientRect()).map(({ left, right }) => [left, right]));
    assert.ok(boxes.length > 10);
    assert.deepEqual(boxes.filter(([left, right]) => left < 0 || right > width), []);
  }, { width }));
}
