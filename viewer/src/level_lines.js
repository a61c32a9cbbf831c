// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of equal height on triangles.

/**
 * Calls `emit(ax, ay, az, bx, by, bz)` for each piece of the line where `field` is at the level, over triangles `index` (three vertices
 * each) of the vertices x, y, z. A vertex at the level counts as above it.
 */
export function levelLine({ x, y, z }, field, index, level, emit) {
  const p = new Float64Array(6);
  for (let i = 0; i < index.length; i += 3) {
    let found = 0;
    for (let k = 0; k < 3; ++k) {
      const a = index[i + k];
      const b = index[i + (k === 2 ? 0 : k + 1)];
      if (field[a] >= level === field[b] >= level) continue;
      const s = (level - field[a]) / (field[b] - field[a]);
      p[3 * found] = x[a] + s * (x[b] - x[a]);
      p[3 * found + 1] = y[a] + s * (y[b] - y[a]);
      p[3 * found + 2] = z[a] + s * (z[b] - z[a]);
      ++found;
    }
    if (found === 2) emit(p[0], p[1], p[2], p[3], p[4], p[5]);
  }
}

/** The same on triangles of nine coordinates each, for height. */
export function levelLineOfSoup(soup, level, emit) {
  const [x, y, z] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)];
  const index = [0, 1, 2];
  for (let i = 0; i < soup.length; i += 9) {
    for (let k = 0; k < 3; ++k) {
      x[k] = soup[i + 3 * k];
      y[k] = soup[i + 3 * k + 1];
      z[k] = soup[i + 3 * k + 2];
    }
    levelLine({ x, y, z }, z, index, level, emit);
  }
}

/** A round number: 1, 2 or 5 times a power of ten, the least that is not below. */
export function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  for (const factor of [1, 2, 5, 10]) if (factor * power >= value * (1 - 1e-9)) return factor * power;
  return value;
}

/** A round interval that gives about a dozen levels. */
export function suitableInterval(low, high) {
  return high > low ? roundUp((high - low) / 12) : 1;
}

/** Multiples of the interval from low to high, at most `most`. */
export function levelsBetween(low, high, interval, most = 400) {
  const levels = [];
  const first = Math.ceil(low / interval - 1e-9);
  for (let i = first; i * interval <= high + 1e-9 * interval && levels.length < most; ++i) levels.push(i * interval);
  return levels;
}
