// Held against the clock: nothing else may run.
import assert from 'node:assert/strict';
import test from 'node:test';
import { replay } from './replay.mjs';

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
