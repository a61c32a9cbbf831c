// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import test from 'node:test';
import { Pace, kPaces } from '../../src/pace.js';

function paceWith() {
  const applied = [];
  let requests = 0;
  const pace = new Pace({}, (what) => applied.push(kPaces.indexOf(what)), () => ++requests);
  return { pace, applied, requests: () => requests };
}

test('two slow frames draw less, one very slow frame does at once', () => {
  const { pace, applied } = paceWith();
  pace.begin();
  pace.took(60);
  assert.equal(pace.level, 0);
  pace.took(20);
  pace.took(60); // alone again
  assert.equal(pace.level, 0);
  pace.took(60);
  assert.equal(pace.level, 1);
  pace.took(3000);
  assert.equal(pace.level, 2);
  assert.deepEqual(applied, [1, 2]);
  for (let i = 0; i < 20; ++i) pace.took(3000);
  assert.equal(pace.level, kPaces.length - 1);
  pace.rest();
});

test('at rest all is drawn, and the next movement begins where the last one ended', () => {
  const { pace, applied } = paceWith();
  pace.begin();
  pace.took(3000);
  pace.took(3000);
  pace.rest();
  pace.begin();
  assert.deepEqual(applied, [1, 2, 0, 2]);
  pace.rest();
});

test('a rest comes by itself after the end, and asks for a frame', async () => {
  const { pace, applied, requests } = paceWith();
  pace.begin();
  pace.took(3000);
  pace.end();
  pace.begin(); // goes on: no rest yet
  await new Promise((done) => setTimeout(done, 300));
  assert.equal(pace.moving, true);
  pace.end();
  await new Promise((done) => setTimeout(done, 300));
  assert.equal(pace.moving, false);
  assert.deepEqual(applied, [1, 0]);
  assert.equal(requests(), 1);
});

test('what was too slow is not tried again before something else is shown', () => {
  const { pace } = paceWith();
  pace.begin();
  pace.took(3000);
  for (let i = 0; i < 100; ++i) pace.took(5);
  assert.equal(pace.level, 1);
  pace.forget();
  for (let i = 0; i < 100; ++i) pace.took(5);
  assert.equal(pace.level, 0);
  pace.rest();
});
