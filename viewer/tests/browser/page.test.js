// SPDX-License-Identifier: GPL-3.0-or-later
// The page as a reader has it: each control changes what is drawn as it should.
import assert from 'node:assert/strict';
import test from 'node:test';
import { keep, page } from './session.js';
import './cut_cases.js';
import './pointer_cases.js';
import './control_cases.js';
import './motion_cases.js';
import './thin_cases.js';
import './device_cases.js';
import './report_cases.js';

test('opens from disk without a network, says nothing in the console, names all layers', async () => {
  assert.deepEqual(page.asked.filter((url) => !url.startsWith('file://') && !url.startsWith('data:') && !url.startsWith('blob:')), []);
  assert.equal(page.asked.filter((url) => url.startsWith('file://')).length, 1);
  assert.deepEqual(page.said, []);
  assert.equal(await page.title(), 'sighthill');
  const names = await page.locator('.legend .name').allTextContents();
  assert.equal(names.length, 7);
  assert.ok(names.includes('made_ground'));
  assert.ok((await page.evaluate(() => window.look.covered())) > 0.1);
  await keep('sighthill');
});

test('nothing is drawn while nothing changes', async () => {
  await page.waitForTimeout(300);
  const frames = () => page.evaluate(() => window.stratareeb.stage.frames);
  const first = await frames();
  await page.waitForTimeout(500);
  assert.equal(await frames(), first);
});
