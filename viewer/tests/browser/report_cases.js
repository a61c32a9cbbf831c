// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a model: on paper, on a phone, without a network.
import assert from 'node:assert/strict';
import path from 'node:path';
import test from 'node:test';
import { pictures, run } from './pages.js';
import { browser, place } from './session.js';

test('a report prints: nothing is cut off, every picture is there', async () => {
  run('report', place, '--overwrite', '--no-validation');
  const context = await browser.newContext({ viewport: { width: 688, height: 1000 }, offline: true }); // A4 between its margins
  const tab = await context.newPage();
  const said = [];
  tab.on('console', (message) => said.push(message.text()));
  await tab.goto(`file://${place}/report.html`);
  await tab.emulateMedia({ media: 'print' });
  await tab.waitForFunction(() => [...document.images].every((image) => image.complete));
  const seen = await tab.evaluate(() => ({
    wide: document.documentElement.scrollWidth,
    broken: [...document.images].filter((image) => image.naturalWidth === 0).length,
    pictures: document.images.length,
    over: [...document.querySelectorAll('table')].filter((table) => table.getBoundingClientRect().right > 689).length,
  }));
  assert.ok(seen.pictures > 20, `${seen.pictures} pictures`);
  assert.deepEqual([seen.wide <= 688, seen.broken, seen.over], [true, 0, 0], JSON.stringify(seen));
  const paper = await tab.pdf({ format: 'A4' });
  const pages = paper.toString('latin1').match(/\/Type \/Page\b(?!s)/g).length;
  assert.ok(pages >= 4 && pages <= 25, `${pages} pages`);
  await tab.screenshot({ path: path.join(pictures, 'report_print.png'), clip: { x: 0, y: 0, width: 688, height: 1800 }, fullPage: true });
  await tab.emulateMedia({ media: 'screen' });
  await tab.setViewportSize({ width: 390, height: 844 });
  assert.equal(await tab.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(said, []);
  await context.close();
});
