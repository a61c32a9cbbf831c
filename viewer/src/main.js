// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the model that the page holds.
import './style.css';
import { App, suitableExaggeration } from './app.js';
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
  addEventListener('hashchange', () => openFragment(app, location.hash));
}

function openFragment(app, fragment) {
  const said = fromFragment(fragment);
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
  place.replaceChildren(shell.view, shell.side);
  const stage = new Stage(shell.canvas);
  const settings = new Settings({ exaggeration: suitableExaggeration(model.plan.box) });
  const said = fromFragment(location.hash);
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
