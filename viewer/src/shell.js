// SPDX-License-Identifier: GPL-3.0-or-later
// The page around the drawing: title, tools, panel, status line, cards, keys.
import { holeLog } from './log_card.js';
import { panel } from './panel.js';
import { button, h } from './ui.js';
import { wordsFor } from './words.js';

const kKeys = [
  ['1 … 9', 'show or hide a layer'],
  ['T, N, E, S, W', 'look from above, north, east, south, west'],
  ['O, F', 'oblique view, fit'],
  ['P', 'perspective or parallel'],
  ['R', 'turn around'],
  ['X, Y, Z', 'cut across x, y, z; again: no cut'],
  ['← →', 'move the cut'],
  ['+ −', 'heights'],
  ['B', 'boreholes'],
  ['C', 'contours over the layers'],
  ['M', 'measure'],
  ['Shift+S', 'save a picture'],
  ['Esc', 'close, stop'],
];

/** Elements of the page; `canvas` and overlay places for the stage. */
export function makeShell(title, facts) {
  const canvas = h('canvas', { tabindex: '0', 'aria-label': 'the model in 3D' });
  const left = h('span', {});
  const overlay = {
    left,
    ticks: h('div', { class: 'overlay ticks' }),
    knobs: h('div', { class: 'overlay knobs' }),
    labels: h('div', { class: 'overlay' }),
    halves: h('div', { class: 'halves', hidden: true }, left, h('span', {}, 'model')),
  };
  const parts = {
    tools: h('nav', { class: 'tools', 'aria-label': 'views' }),
    compass: h('div', { class: 'compass', 'aria-hidden': 'true' }),
    status: h('p', { class: 'status', 'aria-live': 'off' }),
    card: h('aside', { class: 'card log', hidden: true, 'aria-label': 'log' }),
    help: h('aside', { class: 'card help', hidden: true, 'aria-label': 'keys' }),
    panel: h('aside', { class: 'panel', 'aria-label': 'controls' }),
  };
  const grip = h('button', { type: 'button', class: 'grip', 'aria-label': 'open or close the controls', 'aria-expanded': 'false' }, h('span', {}));
  const side = h('div', { class: 'side' }, grip, h('header', {}, h('h1', {}, title), h('p', { class: 'note' }, facts)), parts.panel);
  grip.addEventListener('click', () => grip.setAttribute('aria-expanded', String(side.classList.toggle('open'))));
  const view = h('main', { class: 'view' }, canvas, overlay.ticks, overlay.halves, overlay.knobs, overlay.labels, parts.tools, parts.compass, parts.help, parts.status);
  return { canvas, overlay, parts, view, side };
}

function fillTools(app, tools) {
  const { stage, settings } = app;
  const look = (view) => () => stage.show(view);
  const turn = button('⟳', 'turn around (R)', () => toggleTurning(app));
  const measure = button('↔', 'measure a distance (M)', () => toggleMeasuring(app));
  const parallel = button('▱', 'perspective or parallel (P)', () => settings.set({ orthographic: !settings.values.orthographic }));
  tools.append(
    button('⌂', 'oblique view (O)', look('oblique')),
    button('⊤', 'from above (T)', look('top')),
    ...['north', 'east', 'south', 'west'].map((side) => button(side[0].toUpperCase(), `from the ${side} (${side[0].toUpperCase()})`, look(side))),
    button('⤢', 'fit (F)', look(null)), parallel, turn, measure,
    button('?', 'keys', () => (app.parts.help.hidden = !app.parts.help.hidden)));
  app.buttons = { turn, measure };
  settings.onChange((values) => parallel.setAttribute('aria-pressed', String(values.orthographic)));
}

function toggleTurning(app) {
  app.stage.setTurning(!app.stage.turning);
  app.buttons.turn.setAttribute('aria-pressed', String(app.stage.turning));
}

function toggleMeasuring(app, on = !app.pointer.measuring) {
  app.pointer.setMeasuring(on);
  app.buttons.measure.setAttribute('aria-pressed', String(on));
}

function fillHelp(help) {
  const close = button('×', 'close', () => (help.hidden = true), { class: 'close' });
  const rows = kKeys.flatMap(([keys, what]) => [h('dt', {}, keys), h('dd', {}, what)]);
  help.append(close, h('h2', {}, 'Keys'), h('dl', {}, ...rows), h('p', { class: 'note' }, 'Drag turns, right button or two fingers move, wheel or pinch zooms. Click a borehole for its log.'));
}

function followHole(app) {
  const { card } = app.parts;
  const show = ({ hole }) => {
    const found = app.holes[hole];
    card.hidden = !found;
    card.replaceChildren();
    if (found) card.append(button('×', 'close the log', () => app.settings.set({ hole: -1 }), { class: 'close' }), ...holeLog(app.model, found, app.colors));
  };
  show(app.settings.values);
  app.settings.onChange((values, changed) => {
    if (changed.has('hole') || changed.has('palette')) show(values);
  });
}

function fillCompass(app, compass) {
  compass.innerHTML = '<svg viewBox="-50 -50 100 100"><g><path d="M0 -34L10 12L0 5Z" class="north"/><path d="M0 -34L-10 12L0 5Z" class="dark"/><text y="-37">N</text></g></svg>';
  const needle = compass.querySelector('g');
  app.afterFrame = () => {
    const { position } = app.stage.camera;
    const { target } = app.stage.controls;
    const [dx, dy] = [position.x - target.x, position.y - target.y];
    const flat = Math.hypot(dx, dy);
    const up = app.stage.camera.matrixWorld.elements; // second column: the picture's up
    const heading = flat > 1e-3 * Math.abs(position.z - target.z) ? Math.atan2(-dx, -dy) : Math.atan2(up[4], up[5]);
    needle.setAttribute('transform', `rotate(${((-heading * 180) / Math.PI).toFixed(1)})`);
  };
}

function keyActions(app) {
  const { settings, stage } = app;
  const flip = (key) => () => settings.set({ [key]: !settings.values[key] });
  const cut = (axis) => () => settings.set({ cut: settings.values.cut === axis ? 'off' : axis });
  const step = (way) => () => settings.set({ cutAt: Math.min(1, Math.max(0, settings.values.cutAt + way)) });
  const heights = (factor) => () => settings.set({ exaggeration: Math.min(100, Math.max(0.1, Number((settings.values.exaggeration * factor).toPrecision(3)))) });
  const actions = {
    t: () => stage.show('top'), n: () => stage.show('north'), e: () => stage.show('east'), s: () => stage.show('south'), w: () => stage.show('west'),
    o: () => stage.show('oblique'), f: () => stage.show(), p: flip('orthographic'), b: flip('holes'),
    r: () => toggleTurning(app), m: () => toggleMeasuring(app),
    x: cut('x'), y: cut('y'), z: cut('z'), ArrowLeft: step(-0.01), ArrowRight: step(0.01),
    '+': heights(1.25), '=': heights(1.25), '-': heights(0.8),
    c: () => settings.set({ contours: settings.values.contours === 'off' ? 'solids' : 'off' }),
    S: () => app.savePicture(),
    '?': () => (app.parts.help.hidden = !app.parts.help.hidden),
    Escape: () => {
      if (stage.turning) toggleTurning(app);
      toggleMeasuring(app, false);
      app.parts.help.hidden = true;
      settings.set({ hole: -1, picked: '' });
    },
  };
  for (let i = 1; i <= Math.min(9, app.units.length); ++i)
    actions[i] = () => {
      const { hidden } = settings.values;
      settings.set({ hidden: hidden.includes(i - 1) ? hidden.filter((k) => k !== i - 1) : [...hidden, i - 1].sort((a, b) => a - b) });
    };
  return actions;
}

function listenToKeys(app) {
  const actions = keyActions(app);
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { target } = event;
    const isTyping = target instanceof HTMLElement && /^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName) && target.type !== 'checkbox';
    if (isTyping && event.key !== 'Escape') return;
    const action = actions[event.key] ?? (event.shiftKey ? undefined : actions[event.key.toLowerCase()]);
    if (!action) return;
    event.preventDefault();
    action();
  });
}

/** What a newcomer may try, until the pointer is over something. */
function hint() {
  return matchMedia('(pointer: coarse)').matches
    ? 'One finger turns, two zoom. Tap a borehole for its log.'
    : 'Drag turns, wheel zooms, X cuts; click a borehole for its log; ? lists the keys.';
}

/** Fill the page around an app. */
export function fillShell(app, bindings, shell) {
  app.parts = shell.parts;
  fillTools(app, shell.parts.tools);
  fillHelp(shell.parts.help);
  fillCompass(app, shell.parts.compass);
  shell.parts.panel.append(...panel(app, bindings));
  followHole(app);
  listenToKeys(app);
  shell.parts.status.append(h('span', { class: 'hint' }, hint()));
  app.tell = (found) => {
    shell.parts.status.replaceChildren(...wordsFor(app, found).flatMap(([what, text]) => [h('b', {}, what), h('span', { 'data-fact': what }, text)]));
  };
}
