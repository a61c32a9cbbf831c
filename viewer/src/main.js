// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the model that the page holds.
import './style.css';
import { App } from './app.js';
import { suitableExaggeration } from './exaggeration.js';
import { Model } from './model.js';
import { Settings, fromFragment } from './settings.js';
import { fillShell, makeShell } from './shell.js';
import { Stage } from './stage.js';
import { Bindings, h } from './ui.js';

const kRestAfter = 400; // milliseconds without a change after which the address has the view

function keepAddress(app) {
  let timer = 0;
  const write = () => {
    const fragment = app.fragment();
    try {
      history.replaceState(null, '', fragment ? `#${fragment}` : location.href.split('#')[0]);
    } catch {
      // some browsers forbid it for files, and when it is done too often
    }
  };
  const later = () => {
    clearTimeout(timer);
    timer = setTimeout(write, kRestAfter);
  };
  app.settings.onChange(later);
  app.stage.controls.addEventListener('change', later);
  addEventListener('hashchange', (event) => {
    clearTimeout(timer); // it would write what was before
    openFragment(app, new URL(event.newURL).hash);
  });
}

/** What an address says, as far as this model has it. */
function saidOf(model, fragment) {
  const said = fromFragment(fragment);
  const isLayer = (i) => Number.isInteger(i) && i >= 0 && i < model.units.length;
  if (said.hidden) said.hidden = said.hidden.filter(isLayer);
  if (said.reeb && said.reeb !== 'layered' && !model.graphs.layers[said.reeb]) said.reeb = 'off';
  if (said.contours && said.contours !== 'solids' && !isLayer(Number(said.contours) - 1) && said.contours !== '0') said.contours = 'off';
  if (said.compare && !model.others[said.compare]) said.compare = 'off';
  if (said.hole !== undefined && !model.holes[said.hole]) said.hole = -1;
  return said;
}

function openFragment(app, fragment) {
  const said = saidOf(app.model, fragment);
  app.settings.set({ ...app.settings.base, ...said });
  if (said.camera) app.stage.setCameraState(said.camera);
  else app.stage.show('oblique');
}

async function open() {
  const place = document.getElementById('app');
  const text = document.getElementById('model');
  const model = await Model.of(text.textContent);
  text.remove();
  const shell = makeShell(model.title, model.facts);
  place.replaceChildren(shell.view, shell.parts.card, shell.side);
  const stage = new Stage(shell.canvas);
  const settings = new Settings({ exaggeration: suitableExaggeration(model.plan.box) });
  const said = saidOf(model, location.hash);
  settings.set(said);
  const app = new App(model, settings, stage, shell.overlay);
  fillShell(app, new Bindings(settings), shell);
  stage.show('oblique');
  if (said.camera) stage.setCameraState(said.camera);
  keepAddress(app);
  stage.draw();
  place.setAttribute('aria-busy', 'false');
  window.stratareeb = app; // for tests, and for whoever likes a console
}

open().catch((error) => {
  document.getElementById('app').replaceChildren(h('p', { class: 'loading error', role: 'alert' }, `The model can’t be shown. ${error.message}`));
  throw error;
});
