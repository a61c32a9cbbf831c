// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of layers: those of the model, or ones that people with any colour vision tell apart.

// M. Okabe and K. Ito's, black left out and a grey added.
const kSafe = ['#e69f00', '#56b4e9', '#009e73', '#f0e442', '#0072b2', '#d55e00', '#cc79a7', '#999999'];
// Cividis (J. Nuñez, C. Anderton, R. Renslow 2018), from dark to light: an order that any eye sees.
const kOrdered = ['#00224e', '#123570', '#3b496c', '#575d6d', '#707173', '#8a8678', '#a59c74', '#c3b369', '#e1cc55', '#fee838'];

const channels = (color) => [1, 3, 5].map((i) => parseInt(color.slice(i, i + 2), 16));
const hex = (rgb) => `#${rgb.map((c) => Math.round(c).toString(16).padStart(2, '0')).join('')}`;

/** A colour part of the way from one to another. */
export function mixed(a, b, share) {
  const [p, q] = [channels(a), channels(b)];
  return hex(p.map((c, i) => c + share * (q[i] - c)));
}

function ordered(i, count) {
  const at = count > 1 ? ((count - 1 - i) / (count - 1)) * (kOrdered.length - 1) : 0;
  const k = Math.min(Math.floor(at), kOrdered.length - 2);
  return mixed(kOrdered[k], kOrdered[k + 1], at - k);
}

function safe(i) {
  const round = Math.floor(i / kSafe.length);
  const color = kSafe[i % kSafe.length];
  return round === 0 ? color : mixed(color, round % 2 === 1 ? '#ffffff' : '#000000', 0.4);
}

export const kPalettes = { model: 'as in the model', safe: 'colour-blind safe', ordered: 'dark to light downwards' };

/** "#rrggbb" of each unit, top first. */
export function layerColors(units, palette) {
  return units.map((unit, i) => {
    if (palette === 'safe') return safe(i);
    if (palette === 'ordered') return ordered(units.length - 1 - i, units.length);
    return /^#[0-9a-f]{6}$/i.test(unit.color) ? unit.color.toLowerCase() : safe(i);
  });
}

/** Colours of Reeb graph arcs (P. Tol's muted scheme). */
export const kArcColors = ['#332288', '#88ccee', '#44aa99', '#117733', '#999933', '#ddcc77', '#cc6677', '#882255', '#aa4499'];
export const kNodeColors = { minimum: '#0072b2', saddle: '#f0c000', maximum: '#d55e00' };
