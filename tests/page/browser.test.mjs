// The browser tests' own: a browser that stops answering ends no test, and a page that never answers does.
import { test } from 'node:test';
import assert from 'node:assert/strict';
import { onSharedPage, withText } from './browser.mjs';

const small = '<!DOCTYPE html><title>small</title>';
/// Long enough for it to open on a busy machine [ms].
const limit = 10_000;
const silent = (page) => page.evaluate(() => new Promise(() => {}));

test('what is done with a page begins anew in another browser when one does not answer', async () => {
  const browsers = [];
  const answer = await withText(small, async ({ page }) => {
    browsers.push(page.context().browser());
    return browsers.length === 1 ? silent(page) : page.title();
  }, { limit });
  assert.equal(answer, 'small');
  assert.notEqual(browsers[0], browsers[1]);
  // and the shared page is of the new one
  assert.equal(await onSharedPage(({ page }) => page.context().browser()), browsers[1]);
});

test('a page that never answers fails, with how long was waited', async () => {
  let times = 0;
  await assert.rejects(withText(small, ({ page }) => { times += 1; return silent(page); }, { limit }),
    /the browser has not answered for 10 s/);
  assert.equal(times, 2);
});

test('what is wrong in a page fails at once', async () => {
  let times = 0;
  await assert.rejects(withText(small, () => { times += 1; assert.fail('wrong'); }, { limit }), /wrong/);
  assert.equal(times, 1);
});
