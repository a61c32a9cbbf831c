// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that the page's controls say, and its way into the address: #cut=x&cutAt=0.4.

/** What each setting is unless the reader changes it; its type is that of the value here. */
export const kDefaults = Object.freeze({
  hidden: [], // numbers of layers
  opacity: 1, // of all layers
  faint: [], // [layer, opacity, layer, opacity, …]: those that have one of their own
  exaggeration: 1,
  explode: 0, // share of the model's height between neighbours
  smooth: true,
  edges: false,
  palette: 'model',
  theme: 'auto',
  holes: true,
  holeSize: 1,
  holesCut: true,
  hole: -1, // whose log is shown
  cut: 'off', // off, x, y, z or azimuth
  cutAt: 0.5, // share of the way through the model
  cutFlip: false,
  azimuth: 45,
  dip: 90,
  block: 'off', // off, keep or remove
  blockShares: [0, 0.5, 0, 0.5, 0, 1],
  slabs: 20,
  slab: 0, // 0: all
  contours: 'off', // off, solids, or a horizon's number
  interval: 0, // 0: a suitable one
  level: '', // one elevation instead of many
  reeb: 'off', // off, layered, or a layer's number
  picked: '', // n3: a node, a5: an arc
  compare: 'off', // off, or what stands beside the model: unrefined, straight
  orthographic: false,
  camera: [], // position, target, zoom
  frame: true,
});


const kChoices = {
  palette: ['model', 'safe', 'ordered'],
  theme: ['auto', 'light', 'dark'],
  cut: ['off', 'x', 'y', 'z', 'azimuth'],
  block: ['off', 'keep', 'remove'],
  compare: ['off', 'unrefined', 'straight'],
};
const kRanges = {
  opacity: [0, 1],
  exaggeration: [0.01, 1000],
  explode: [0, 2],
  holeSize: [0.1, 10],
  cutAt: [0, 1],
  azimuth: [-360, 360],
  dip: [0, 90],
  slabs: [1, 200],
  slab: [0, 200],
  interval: [0, Infinity],
};

function textOf(value) {
  if (Array.isArray(value)) return value.map((v) => +Number(v).toFixed(4)).join(',');
  if (typeof value === 'number') return String(+value.toFixed(6));
  if (typeof value === 'boolean') return value ? '1' : '0';
  return value;
}

function valueOf(text, like) {
  if (Array.isArray(like)) {
    const numbers = text === '' ? [] : text.split(',').map(Number);
    return numbers.every(Number.isFinite) ? numbers : null;
  }
  if (typeof like === 'number') return text !== '' && Number.isFinite(Number(text)) ? Number(text) : null;
  if (typeof like === 'boolean') return text === '1';
  return text;
}

/** The settings that differ from `base` as an address fragment. */
export function toFragment(settings, base = kDefaults) {
  const parts = new URLSearchParams();
  for (const key of Object.keys(kDefaults)) {
    const text = textOf(settings[key]);
    if (text !== textOf(base[key])) parts.set(key, text);
  }
  return parts.toString().replaceAll('%2C', ',');
}

/** What a fragment says; unknown keys and values that make no sense are left out. */
export function fromFragment(fragment) {
  const said = {};
  for (const [key, text] of new URLSearchParams(fragment.replace(/^#/, ''))) {
    if (!Object.hasOwn(kDefaults, key)) continue;
    const value = valueOf(text, kDefaults[key]);
    const [low, high] = kRanges[key] ?? [-Infinity, Infinity];
    if (value === null || (kChoices[key] && !kChoices[key].includes(value))) continue;
    if (key === 'blockShares' && value.length !== 6) continue;
    if (key === 'camera' && value.length !== 7) continue;
    said[key] = typeof value === 'number' ? Math.min(high, Math.max(low, value)) : value;
  }
  return said;
}

/** Settings that tell others when they change. */
export class Settings {
  #listeners = [];

  constructor(base = kDefaults) {
    this.base = { ...kDefaults, ...base };
    this.values = { ...this.base };
  }

  get(key) {
    return this.values[key];
  }

  /** Set some of them; listeners hear of those that changed, all at once. */
  set(changes) {
    const changed = new Set();
    for (const [key, value] of Object.entries(changes)) {
      if (textOf(this.values[key]) === textOf(value)) continue;
      this.values[key] = value;
      changed.add(key);
    }
    if (changed.size > 0) for (const listener of this.#listeners) listener(this.values, changed);
  }

  reset() {
    this.set({ ...this.base });
  }

  onChange(listener) {
    this.#listeners.push(listener);
  }
}

/** The opacity of a layer: its own or everybody's; 0 if hidden. */
export function opacityOf(settings, layer) {
  if (settings.hidden.includes(layer)) return 0;
  const { faint } = settings;
  for (let i = 0; i < faint.length; i += 2) if (faint[i] === layer) return faint[i + 1];
  return settings.opacity;
}
