// SPDX-License-Identifier: GPL-3.0-or-later
// Heights of flat models are drawn larger than they are.
import { roundUp } from './level_lines.js';

const kFlat = 0.22; // of its length that a model's height should look like

/** How much to exaggerate heights so that layers can be told apart. */
export function suitableExaggeration({ low, high }) {
  const wide = Math.max(high[0] - low[0], high[1] - low[1]);
  const tall = high[2] - low[2] || 1;
  const wanted = (kFlat * wide) / tall;
  return wanted <= 1.3 ? 1 : roundUp(wanted) > 2 * wanted ? wanted : roundUp(wanted / 1.4);
}
