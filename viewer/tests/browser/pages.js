// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of models in headless Chromium, without a network.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, rmSync } from 'node:fs';
import path from 'node:path';
import { chromium } from 'playwright-core';

const program = process.env.STRATAREEB_PROGRAM;
const source = path.resolve(process.env.STRATAREEB_SOURCE);
const folder = path.resolve('models');
export const pictures = path.resolve('pictures');

const kTables = {
  sighthill: ['examples/sighthill/intervals.csv', '--collars', 'examples/sighthill/collars.csv', '--refine', '0'],
  thesis: ['examples/thesis_sample3.csv', '--refine', '0'],
  graben: ['examples/graben/holes.csv', '--faults', 'examples/graben/faults.geojson', '--footprint', 'box', '--refine', '0'],
  refined: ['examples/thesis_sample3.csv', '--refine', '1'],
  teapot: ['../shared/data/teapot_dome/wide_shannon.csv', '--unit', 'ft', '--refine', '0'],
};

export function run(...args) {
  return execFileSync(program, args, { cwd: source, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
}

export function hasTable(name) {
  return existsSync(path.join(source, kTables[name][0]));
}

/** The folder of a model, built and with its page. */
export function modelFolder(name) {
  const place = path.join(folder, name);
  mkdirSync(folder, { recursive: true });
  mkdirSync(pictures, { recursive: true });
  rmSync(place, { recursive: true, force: true });
  run('build', ...kTables[name], '-o', place, '--interpolator', 'natural', '--quiet');
  run('view', place, '--title', name, '--no-report');
  return place;
}

export function launch() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--use-gl=angle',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--ignore-gpu-blocklist',
      '--enable-precise-memory-info',
      '--js-flags=--expose-gc',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      '--no-first-run',
    ],
  });
}

/** A page that is open and idle; what it says in the console and asks of a network is in `said` and `asked`. */
export async function openPage(browser, place, { phone = false, fragment = '', dark = false } = {}) {
  const context = await browser.newContext({
    viewport: phone ? { width: 390, height: 844 } : { width: 880, height: 560 },
    hasTouch: phone,
    isMobile: phone,
    offline: true,
    colorScheme: dark ? 'dark' : 'light',
    acceptDownloads: true,
  });
  const page = await context.newPage();
  page.said = [];
  page.asked = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && page.said.push(message.text()));
  page.on('pageerror', (error) => page.said.push(error.message));
  page.on('request', (request) => page.asked.push(request.url()));
  await page.goto(`file://${place}/model.html${fragment}`, { timeout: 120000 });
  await page.waitForSelector('#app[aria-busy=false]', { timeout: 120000 });
  await page.evaluate(inPage);
  return page;
}

/** Helpers that live in the page, as window.look. */
function inPage() {
  const app = window.stratareeb;
  const gl = app.stage.renderer.getContext();
  const read = (x, y, w, h) => {
    const ratio = app.stage.renderer.getPixelRatio();
    const bytes = new Uint8Array(4 * w * h);
    gl.readPixels(Math.round(x * ratio), Math.round(gl.drawingBufferHeight - y * ratio - h), w, h, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
  };
  window.look = {
    /** "#rrggbb" at a place on the canvas. */
    pixel(x, y) {
      app.stage.draw();
      return `#${[...read(x, y, 1, 1)].slice(0, 3).map((c) => c.toString(16).padStart(2, '0')).join('')}`;
    },
    /** A number for the whole picture. */
    picture() {
      app.stage.draw();
      const bytes = read(0, app.stage.size[1] - gl.drawingBufferHeight, gl.drawingBufferWidth, gl.drawingBufferHeight);
      let hash = 2166136261;
      for (let i = 0; i < bytes.length; ++i) hash = Math.imul(hash ^ bytes[i], 16777619) >>> 0;
      return hash;
    },
    /** The share of pixels that are not background. */
    covered() {
      app.stage.draw();
      const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
      const bytes = read(0, app.stage.size[1] - h, w, h);
      let count = 0;
      for (let i = 4; i < bytes.length; i += 4) if (bytes[i] !== bytes[0] || bytes[i + 1] !== bytes[1] || bytes[i + 2] !== bytes[2]) ++count;
      return count / (w * h);
    },
    /** The middle of a layer at a place in the frame, or null where it is thin. */
    middle(layer, x, y, thick = 0.5) {
      const column = app.model.column(x, y);
      return column && column[layer] - column[layer + 1] > thick ? [x, y, (column[layer] + column[layer + 1]) / 2] : null;
    },
  };
}
