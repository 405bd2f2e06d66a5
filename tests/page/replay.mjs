// The page at its replay, for the tests of it.
import assert from 'node:assert/strict';
import { benchPage, withPage } from './browser.mjs';

/// The motions of the runs have come, or it is said why not.
export async function settled(page) {
  await page.locator('#replay-app').scrollIntoViewIfNeeded();
  await page.locator('.replay-status:not(:empty)').waitFor();
  await page.locator('.replay-note:not(:empty)').waitFor();
  await page.waitForFunction(() => !/being loaded/.test(document.querySelector('.replay-note').textContent));
}

/// Opens the page at its replay; `time` reads the time shown [s].
export const replay = (action, context) => withPage(benchPage(), async ({ page, said }) => {
  await settled(page);
  const slider = page.locator('#replay-app input[type=range]');
  const time = async () => Number(await slider.inputValue());
  await action({ page, slider, time });
  assert.deepEqual(said, []);
}, context);
