import assert from 'node:assert/strict';
import test from 'node:test';
import { replay } from './replay.mjs';

/// Seconds of the page's clock for which each speed is played.
const played = 2;

// the clock of the page is the test's: how fast the machine is has no part in it. It stands still between two plays, so
// that each begins in the frame in which the one before was paused
test('the speed is obeyed, also by a play right after a pause', () => replay(async ({ page, time }) => {
  await page.clock.install({ time: 0 });
  await page.clock.pauseAt(1000);
  const advance = async (speed) => {
    await page.getByLabel('Speed').selectOption(speed);
    await page.focus('.replay-canvas + input');
    await page.keyboard.press('Home');
    await page.click('#replay-play');
    await page.clock.runFor(1000 * played);
    const reached = await time();
    await page.click('#replay-play');
    return reached / played;
  };
  for (const speed of ['0.25', '1', '4']) {
    const rate = await advance(speed);
    // the first frame of a play tells only when it began, and the slider has steps
    assert.ok(Math.abs(rate / Number(speed) - 1) < 0.05, `${rate} s/s, ${speed} asked for`);
  }
}));
