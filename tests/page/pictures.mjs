// Writes the charts of a page as files: see scripts/pictures.
import { statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, withPage } from './browser.mjs';

const [file, folder] = process.argv.slice(2);
const charts = { 'error-step': 'chart-step', 'error-cost': 'chart-cost', attribution: 'chart-attribution',
  restitution: 'chart-restitution' };
const size = [960, 600];

const written = (path) => console.log(`${path} (${Math.round(statSync(path).size / 1000)} kB)`);

function decoded(url) {
  const [head, body] = [url.slice(0, url.indexOf(',')), url.slice(url.indexOf(',') + 1)];
  return head.endsWith('base64') ? Buffer.from(body, 'base64') : Buffer.from(decodeURIComponent(body));
}

let failures = 0;
await withPage(file, async ({ page }) => {
  const top = join(folder, 'report.png');
  await page.screenshot({ path: top });
  written(top);
  for (const [name, id] of Object.entries(charts)) {
    for (const format of ['svg', 'png']) {
      try {
        const url = await page.evaluate(([chart, kind, width, height]) => {
          const one = window.tautline && tautline.charts[chart];
          if (!one || !one.picture) {
            throw new Error(`the page has no ${chart}: the report has nothing for it, or the program no Plotly`);
          }
          return one.picture(kind, width, height);
        }, [id, format, ...size]);
        const path = join(folder, `${name}.${format}`);
        writeFileSync(path, decoded(url));
        written(path);
      } catch (error) {
        failures += 1;
        console.error(`pictures: ${name}.${format} is left out: ${error.message.split('\n')[0]}`);
      }
    }
  }
}, { width: 1440, height: 1000, colorScheme: 'light' });
await closeBrowser();
if (failures === 2 * Object.keys(charts).length) {
  process.exit(1);
}
