// SPDX-License-Identifier: GPL-3.0-or-later
// One browser with the page of Sighthill, for all cases.
import path from 'node:path';
import { after, before } from 'node:test';
import { launch, modelFolder, openPage, pictures } from './pages.js';

export let browser;
export let place; // the model's folder
export let page;

before(async () => {
  place = modelFolder('sighthill');
  browser = await launch();
  page = await openPage(browser, place);
});
after(() => browser?.close());

export const set = (changes) => page.evaluate((c) => window.stratareeb.settings.set(c), changes);
export const reset = (view = 'oblique') =>
  page.evaluate((v) => {
    window.stratareeb.settings.reset();
    window.stratareeb.stage.show(v);
  }, view);
export const values = () => page.evaluate(() => window.stratareeb.settings.values);
export const picture = () => page.evaluate(() => window.look.picture());
export const keep = (name) => page.screenshot({ path: path.join(pictures, `${name}.png`) });
export const open = (id) => page.evaluate((i) => (document.getElementById(`section-${i}`).open = true), id);
