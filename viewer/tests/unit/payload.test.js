// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { deflateSync } from 'node:zlib';
import { readList, readRuns, readSums, readSurfaces, unpack } from '../../src/payload.js';
import { random } from './shapes.js';

function varints(numbers) {
  const bytes = [];
  for (let n of numbers) {
    for (; n >= 128; n = Math.floor(n / 128)) bytes.push((n % 128) + 128);
    bytes.push(n);
  }
  return bytes;
}
const signed = (n) => (n < 0 ? -2 * n - 1 : 2 * n);
const differences = (numbers) => numbers.map((n, i) => signed(n - (i === 0 ? 0 : numbers[i - 1])));

/** Lists one after the other, with their places. */
function packed(...lists) {
  const bytes = [];
  const places = lists.map((numbers) => {
    const coded = varints(numbers);
    bytes.push(...coded);
    return { offset: bytes.length - coded.length, length: coded.length, count: numbers.length };
  });
  return { bytes: Uint8Array.from(bytes), places };
}

test('lists of numbers and of differences come back', () => {
  const next = random(1);
  const plain = Array.from({ length: 500 }, () => Math.floor(2 ** (32 * next())));
  const rising = Array.from({ length: 500 }, () => Math.floor((next() - 0.5) * 2 ** 40));
  const { bytes, places } = packed(plain, differences(rising));
  assert.deepEqual([...readList(bytes, places[0])], plain);
  assert.deepEqual([...readSums(bytes, places[1])], rising);
  assert.throws(() => readList(bytes, { ...places[0], length: places[0].length + 1 }), /damaged/);
});

test('surfaces come back: corners, places and horizons', () => {
  // two triangles 0 1 2 and 0 2 3
  const { bytes, places } = packed([0, 0, 0, 3, 1, 0], differences([0, 10, 10, 0]), differences([0, 0, 5, 5]), differences([7, 8, 9, 9]), differences([1, 0, 0, 2]));
  const [corner, x, y, ground, thickness] = places;
  const surfaces = readSurfaces(bytes, { low: [100, 200, -5], step: [0.5, 0.5, 0.1], corner, x, y, ground, thickness: [thickness] });
  assert.deepEqual([...surfaces.corner], [0, 1, 2, 0, 2, 3]);
  assert.deepEqual([...surfaces.x], [100, 105, 105, 100]);
  assert.deepEqual([...surfaces.y], [200, 200, 202.5, 202.5]);
  assert.equal(surfaces.horizons[1][1], surfaces.horizons[0][1]);
  assert.ok(Math.abs(surfaces.horizons[0][3] - surfaces.horizons[1][3] - 0.2) < 1e-12);
});

test('runs of arcs come back', () => {
  const { bytes, places } = packed([3, 2, 0, 1, 1, 3]);
  assert.deepEqual([...readRuns(bytes, places[0])], [2, 2, -1, 0, 0, 0]);
});

test('a packed page opens; one of another format says so', async () => {
  const page = (format) => {
    const header = new TextEncoder().encode(JSON.stringify({ format, title: 'Ä </script>' }));
    const length = new Uint8Array(new Uint32Array([header.length]).buffer);
    return deflateSync(Buffer.concat([length, header, Buffer.from([5])])).toString('base64');
  };
  const { header, lists } = await unpack(`\n${page('stratareeb view 1')}\n`);
  assert.equal(header.title, 'Ä </script>');
  assert.deepEqual([...lists], [5]);
  await assert.rejects(unpack(page('stratareeb view 9')), /format/);
});
