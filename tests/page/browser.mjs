// What the browser tests share: Debian's Chromium, and a page opened from disk with all it said and
// all it asked for written down.
import { after } from 'node:test';
import { chromium } from 'playwright-core';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const program = process.env.TAUTLINE_CHROMIUM || '/usr/bin/chromium';

/// How long anything is waited for [ms]: a busy machine is no defect of the page, and what never comes
/// fails as well after two minutes as after Playwright's thirty seconds.
const patience = 120_000;
/// How long all that is done with one page may take [ms]: the slowest needs ten seconds, sixty on a busy machine.
const longest = 5 * patience;

/// Root may not use Chromium's sandbox, and a container's /dev/shm is too small for it.
const options = { executablePath: program, timeout: patience,
  args: ['--disable-dev-shm-usage', ...(process.getuid() === 0 ? ['--no-sandbox'] : [])] };

/// The page that `tautline bench` wrote for these tests.
export const benchPage = () => {
  if (!process.env.TAUTLINE_PAGE) {
    throw new Error('set TAUTLINE_PAGE to an index.html that `tautline bench` wrote');
  }
  return process.env.TAUTLINE_PAGE;
};

/// Every page with charts that these tests have: the report and, if it was made, the chapter.
export const pages = () => [benchPage(), process.env.TAUTLINE_CHAPTER_PAGE].filter(Boolean);
/// The pages whose figures the program drew: an ensemble with an engine, one with an atlas, a trend.
export const drawnPages = () => (process.env.TAUTLINE_DRAWN_PAGES ?? '').split(':').filter(Boolean);

export const reportOf = (file) => JSON.parse(
  /<script type="application\/json" id="report-data">([^<]*)/.exec(readFileSync(file, 'utf8'))[1]);

/// One browser for all tests of a process: to start one costs as much as a test.
let browser = null;
const theBrowser = () => (browser ??= chromium.launch(options));
/// What is no test has to call it at its end, or its process stays.
export const closeBrowser = async () => (await browser)?.close();
after(closeBrowser);

/// Nothing came back from the browser in time: Playwright's `evaluate` waits for ever by itself.
class Silence extends Error {}

async function within(limit, promise) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Silence(`the browser has not answered for ${limit / 1000} s`)), limit);
  });
  try {
    return await Promise.race([promise, late]);
  } finally {
    clearTimeout(timer);
  }
}

/// `use` of the browser, in less than `limit` [ms]. Rarely Chromium stops answering for good; it is left then,
/// and `use` begins anew in another one: a page that is to blame is silent there, too, and fails. What `use`
/// asserts is not tried again.
async function inBrowser(use, limit) {
  try {
    return await inThisBrowser(use, limit);
  } catch (error) {
    if (!(error instanceof Silence)) {
      throw error;
    }
    console.error(`${error.message}: begun anew in another one`);
    return inThisBrowser(use, limit);
  }
}
/// The same, once; a browser that is silent is left.
async function inThisBrowser(use, limit) {
  try {
    return await within(limit, use(await theBrowser()));
  } catch (error) {
    if (error instanceof Silence) {
      browser.then((silent) => silent.close()).catch(() => {});
      [browser, shared] = [null, null];
    }
    throw error;
  }
}

/// Opens `file` in a context of its own and passes {page, said, asked, dialogs, opening} to `action`; the last is
/// what opening took, as Chromium's metrics: TaskDuration is the page's processor time [s]. All of it takes less than
/// `limit` [ms]; `context` is Playwright's options of a context.
export const withPage = (file, action, { limit = longest, ...context } = {}) =>
  inBrowser((browser) => withPageOf(browser, file, action, context), limit);
async function withPageOf(browser, file, action, context) {
  const { view, page, said } = await blankPage(browser, context);
  try {
    const [asked, dialogs] = [[], []];
    page.on('request', (request) => asked.push(request.url()));
    page.on('dialog', (dialog) => { dialogs.push(dialog.message()); dialog.dismiss(); });
    const meter = await view.newCDPSession(page);
    await meter.send('Performance.enable', { timeDomain: 'threadTicks' });
    await page.goto(pathToFileURL(file).href);
    const { metrics } = await meter.send('Performance.getMetrics');
    const opening = Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
    return await action({ page, said, asked, dialogs, opening });
  } finally {
    await view.close();
  }
}

/// An empty page in a context of its own, and the errors and warnings that it will have said.
async function blankPage(browser, { width = 1280, height = 900, ...context } = {}) {
  const view = await browser.newContext({ viewport: { width, height }, ...context });
  view.setDefaultTimeout(patience);
  const page = await view.newPage();
  const said = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && said.push(message.text()));
  page.on('pageerror', (error) => said.push(error.stack));
  return { view, page, said };
}

/// The same for a page given as text.
export async function withText(text, action, context) {
  const folder = mkdtempSync(join(tmpdir(), 'tautline-page-'));
  const file = join(folder, 'index.html');
  try {
    writeFileSync(file, text);
    return await withPage(file, action, context);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/// The page that all tests of a process share, at 1280 px: a test that needs another one, or leaves
/// it in another state than its address says, opens its own.
let shared = null;
export const onSharedPage = (action) => inBrowser(async (browser) => {
  shared ??= await openShared(browser);
  await shared.page.evaluate(() => { location.hash = ''; });
  return action(shared);
}, longest);
async function openShared(browser) {
  const { page, said } = await blankPage(browser);
  await page.goto(pathToFileURL(benchPage()).href);
  await drawAll(page);
  return { page, said };
}

/// Lets the page do what is due: two frames, and its timers of less than `time` [ms], which run before one of `time`.
export const settled = (page, time = 60) => page.evaluate((wait) => new Promise((done) =>
  requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, wait)))), time);

/// Draws every chart, without scrolling through the page.
export async function drawAll(page) {
  await page.evaluate(async () => {
    document.querySelector('#replay-app')?.scrollIntoView();
    await Promise.all(Object.values(tautline.charts).map((one) => one.show()));
  });
  await page.waitForFunction(() => Object.values(tautline.charts).every((one) =>
    one.body.hidden || one.body.classList.contains('js-plotly-plot')));
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
