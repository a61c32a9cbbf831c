// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a 3D page for the docs: `node viewer/draw.js PAGE.html FRAGMENT OUT.png [WIDTHxHEIGHT]`, after `npm ci` in viewer/.
// FRAGMENT is the address's, say 'cut=y&cutAt=0.4&hole=3'; Chromium draws it without a graphics card.
import path from 'node:path';
import { chromium } from 'playwright-core';

const [page, fragment, out, size = '1280x800'] = process.argv.slice(2);
if (!out) {
  console.error("usage: node viewer/draw.js PAGE.html FRAGMENT OUT.png [WIDTHxHEIGHT]");
  process.exit(2);
}
const [width, height] = size.split('x').map(Number);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
const tab = await browser.newPage({ viewport: { width, height }, offline: true, colorScheme: 'light' });
await tab.goto(`file://${path.resolve(page)}#${fragment.replace(/^#/, '')}`);
await tab.waitForSelector('#app[aria-busy=false]');
await tab.evaluate(() => window.stratareeb.stage.draw());
await tab.screenshot({ path: out });
await browser.close();
