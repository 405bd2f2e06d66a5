import assert from 'node:assert/strict';
import { basename } from 'node:path';
import test from 'node:test';
import { benchPage, drawAll, pages, withPage } from './browser.mjs';

/// The least contrast of text, by WCAG 2 (level AA).
const leastContrast = 4.5;

const each = (list) => pages().flatMap((file) => list.map((one) => [file, basename(file), one]));

for (const [file, name, width] of each([400, 1024, 1600])) {
  test(`${name} at ${width} px: nothing makes the page scroll sideways, and no chart is cut`, async () => {
    await withPage(file, async ({ page }) => {
      await drawAll(page);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width);
      const cut = await page.evaluate(() => Object.entries(tautline.charts).filter(([, { body, element }]) =>
        !body.hidden && body.querySelector('.main-svg').getBoundingClientRect().right
          > element.getBoundingClientRect().right + 1).map(([id]) => id));
      assert.deepEqual(cut, []);
    }, { width });
  });
}

for (const width of [400, 800]) {
  test(`at ${width} px the verdict on each model is on the screen, and the caption above it`, async () => {
    await withPage(benchPage(), async ({ page }) => {
      const edges = await page.evaluate(() => [...document.querySelectorAll('#scorecards-table :is(caption, th[scope="row"], th[data-key="verdict"], td.verdict)')]
        .map((cell) => cell.getBoundingClientRect()).filter((box) => box.width > 0).map((box) => [box.left, box.right]));
      assert.ok(edges.length > 4);
      assert.deepEqual(edges.filter(([left, right]) => left < 0 || right > width), []);
      const order = await page.evaluate(() => [...document.querySelectorAll('#scorecards-table thead th')]
        .sort((a, b) => a.getBoundingClientRect().left - b.getBoundingClientRect().left).map((cell) => cell.dataset.key));
      assert.deepEqual(order.slice(0, 3), ['engine', 'model', 'verdict']);
    }, { width });
  });
}

/// Texts of the page, of the charts too, with less contrast than `least` against what is behind them.
function pale(least) {
  const channel = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
  const brush = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  const rgba = (colour) => {
    brush.clearRect(0, 0, 1, 1);
    brush.fillStyle = colour;
    brush.fillRect(0, 0, 1, 1);
    return [...brush.getImageData(0, 0, 1, 1).data].map((value) => value / 255);
  };
  const luminance = (colour) => {
    const [r, g, b] = colour.map(channel);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const colour = rgba(getComputedStyle(at).backgroundColor);
      if (colour[3] > 0.99) {
        return colour;
      }
    }
    return [1, 1, 1, 1];
  };
  const bad = new Map();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    if (!walker.currentNode.textContent.trim() || !element.checkVisibility({ opacityProperty: true })
        || ['SCRIPT', 'STYLE'].includes(element.tagName)) {
      continue;
    }
    const style = getComputedStyle(element);
    const inside = element instanceof SVGElement;
    const text = rgba(inside ? style.fill : style.color);
    const [a, b] = [luminance(text.slice(0, 3)), luminance(behind(element).slice(0, 3))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < least) {
      bad.set(`${element.tagName}.${element.getAttribute('class')} ${style.color}`, contrast.toFixed(2));
    }
  }
  return [...bad].slice(0, 20).map((one) => one.join(': '));
}

for (const [file, name, colorScheme] of each(['light', 'dark'])) {
  test(`${name}: every text has a contrast of ${leastContrast} in the ${colorScheme} scheme, in charts too, and curves one of 3`, async () => {
    await withPage(file, async ({ page }) => {
      await drawAll(page);
      assert.deepEqual(await page.evaluate(pale, leastContrast), []);
      const weak = await page.evaluate(() => {
        const channel = (hex, at) => {
          const value = parseInt(hex.slice(at, at + 2), 16) / 255;
          return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
        };
        const luminance = (hex) => 0.2126 * channel(hex, 1) + 0.7152 * channel(hex, 3) + 0.0722 * channel(hex, 5);
        const { paper, engines, muted, ink, flag } = tautline.theme();
        const ratio = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        return [...engines, muted, ink, flag].filter((one) => ratio(luminance(one), luminance(paper)) < 3);
      });
      assert.deepEqual(weak, []);
    }, { colorScheme });
  });
}
