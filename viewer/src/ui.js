// SPDX-License-Identifier: GPL-3.0-or-later
// Elements, and controls that follow a setting and set it.

/** An element: h('button', { class: 'x', onclick: f }, 'text', child). */
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (key in element && key !== 'list' && key !== 'form' && typeof value !== 'string') element[key] = value;
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(key, value === true ? '' : value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** Controls that are brought in line whenever settings change. */
export class Bindings {
  constructor(settings) {
    this.settings = settings;
    this.syncs = [];
    settings.onChange(() => this.sync());
  }

  sync() {
    for (const sync of this.syncs) sync(this.settings.values);
  }

  /** Call `sync(values)` now and after each change. */
  follow(sync) {
    this.syncs.push(sync);
    sync(this.settings.values);
  }

  check(key, label, title = '') {
    const box = h('input', { type: 'checkbox', id: `set-${key}`, onchange: () => this.settings.set({ [key]: box.checked }) });
    this.follow((values) => (box.checked = values[key]));
    return h('label', { class: 'row check', title }, box, label);
  }

  choice(key, label, options) {
    const select = h('select', { id: `set-${key}`, onchange: () => this.settings.set({ [key]: select.value }) });
    for (const [value, text] of Object.entries(options)) select.append(h('option', { value }, text));
    this.follow((values) => (select.value = values[key]));
    return h('label', { class: 'row' }, h('span', {}, label), select);
  }

  /** A row of buttons of which one is down. */
  segments(key, label, options) {
    const buttons = Object.entries(options).map(([value, text]) =>
      h('button', { type: 'button', 'data-value': value, onclick: () => this.settings.set({ [key]: value }) }, text),
    );
    this.follow((values) => {
      for (const button of buttons) button.setAttribute('aria-pressed', String(button.dataset.value === values[key]));
    });
    return h('div', { class: 'row', role: 'group', 'aria-label': label, id: `set-${key}` }, h('span', {}, label), h('div', { class: 'segments' }, ...buttons));
  }

  /**
   * A slider with a field for typing. The slider runs over 0…1; `shown(share)` is the number in the field, `meant(number)` its share.
   * `read(values)` gives the share, `write(share)` the changes.
   */
  slider(id, label, { read, write, shown = (s) => s, meant = (n) => n, unit = '', step = 0.001, digits = 2 }) {
    const range = h('input', { type: 'range', min: '0', max: '1', step: String(step), 'aria-label': label, id: `set-${id}` });
    const field = h('input', { type: 'number', step: 'any', 'aria-label': `${label}, typed`, id: `type-${id}` });
    const clamp = (share) => Math.min(1, Math.max(0, share));
    range.addEventListener('input', () => this.settings.set(write(Number(range.value))));
    field.addEventListener('change', () => {
      const share = meant(Number(field.value));
      if (field.value !== '' && Number.isFinite(share)) this.settings.set(write(clamp(share)));
      this.sync();
    });
    this.follow((values) => {
      range.value = String(read(values));
      if (document.activeElement !== field || field.dataset.busy !== '1') field.value = String(+shown(read(values)).toFixed(digits));
    });
    return h('div', { class: 'row slider' }, h('span', {}, label), range, h('span', { class: 'typed' }, field, h('i', {}, unit)));
  }

  /** A field for a number. */
  number(key, label, { min = null, max = null, unit = '', text = false, placeholder = '' } = {}) {
    const field = h('input', { type: 'number', step: 'any', min, max, placeholder, id: `set-${key}` });
    field.addEventListener('change', () => {
      const value = Number(field.value);
      if (field.value === '' || !Number.isFinite(value)) {
        this.settings.set({ [key]: this.settings.base[key] });
      } else {
        const held = Math.min(max ?? Infinity, Math.max(min ?? -Infinity, value));
        this.settings.set({ [key]: text ? String(held) : held });
      }
      this.sync();
    });
    this.follow((values) => (field.value = values[key] === this.settings.base[key] && placeholder ? '' : String(values[key])));
    return h('label', { class: 'row' }, h('span', {}, label), h('span', { class: 'typed' }, field, h('i', {}, unit)));
  }
}

export function button(text, title, onclick, properties = {}) {
  return h('button', { type: 'button', title, 'aria-label': title, onclick, ...properties }, text);
}

export function section(id, title, open, ...children) {
  return h('details', { id: `section-${id}`, open }, h('summary', {}, title), h('div', { class: 'body' }, ...children));
}
