// The live page, as scripts/playground makes it. TAUTLINE_PLAYGROUND is its file, TAUTLINE_PROGRAM the program tautline.
// `node --test` prints what a drag and the fog take; with TAUTLINE_MEASURE=1 on an idle machine it also asserts it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { complete, readState, spellState, view } from '../../bench/playground/case.mjs';
import { Asker } from '../../bench/playground/asker.mjs';
import { withPage, withText } from './browser.mjs';

const file = process.env.TAUTLINE_PLAYGROUND;
const program = process.env.TAUTLINE_PROGRAM;
if (!file || !program) {
  throw new Error('set TAUTLINE_PLAYGROUND to a page of scripts/playground, and TAUTLINE_PROGRAM to the program tautline');
}
const axe = readFileSync(new URL('./node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
const shipped = JSON.parse(readFileSync(new URL('../../languages/python/src/tautline/cases.json', import.meta.url), 'utf8'));
const standard = 'case=breakwater/1910121100';
/// The largest page, and the longest waits on an idle machine [bytes, ms].
const [largest, drag, fog] = [500_000, 16, 100];

/// Waits until the page shows the motion of its state, with the fog and the engine's run.
const solved = (page) => page.waitForFunction(() => {
  const { motion, state } = globalThis.playground ?? {};
  return motion && JSON.stringify(motion.the_case) === JSON.stringify(state.the_case) && motion.settling;
});
const drawn = (page) => page.waitForFunction(() => {
  const { run, fog } = playground.picture();
  return run?.states !== null && run?.at && fog;
});

/// `action` on a page of its own at `address`.
const onPage = (address, action, context) => withPage(file, async ({ page, said, asked }) => {
  await page.goto('about:blank');
  await page.goto(`${pathToFileURL(file).href}#${address}`);
  await solved(page);
  await action(page, { said, asked });
  assert.deepEqual(said, []);
}, context);

/// Checks that share one page, each at its address: to open it costs more than most of them.
const shared = [];
const check = (name, address, action) => shared.push({ name, address, action });

const caseNow = (page) => page.evaluate(() => playground.state.the_case);
const middleOf = async (page, name) => {
  const box = await page.getByRole('button', { name }).first().boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};
/// Chromium's JSON and the test runner's lose the sign of zero: numbers travel as hexadecimal bits.
const bitsOf = (values) => Buffer.from(Float64Array.from(values).buffer).toString('hex');

test('the page is one file of at most 500 kB gzip', () => {
  const bytes = gzipSync(readFileSync(file), { level: 9 }).length;
  assert.ok(bytes <= largest, `${bytes} bytes`);
});

check('it shows the standard case, and asks nothing of the network', `${standard}&t=0`, async (page, { asked }) => {
  await drawn(page);
  assert.match(await page.locator('#words').textContent(), /impacts in 20/);
  assert.match(await page.locator('#versions').textContent(), /tautline \d+\.\d+.*planck \d/);
  assert.deepEqual(asked.filter((one) => !/^(file:|blob:|about:|data:)/.test(one)), []);
});

check('the events have the bits of the program, also of a case that a hand has changed', `${standard}&t=0`, async (page) => {
  const folder = mkdtempSync(join(tmpdir(), 'tautline-playground-'));
  try {
    let kinds = 0;
    for (const name of ['breakwater/1910121100', 'plate-four-cables', 'level-beam', 'a hand']) {
      if (name === 'a hand') {
        const [x, y] = await middleOf(page, /^body/);
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + 9, y - 7, { steps: 3 });
        await page.mouse.up();
      } else {
        await page.evaluate((one) => { location.hash = `case=${one}&t=0`; }, name);
        await page.waitForFunction((one) => playground.state.the_case.name === one, name);
      }
      await solved(page);
      const { toml, law } = await page.evaluate(() => ({ toml: playground.motion.toml, law: playground.state.law }));
      writeFileSync(join(folder, 'case.toml'), toml);
      const native = JSON.parse(execFileSync(program, ['solve', join(folder, 'case.toml'), '--law', law, '--json', '-'], { encoding: 'utf8' }));
      const row = ({ position, angle, velocity, spin }) => [...position, angle, ...velocity, spin];
      const cables = native.case.cables.map((_, cable) => cable);
      const impulses = (one) => cables.map((cable) => one.impulses?.[one.cables.indexOf(cable)] ?? 0);
      const expected = bitsOf(native.events.flatMap((one) => [one.time, ...row(one.before), ...row(one.after), ...impulses(one)]));
      const found = await page.evaluate((width) => {
        const { events } = playground.motion;
        const all = Float64Array.from(Array.from({ length: events.count }).flatMap((_, i) => [events.time[i], ...events.before.subarray(6 * i, 6 * i + 6),
          ...events.after.subarray(6 * i, 6 * i + 6), ...events.impulses.subarray(width * i, width * (i + 1)).map((one) => Math.max(0, one))])); // below are gravity's
        return { bits: [...new Uint8Array(all.buffer)].map((one) => one.toString(16).padStart(2, '0')).join(''), kinds: events.kind,
          cables: [...events.cables] };
      }, cables.length);
      assert.equal(found.bits, expected, name);
      assert.deepEqual(found.kinds, native.events.map(({ kind }) => kind), name);
      assert.deepEqual(found.cables, native.events.map((one) => one.cables.reduce((set, cable) => set | (1 << cable), 0)), name);
      assert.ok(native.events.some((one) => one.impulses?.some((impulse) => impulse > 0)), name);
      kinds += native.events.length;
    }
    assert.ok(kinds > 500, `${kinds} events`);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('an address brings back every bit of a state', () => {
  let seed = 1;
  const random = () => { // any bits but those of no number
    const bits = new DataView(new ArrayBuffer(8));
    for (const at of [0, 4]) bits.setUint32(at, seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0);
    const value = bits.getFloat64(0);
    return Number.isFinite(value) ? value : -0;
  };
  const pair = () => [random(), random()];
  const numbers = (one) => [one.duration, ...one.gravity, one.angle_limit ?? 0, one.ceiling ?? 0, one.body.mass, one.body.inertia,
    ...one.cables.flatMap((cable) => [...cable.anchor, ...cable.attachment, cable.length, cable.restitution, cable.capture_speed ?? 0,
      ...(cable.restitution_table ?? []).flat()]), ...one.initial.position, one.initial.angle, ...one.initial.velocity, one.initial.spin];
  for (let i = 0; i < 200; ++i) {
    const the_case = complete({ name: `a & b = ${i} #%"é`, duration: random(), gravity: [-0, random()], body: { mass: random(), inertia: random() },
      ...(i % 2 && { angle_limit: random(), ceiling: random() }),
      cables: Array.from({ length: 1 + (i % 8) }, (_, k) => ({ anchor: pair(), attachment: pair(), length: random(), restitution: random(),
        ...(k % 2 && { capture_speed: random(), taut: k % 3 === 0 }), ...(k % 4 === 3 && { restitution_table: [pair(), pair()] }) })),
      initial: { position: pair(), angle: random(), velocity: pair(), spin: -0 } });
    const state = { the_case, law: 'poisson', engine: 'planck', model: 'rope-bounce', rate: 1000, fog: false, apart: 1e-8, speed: 0.25, time: Math.abs(random()) };
    const { state: back, problem } = readState(`#${spellState(state, shipped)}`, shipped);
    assert.equal(problem, undefined);
    assert.equal(bitsOf(numbers(back.the_case)), bitsOf(numbers(the_case)));
    assert.deepEqual(back, state);
  }
  for (const one of shipped) {
    const state = { ...view, the_case: complete(one) };
    assert.equal(spellState(state, shipped), `case=${one.name}`);
    assert.deepEqual(readState(spellState(state, shipped), shipped).state, state);
  }
});

test('an address that asks for what there is not is told of it, and the rest is as it asks', () => {
  const { state, problem, stays } = readState('#case=level-beam&law=newton&rate=50&apart=1e-3&speed=3&fog=no&engine=rope&lw=1&t=1', shipped);
  assert.equal(problem, 'address: lw is no key; law=newton must be simultaneous, poisson, sequential or energetic; '
    + 'engine=rope must be an engine and its model, such as planck/rope, or none; rate=50 must be 60, 240 or 1000; '
    + 'apart=1e-3 must be 1e-2, 1e-4, 1e-6, 1e-8, 1e-10 or 1e-12; speed=3 must be 0.1, 0.25, 0.5, 1, 2 or 4; fog=no must be 0 or 1');
  assert.equal(stays, true);
  const { the_case, ...rest } = state;
  assert.equal(the_case.name, 'level-beam');
  assert.deepEqual(rest, { ...view, time: 1 });
  const guide = readFileSync(new URL('../../docs/guides/playground.md', import.meta.url), 'utf8');
  assert.ok(guide.includes(/apart=1e-3 must be (.*?);/.exec(problem)[1]), 'the guide lists them');
});

test('a worker that fails is heard of, and one that has not gone answers on', () => {
  const [given, said, used, started] = [globalThis.Worker, [], [], []];
  let worker;
  globalThis.Worker = class {
    posted = [];
    constructor() { worker = this; }
    postMessage(message) { this.posted.push(message); }
  };
  try {
    const asker = new Asker('', { started: (data) => started.push(data), failed: (message) => said.push(message) });
    asker.ask(1, (answer) => used.push(answer));
    worker.onmessage({ data: { version: '1' } });
    asker.ask(2, (answer) => used.push(answer));
    worker.onerror({ message: 'no memory' });
    worker.onmessage({ data: { answer: 'two' } });
    assert.deepEqual([worker.posted, said, used, started], [[1, 2], ['no memory'], ['two'], [{ version: '1' }]]);
    asker.ask(3, () => {});
    worker.onerror({});
    asker.ask(4, (answer) => used.push(answer));
    worker.onmessage({ data: { answer: 'four' } });
    worker.onmessage({ data: { failed: 'it does not load' } });
    assert.deepEqual([worker.posted, said, used], [[1, 2, 3, 4], ['no memory', 'a worker did not start', 'it does not load'], ['two', 'four']]);
  } finally {
    globalThis.Worker = given;
  }
});

test('a solver that cannot be loaded is told of', () => {
  const empty = gzipSync(Buffer.from('0061736d01000000', 'hex')).toString('base64'); // a module without a function
  const text = readFileSync(file, 'utf8').replace(/(<script type="application\/octet-stream" id="wasm">)[^<]*/, `$1${empty}`);
  return withText(text, async ({ page }) => {
    await page.waitForFunction(() => !document.getElementById('problem').hidden);
    assert.match(await page.locator('#problem').textContent(), /^This browser cannot run the solver: ./);
  });
});

test('engines that cannot be loaded are told of, beside the exact motion', () => {
  const [text, broken] = [readFileSync(file, 'utf8'), 'postMessage({engines:'];
  assert.equal(text.split(broken).length, 2);
  return withText(text.replace(broken, 'throw Error(`none`);$&'), async ({ page }) => {
    await solved(page);
    await page.waitForFunction(() => /^This browser cannot run the engines: none$/.test(document.getElementById('problem').textContent));
    assert.equal(await page.locator('#problem').isVisible(), true);
  });
});

check('a law that there is not is told of in a sentence, until another is chosen', 'case=level-beam&law=newton&t=0', async (page) => {
  assert.match(await page.locator('#problem').textContent(), /^address: law=newton must be simultaneous, /);
  await page.selectOption('#rate', '240');
  assert.equal(await page.locator('#problem').isVisible(), false);
});

check('cables stay taut to the end of a motion that repeats itself, however long',
  spellState({ ...view, the_case: { ...complete(shipped[0]), name: 'long', duration: 1e6 } }, shipped), async (page) => {
    const { ends, late, end } = await page.evaluate(() => ({ ends: playground.motion.stretches.map((all) => all.at(-1).end),
      late: [3000.5, 999_999].map((time) => playground.motion.tautAt(time)), end: playground.motion.end }));
    assert.deepEqual([ends, late, end], [[1e6, 1e6], [3, 3], 1e6]);
  });

check('a link to an instant shows it at once', `${standard}&t=2`, async (page) => {
  const place = () => document.querySelector('.handle.body').style.transform;
  const at = await page.evaluate(`new Promise((done) => {
    addEventListener('hashchange', () => done((${place})()), { once: true });
    location.hash = '${standard}&t=0';
  })`);
  await drawn(page);
  assert.equal(at, await page.evaluate(place));
});

check('an address that cannot be read shows the standard case and says why', 'cable=1,2,3', async (page) => {
  assert.equal((await caseNow(page)).name, shipped[0].name);
  assert.equal(await page.locator('#problem').textContent(), 'address: cable=1,2,3 must be 6 to 7 numbers');
});

check('keys move, turn and lengthen, and the address keeps what they made', `${standard}&t=0`, async (page) => {
  const before = await caseNow(page);
  const key = async (name, ...keys) => {
    await page.getByRole('button', { name }).first().focus();
    for (const one of keys) await page.keyboard.press(one);
    await solved(page);
    return caseNow(page);
  };
  const moved = await key(/^body/, 'ArrowLeft', 'ArrowLeft');
  assert.ok(moved.initial.position[0] < before.initial.position[0] && moved.initial.position[1] === before.initial.position[1]);
  assert.ok((await key(/^turn/, 'ArrowRight')).initial.angle > 0);
  assert.ok((await key(/^velocity/, '+')).initial.spin > 0);
  assert.ok((await key(/^anchor of cable 1/, '+')).cables[1].length > 1.5);
  const last = await key(/^attachment of cable 0/, 'ArrowUp');
  assert.ok(last.cables[0].attachment[1] > 0);
  await page.waitForFunction((attachment) => location.hash.includes(attachment.join()), last.cables[0].attachment);
  const { state } = readState(new URL(page.url()).hash, shipped);
  assert.deepEqual(state.the_case, last);
  await page.waitForFunction(() => /impact/.test(document.getElementById('spoken').textContent));
});

check('a place that cannot be is refused in the words of the solver, and a hand that lets go there changes nothing', `${standard}&t=0`, async (page) => {
    const [x, y] = await middleOf(page, /^body/);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 6, y - 10, { steps: 2 });
    await page.waitForFunction(() => playground.motion.the_case.name.endsWith('changed'));
    await page.mouse.move(x, y + 150, { steps: 2 });
    await page.waitForFunction(() => playground.impossible);
    const told = await page.locator('#problem').textContent();
    const { toml } = await page.evaluate(() => ({ toml: JSON.stringify(playground.state.the_case) }));
    const folder = mkdtempSync(join(tmpdir(), 'tautline-playground-'));
    try {
      const the_case = JSON.parse(toml), bare = complete(the_case);
      const lines = [`name = "x"`, `duration = ${bare.duration}`, `gravity = [${bare.gravity}]`, '[body]', `mass = ${bare.body.mass}`, `inertia = ${bare.body.inertia}`,
        ...bare.cables.flatMap((one) => ['[[cables]]', `anchor = [${one.anchor}]`, `attachment = [${one.attachment}]`, `length = ${one.length}`, `restitution = ${one.restitution}`]),
        '[initial]', `position = [${bare.initial.position}]`, `velocity = [${bare.initial.velocity}]`];
      writeFileSync(join(folder, 'case.toml'), lines.join('\n'));
      assert.throws(() => execFileSync(program, ['solve', join(folder, 'case.toml')], { stdio: 'pipe' }), ({ stderr }) => {
        for (const sentence of told.split('; ')) assert.ok(String(stderr).replace(/\s+/g, ' ').includes(sentence), `${sentence}\n${stderr}`);
        return true;
      });
    } finally {
      rmSync(folder, { recursive: true });
    }
    await page.mouse.up();
    await page.waitForFunction(() => document.getElementById('problem').hidden); // what was possible may be solved already
    await solved(page);
    assert.ok((await caseNow(page)).initial.position[1] > 0.1);
  });

check('cables come and go, from one to eight, and a body becomes a point', 'case=bouncing-ball&t=0', async (page) => {
  await page.getByText('Every number').click();
  for (let count = 2; count <= 8; ++count) {
    await page.click('#add');
    await solved(page);
    assert.equal((await caseNow(page)).cables.length, count);
  }
  assert.equal(await page.locator('#add').isDisabled(), true);
  await page.click('#point');
  await solved(page);
  assert.equal((await caseNow(page)).body.inertia, 0);
  for (let count = 7; count >= 1; --count) {
    await page.getByRole('button', { name: 'Remove cable 0' }).click();
    await solved(page);
  }
  assert.equal((await caseNow(page)).cables.length, 1);
  assert.equal(await page.getByRole('button', { name: /^Remove cable/ }).count(), 0);
});

check('what leaves the page solves to the same motion elsewhere', 'case=level-beam&law=poisson&t=0', async (page) => {
  await page.locator('input[type=range][aria-label=restitution]').fill('0.5');
  await page.locator('input[type=range][aria-label=restitution]').dispatchEvent('change');
  await solved(page);
  await page.getByText('Take it with you').click();
  const form = async (name) => {
    await page.getByRole('radio', { name }).check({ force: true });
    return page.locator('#export').inputValue();
  };
  const rows = (await form('events')).trim().split('\n');
  const folder = mkdtempSync(join(tmpdir(), 'tautline-playground-'));
  try {
    // `tautline` of the command is the program
    writeFileSync(join(folder, 'command.sh'), `tautline() { "${program}" "$@"; }\n${(await form('command')).replace(/(--law poisson)$/m, '$1 --json -')}`);
    const { events } = JSON.parse(execFileSync('bash', ['command.sh'], { cwd: folder, encoding: 'utf8' }));
    assert.ok(events.length > 3);
    const state = ({ position, angle, velocity, spin }) => [...position, angle, ...velocity, spin].map(String);
    assert.deepEqual(rows.slice(1), events.map((one) => [one.time, one.kind, one.cables.join('+'), ...state(one.before), ...state(one.after),
      ...[0, 1].map((cable) => one.impulses[one.cables.indexOf(cable)] ?? 0)].join(',')));
    const vector = await form('test vector'), [, written] = /^# Run this: .* writes the vector to (.*)\n/.exec(vector);
    writeFileSync(join(folder, 'vector.sh'), `tautline() { "${program}" "$@"; }\n${vector}`);
    execFileSync('bash', ['vector.sh'], { cwd: folder });
    assert.equal(JSON.parse(readFileSync(join(folder, written), 'utf8')).format, 'tautline-vector-1');
  } finally {
    rmSync(folder, { recursive: true });
  }
  assert.match(await form('Python'), /^import tautline as tl; motion = tl\.solve\(tl\.Case\.from_json\("\{.*\}"\), law="poisson"\)\n$/);
  assert.match(await form('case file'), /restitution = 0\.5/);
});

check('the engine is the plug-in of the benchmark: its rope does not bounce, its impulse by hand does', 'case=bouncing-ball&rate=1000&t=0', async (page) => {
  const highest = async (model) => {
    await page.selectOption('#engine', `planck/${model}`);
    await page.waitForFunction((one) => playground.picture().run?.model === one, model);
    return page.evaluate(() => { // after the first impact
      const { run } = playground.picture();
      return Math.max(...Array.from({ length: 600 }, (_, i) => run.at(1.2 + 0.001 * i)[1]));
    });
  };
  const exact = await page.evaluate(() => Math.max(...Array.from({ length: 600 }, (_, i) => playground.motion.at(1.2 + 0.001 * i)[1])));
  assert.ok(Math.abs(await highest('rope-bounce') - exact) < 0.01, `${exact}`);
  assert.ok(await highest('rope') < exact - 0.05);
});

for (const [width, colorScheme] of [[1280, 'light'], [1280, 'dark'], [400, 'light'], [400, 'dark']]) {
  check(`${width} px, ${colorScheme}: axe finds nothing, and nothing has to be scrolled sideways`, `${standard}&t=3`, async (page) => {
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme });
    await page.evaluate(() => document.querySelectorAll('details').forEach((one) => { one.open = true; }));
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    await page.evaluate(axe);
    const found = await page.evaluate(() => axe.run(document, { resultTypes: ['violations'] }));
    assert.deepEqual(found.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 200)).join('\n')}`), []);
    const [paper, ink] = await page.evaluate(() => {
      const { backgroundColor, color } = getComputedStyle(document.documentElement);
      return [backgroundColor, color].map((one) => Number(/\d+/.exec(one)[0]));
    });
    assert.equal(paper < ink, colorScheme === 'dark');
  });
}

test('with less motion the page waits, and plays from event to event', () => onPage(standard, async (page) => {
  assert.equal(await page.evaluate(() => playground.state.time), 0);
  await page.click('#play');
  const times = [];
  for (let i = 0; i < 2; ++i) {
    await page.waitForFunction((before) => playground.state.time > before, times.at(-1) ?? 0);
    times.push(await page.evaluate(() => playground.state.time));
  }
  const events = await page.evaluate(() => playground.motion.moments.slice(0, 10));
  assert.deepEqual(times.filter((one) => !events.includes(one)), []);
}, { reducedMotion: 'reduce' }));

test('a finger drags and turns the body, and the page plays unless it is told to stay', () => onPage(standard, async (page) => {
  await page.waitForFunction(() => playground.state.time > 0);
  await page.click('#start');
  const touch = await page.context().newCDPSession(page);
  const swipe = async (name, dx, dy) => {
    const [x, y] = await middleOf(page, name);
    const at = (part) => [{ x: x + part * dx, y: y + part * dy }];
    await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(0) });
    for (const part of [0.3, 0.6, 1]) await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(part) });
    await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  };
  await swipe(/^turn/, -25, 0);
  await page.waitForFunction(() => playground.motion.the_case.initial.angle < -0.1);
  await swipe(/^body/, -12, -24); // Chromium takes less than 15 px for a tap
  await page.waitForFunction(() => {
    const [x, y] = playground.motion.the_case.initial.position;
    return x < 0.1 && y > 0.1;
  });
  assert.equal(await page.evaluate(() => scrollY), 0);
}, { width: 400, height: 800, hasTouch: true, isMobile: true }));

check('a drag is drawn and the fog is solved in time', `${standard}&t=0`, async (page) => {
  await page.setViewportSize({ width: 1280, height: 900 });
  await drawn(page);
  await page.evaluate(() => performance.clearMeasures());
  for (let i = 0; i < 6; ++i) { // the first ones are still being compiled
    await page.uncheck('#fog');
    await page.check('#fog');
    await drawn(page);
  }
  const fogs = await page.evaluate(() => performance.getEntriesByName('fog').slice(-3).map(({ duration }) => duration).sort((a, b) => a - b));
  const [x, y] = await middleOf(page, /^body/);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 30; ++i) {
    await page.mouse.move(x + 12 * Math.sin(i / 5), y - 8 + 8 * Math.cos(i / 5));
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }
  await page.mouse.up();
  await solved(page);
  const moves = await page.evaluate(() => performance.getEntriesByName('drag to picture').map(({ duration }) => duration).sort((a, b) => a - b));
  const middle = (all) => all[all.length >> 1];
  const said = `drag to picture: ${middle(moves).toFixed(1)} ms in the middle of ${moves.length}, ${moves.at(-1).toFixed(1)} ms at most; `
    + `fog: ${middle(fogs).toFixed(0)} ms in the middle of ${fogs.length}`;
  console.log(said);
  assert.ok(moves.length > 10 && fogs.length > 1, said);
  if (process.env.TAUTLINE_MEASURE) {
    assert.ok(middle(moves) <= drag && middle(fogs) <= fog, said);
  }
});

test('on one page', (t) => onPage('t=0', async (page, heard) => {
  for (const { name, address, action } of shared) {
    await t.test(name, async () => {
      for (const to of ['', address]) { // a link to where the page is does nothing
        await page.evaluate((hash) => new Promise((done) => {
          addEventListener('hashchange', done, { once: true });
          location.hash = hash;
        }), to);
      }
      await solved(page);
      await action(page, heard);
    });
  }
}));
