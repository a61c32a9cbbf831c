// SPDX-License-Identifier: GPL-3.0-or-later
// The model as io/view_payload.h packs it: base64 of deflated bytes, a JSON header and lists of varints.

const kFormat = 'stratareeb view 1';

function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  if (typeof DecompressionStream === 'undefined')
    throw new Error('This browser is too old to open the model: it needs DecompressionStream (2023 or newer).');
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The header, and the bytes that its lists' offsets count in. */
export async function unpack(base64) {
  const bytes = await inflated(bytesOfBase64(base64.trim()));
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  if (header.format !== kFormat) throw new Error(`The model is of the format "${header.format}", not "${kFormat}".`);
  return { header, lists: bytes.subarray(4 + length) };
}

/** Whole numbers of a list, which fit a double exactly. */
export function readList(lists, { offset, length, count }) {
  const numbers = new Float64Array(count);
  let at = offset;
  for (let i = 0; i < count; ++i) {
    let value = 0;
    let scale = 1;
    for (;;) {
      const byte = lists[at++];
      value += (byte & 127) * scale;
      if (byte < 128) break;
      scale *= 128;
    }
    numbers[i] = value;
  }
  if (at !== offset + length) throw new Error('The model in this page is damaged.');
  return numbers;
}

/** A list of differences summed up. */
export function readSums(lists, list) {
  const numbers = readList(lists, list);
  let sum = 0;
  for (let i = 0; i < numbers.length; ++i) {
    const code = numbers[i];
    sum += code % 2 === 1 ? -(code + 1) / 2 : code / 2;
    numbers[i] = sum;
  }
  return numbers;
}

function corners(lists, list) {
  const codes = readList(lists, list);
  const corner = new Uint32Array(codes.length);
  let met = 0;
  for (let i = 0; i < codes.length; ++i) corner[i] = codes[i] === 0 ? met++ : met - codes[i];
  return corner;
}

/**
 * Horizons over a plan: { corner (three a triangle), x, y (a number a vertex), horizons (ground first, then each layer's base) },
 * relative to the model's origin.
 */
export function readSurfaces(lists, surfaces) {
  const { low, step } = surfaces;
  const placed = (list, axis) => readSums(lists, list).map((q) => low[axis] + q * step[axis]);
  const steps = readSums(lists, surfaces.ground);
  const elevations = () => Float64Array.from(steps, (q) => low[2] + q * step[2]);
  const horizons = [elevations()];
  for (const list of surfaces.thickness) {
    const thickness = readSums(lists, list);
    for (let v = 0; v < steps.length; ++v) steps[v] -= thickness[v];
    horizons.push(elevations());
  }
  return { corner: corners(lists, surfaces.corner), x: placed(surfaces.x, 0), y: placed(surfaces.y, 1), horizons };
}

/** Runs (arc + 1, how many) as the arc of each triangle, -1 for none. */
export function readRuns(lists, list) {
  const runs = readList(lists, list);
  let count = 0;
  for (let i = 1; i < runs.length; i += 2) count += runs[i];
  const arcs = new Int32Array(count);
  for (let i = 0, at = 0; i < runs.length; i += 2) {
    arcs.fill(runs[i] - 1, at, at + runs[i + 1]);
    at += runs[i + 1];
  }
  return arcs;
}
