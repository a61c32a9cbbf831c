// SPDX-License-Identifier: GPL-3.0-or-later
// The panel with all controls.
import { cutNormal, spanAlong } from './cut.js';
import { kPalettes } from './palette.js';
import { opacityOf } from './settings.js';
import { button, h, section } from './ui.js';
import { kOthers, slabText, volumeText } from './words.js';

const without = (list, item) => list.filter((other) => other !== item);

/** Own opacities with one of them changed. */
function withOpacity(faint, layer, value) {
  const rest = [];
  for (let i = 0; i < faint.length; i += 2) if (faint[i] !== layer) rest.push(faint[i], faint[i + 1]);
  return value === null ? rest : [...rest, layer, value];
}

function layerRow({ app, bindings, settings }, unit, i) {
  const box = h('input', { type: 'checkbox', id: `layer-${i}`, 'aria-label': `show ${unit.name}` });
  box.addEventListener('change', () => {
    const { hidden } = settings.values;
    settings.set({ hidden: box.checked ? without(hidden, i) : [...hidden, i].sort((a, b) => a - b) });
  });
  const swatch = h('span', { class: 'swatch' });
  const faint = h('input', { type: 'range', min: '0.05', max: '1', step: '0.05', id: `opacity-${i}`, 'aria-label': `opacity of ${unit.name}` });
  faint.addEventListener('input', () => settings.set({ faint: withOpacity(settings.values.faint, i, Number(faint.value)) }));
  const only = button('only', `show only ${unit.name}`, () => {
    const others = app.units.map((_, k) => k).filter((k) => k !== i);
    const isAlone = settings.values.hidden.join() === others.join();
    settings.set({ hidden: isAlone ? [] : others });
  }, { class: 'quiet' });
  const row = h('li', { class: 'layer' },
    h('label', {}, box, swatch, h('span', { class: 'name', title: unit.name }, unit.name)),
    h('span', { class: 'fact' }, app.isPresent(i) ? volumeText(app, unit) : 'absent'), only, faint);
  bindings.follow((values) => {
    box.checked = !values.hidden.includes(i);
    swatch.style.background = app.colors[i];
    faint.value = String(opacityOf({ ...values, hidden: [] }, i));
    row.classList.toggle('off', !box.checked);
  });
  return row;
}

function layersSection(context) {
  const { app, bindings, settings } = context;
  const log = (low, high) => ({ // a slider over powers
    shown: (s) => low * (high / low) ** s,
    meant: (n) => Math.log(n / low) / Math.log(high / low),
  });
  const exaggeration = log(0.1, 100);
  return section('layers', 'Layers', true,
    h('ol', { class: 'legend' }, ...app.units.map((unit, i) => layerRow(context, unit, i))),
    h('div', { class: 'row buttons' },
      button('All', 'show all layers', () => settings.set({ hidden: [] })),
      button('None', 'hide all layers', () => settings.set({ hidden: app.units.map((_, i) => i) }))),
    bindings.slider('opacity', 'Opacity', { read: (v) => v.opacity, write: (opacity) => ({ opacity, faint: [] }), step: 0.05 }),
    bindings.slider('exaggeration', 'Heights ×', {
      ...exaggeration,
      read: (v) => exaggeration.meant(v.exaggeration),
      write: (s) => ({ exaggeration: Number(exaggeration.shown(s).toPrecision(3)) }),
      digits: 2,
    }),
    bindings.slider('explode', 'Pull apart', { read: (v) => v.explode / 2, write: (s) => ({ explode: Number((2 * s).toFixed(3)) }), shown: (s) => 2 * s, meant: (n) => n / 2 }));
}

function lookSection({ app, bindings }) {
  return section('look', 'Look', false,
    bindings.choice('palette', 'Colours', kPalettes),
    bindings.check('smooth', 'Smooth shading', 'with normals averaged over the triangles around a vertex; otherwise each triangle is flat'),
    bindings.check('edges', 'Edges of the mesh'),
    bindings.check('frame', 'Frame with coordinates'),
    bindings.choice('theme', 'Background', { auto: 'as the system', light: 'light', dark: 'dark' }),
    h('p', { class: 'note' }, app.sizeText));
}

function holesSection({ app, bindings, settings }) {
  const pick = h('select', { id: 'set-hole', onchange: () => settings.set({ hole: Number(pick.value) }) }, h('option', { value: '-1' }, 'none'));
  app.holes.forEach((hole, i) => pick.append(h('option', { value: String(i) }, hole.id)));
  bindings.follow((values) => (pick.value = String(values.hole)));
  return section('holes', `Boreholes (${app.holes.length})`, false,
    bindings.check('holes', 'Show as columns'),
    bindings.check('holesCut', 'Cut with the model'),
    bindings.slider('holeSize', 'Width', { read: (v) => Math.log10(v.holeSize * 10) / 2, write: (s) => ({ holeSize: Number((10 ** (2 * s - 1)).toPrecision(3)) }), shown: (s) => 10 ** (2 * s - 1), meant: (n) => Math.log10(n * 10) / 2 }),
    h('label', { class: 'row' }, h('span', {}, 'Log of'), pick));
}

/** Slider and field for where the plane is: the field has a map coordinate, or the distance from the middle. */
function positionSlider({ app, bindings }) {
  const range = (values) => {
    const n = cutNormal(values);
    const [least, most] = spanAlong(n, app.box);
    const axis = { x: 0, y: 1, z: 2 }[values.cut];
    return { least, size: most - least || 1, datum: axis === undefined ? 0 : app.datum[axis] };
  };
  const now = () => range(bindings.settings.values);
  return bindings.slider('cutAt', 'Position', {
    read: (v) => v.cutAt,
    write: (cutAt) => ({ cutAt }),
    shown: (s) => now().least + s * now().size + now().datum,
    meant: (number) => (number - now().datum - now().least) / now().size,
    unit: app.lengthUnit,
  });
}

function blockSliders({ app, bindings, settings }) {
  const names = ['x from', 'x to', 'y from', 'y to', 'z from', 'z to'];
  return names.map((name, i) => {
    const k = Math.floor(i / 2);
    const [low, high] = [app.box.low[k] + app.datum[k], app.box.high[k] + app.datum[k]];
    return bindings.slider(`block-${i}`, name, {
      read: (v) => v.blockShares[i],
      write: (share) => ({ blockShares: ordered(replaced(settings.values.blockShares, i, share), i) }),
      shown: (s) => low + s * (high - low),
      meant: (n) => (n - low) / (high - low || 1),
      unit: app.lengthUnit,
    });
  });
}

const replaced = (list, i, value) => list.map((old, k) => (k === i ? value : old));

/** The other end gives way when one end passes it. */
function ordered(shares, i) {
  const other = i ^ 1;
  const isLow = i % 2 === 0;
  const wrong = isLow ? shares[other] < shares[i] : shares[other] > shares[i];
  return wrong ? replaced(shares, other, shares[i]) : shares;
}

function cutSection(context) {
  const { bindings, settings } = context;
  const plane = h('div', {}, positionSlider(context),
    bindings.check('cutFlip', 'Show the other side'));
  const turned = h('div', {}, bindings.number('azimuth', 'Azimuth', { min: -360, max: 360, unit: '°' }), bindings.number('dip', 'Dip', { min: 0, max: 90, unit: '°' }));
  const block = h('div', {}, ...blockSliders(context));
  const slabName = h('output', { class: 'note', id: 'slab-range' });
  bindings.follow((values) => {
    plane.hidden = values.cut === 'off';
    turned.hidden = values.cut !== 'azimuth';
    block.hidden = values.block === 'off';
    slabName.textContent = slabText(context.app, values);
  });
  return section('cut', 'Cut', true,
    bindings.segments('cut', 'Plane', { off: 'off', x: 'x', y: 'y', z: 'z', azimuth: 'any' }), turned, plane,
    bindings.segments('block', 'Block', { off: 'off', keep: 'keep', remove: 'take out' }), block,
    bindings.slider('slab', 'Slab', {
      read: (v) => v.slab / v.slabs,
      write: (s) => ({ slab: Math.round(s * settings.values.slabs) }),
      shown: (s) => Math.round(s * settings.values.slabs),
      meant: (n) => n / settings.values.slabs,
      digits: 0,
    }),
    bindings.number('slabs', 'of', { min: 1, max: 200 }), slabName);
}

function contoursSection({ app, bindings }) {
  const surfaces = { off: 'none', solids: 'all over the layers', 0: 'the ground' };
  app.units.forEach((unit, i) => (surfaces[i + 1] = `base of ${unit.name}`));
  return section('contours', 'Contours', bindings.settings.get('contours') !== 'off',
    bindings.choice('contours', 'On', surfaces),
    bindings.number('interval', 'Every', { min: 0, unit: app.lengthUnit, placeholder: 'auto' }),
    bindings.number('level', 'Or only at z', { unit: app.lengthUnit, text: true, placeholder: 'all' }));
}

function reebSection({ app, bindings }) {
  const graphs = { off: 'none', layered: 'all layers together' };
  app.units.forEach((unit, i) => {
    if (app.isPresent(i)) graphs[i] = unit.name;
  });
  const place = h('div', { class: 'diagram' });
  const note = h('p', { class: 'note', id: 'graph-note' });
  app.onGraph((diagram, text) => {
    place.replaceChildren(...(diagram ? [diagram] : []));
    note.textContent = text;
  });
  return section('reeb', 'Reeb graph', bindings.settings.get('reeb') !== 'off', bindings.choice('reeb', 'Of', graphs), place, note);
}

function compareSection({ app, bindings }) {
  if (app.comparable.length === 0) return section('compare', 'Raw beside smooth', false, h('p', { class: 'note' }, 'There is nothing to compare the model with.'));
  const options = { off: 'nothing', ...Object.fromEntries(app.comparable.map((key) => [key, kOthers[key].title])) };
  const note = h('p', { class: 'note' });
  bindings.follow(({ compare }) => {
    note.textContent = kOthers[compare] ? `${kOthers[compare].note} Right: the model. Both move and are cut alike.` : 'Both sides move and are cut alike.';
  });
  return section('compare', 'Raw beside smooth', bindings.settings.get('compare') !== 'off', bindings.choice('compare', 'Left', options), note);
}

function outputSection({ app, settings }) {
  const said = h('p', { class: 'note', role: 'status' });
  const report = app.report ? h('a', { href: app.report, class: 'button' }, 'Report') : null;
  return section('output', 'Picture and link', false,
    h('div', { class: 'row buttons' },
      button('Save picture', 'save a PNG with the legend (S)', () => app.savePicture()),
      button('Copy link', 'the address of this very view', async () => (said.textContent = await app.copyLink())),
      button('Reset', 'everything as at the start', () => settings.reset()), report), said);
}

/** All sections of the panel. */
export function panel(app, bindings) {
  const context = { app, bindings, settings: bindings.settings };
  return [layersSection, cutSection, holesSection, contoursSection, reebSection, compareSection, lookSection, outputSection].map((make) => make(context));
}
