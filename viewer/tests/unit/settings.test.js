// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { layerColors } from '../../src/palette.js';
import { Settings, fromFragment, kDefaults, opacityOf, toFragment } from '../../src/settings.js';

test('an address holds what differs, and gives it back', () => {
  const settings = { ...kDefaults, hidden: [1, 4], cut: 'azimuth', azimuth: 33.5, cutFlip: true, smooth: false, reeb: '2', picked: 'a3', level: '-12.5', camera: [1, 2, 3, 4.5, 5, 6, 1], faint: [2, 0.4] };
  const fragment = toFragment(settings);
  assert.deepEqual({ ...kDefaults, ...fromFragment(`#${fragment}`) }, settings);
  assert.equal(toFragment(kDefaults), '');
});

test('nonsense in an address is left out', () => {
  assert.deepEqual(fromFragment('#cut=sideways&cutAt=NaN&explode=a&__proto__=1&unknown=3&blockShares=1,2&camera=1,x'), {});
  assert.deepEqual(fromFragment('#cutAt=7&opacity=-3&theme=dark'), { cutAt: 1, opacity: 0, theme: 'dark' });
});

test('listeners hear of what changed, once', () => {
  const settings = new Settings({ exaggeration: 5 });
  const heard = [];
  settings.onChange((_, changed) => heard.push([...changed].sort().join()));
  settings.set({ cut: 'x', cutAt: 0.5 });
  settings.set({ cut: 'x' });
  settings.set({ cutAt: 0.25, explode: 1 });
  settings.reset();
  assert.deepEqual(heard, ['cut', 'cutAt,explode', 'cut,cutAt,explode']);
  assert.equal(settings.get('exaggeration'), 5);
});

test('a layer has its own opacity, or everybody’s, or none', () => {
  const settings = { ...kDefaults, opacity: 0.7, faint: [2, 0.3], hidden: [1] };
  assert.deepEqual([0, 1, 2].map((i) => opacityOf(settings, i)), [0.7, 0, 0.3]);
});

test('palettes give each unit a colour, wrong ones in the model are replaced', () => {
  const units = Array.from({ length: 30 }, () => ({ color: 'red" onload="x' }));
  for (const palette of ['model', 'safe', 'ordered']) {
    const colors = layerColors(units, palette);
    assert.ok(colors.every((color) => /^#[0-9a-f]{6}$/.test(color)));
    if (palette === 'ordered') assert.equal(new Set(colors).size, 30);
  }
});
