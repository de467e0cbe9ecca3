// The key of a chart in the page.

import {keyRows, swatchParts} from '../key.js';
import {el, svg} from './dom.js';

/** @typedef {import('../types.js').Look} Look */

/** @param {import('../types.js').KeyEntry} entry @param {Look} look */
const swatch = (entry, look) => svg('svg', {viewBox: '0 0 34 16', width: 34, height: 16, 'aria-hidden': 'true'}, ...swatchParts(entry, look).map(([tag, attributes]) => svg(tag, attributes)));

/** @param {NonNullable<import('../types.js').Picture['key']>} key @param {Look} look */
export const keyOf = (key, look) => keyRows(key, look)
  .map(([name, entries]) => el('ul', {class: 'key', 'aria-label': name}, ...entries.map((entry) => el('li', {}, swatch(entry, look), entry.label))));
