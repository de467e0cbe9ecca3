// The key of a chart: what a symbol, its filling and a dash mean.

import {colourOf, dashOf, fillOf, symbolOf} from '../look.js';
import {el, svg} from './dom.js';

/** @typedef {import('../types.js').KeyEntry} KeyEntry */
/** @typedef {import('../types.js').Look} Look */

const k_paths = /** @type {Record<string, string>} */ ({
  circle: 'M0,5 A5,5 0 1 0 10,5 A5,5 0 1 0 0,5 Z', rect: 'M0.5,0.5 H9.5 V9.5 H0.5 Z', triangle: 'M5,0 L10,10 L0,10 Z', diamond: 'M5,0 L10,5 L5,10 L0,5 Z',
  cross: 'M1,0 L5,4 L9,0 L10,1 L6,5 L10,9 L9,10 L5,6 L1,10 L0,9 L4,5 L0,1 Z', ring: 'M-1,5 A6,6 0 1 0 11,5 A6,6 0 1 0 -1,5 Z',
});

const pathOf = (/** @type {string} */ symbol) => symbol.startsWith('path://') ? symbol.slice(7) : k_paths[symbol] ?? k_paths.circle;

/** @param {string | number[] | undefined} dash */
const dashes = (dash) => Array.isArray(dash) ? dash.join(' ') : null;

/** @param {KeyEntry} entry @param {Look} look */
function swatch(entry, look) {
  const colour = entry.colour ?? look.ink;
  const parts = [];
  if (entry.dash) parts.push(svg('line', {x1: 1, x2: 33, y1: 8, y2: 8, stroke: colour, 'stroke-width': entry.dash === 'band' ? 8 : 2, 'stroke-dasharray': dashes(entry.dash), opacity: entry.dash === 'band' ? 0.42 : 1}));
  if (entry.symbol) {
    const fill = entry.symbol === 'ring' ? 'none' : entry.fill ?? colour;
    parts.push(svg('path', {d: pathOf(entry.symbol), transform: 'translate(12 3)', fill, stroke: entry.symbol === 'cross' ? 'none' : colour, 'stroke-width': 1.4}));
  }
  return svg('svg', {viewBox: '0 0 34 16', width: 34, height: 16, 'aria-hidden': 'true'}, ...parts);
}

/** @param {string} label @param {KeyEntry[]} entries @param {Look} look */
const group = (label, entries, look) => entries.length === 0 ? null
  : el('ul', {class: 'key', 'aria-label': label}, ...entries.map((entry) => el('li', {}, swatch(entry, look), entry.label)));

/** @param {NonNullable<import('../types.js').Picture['key']>} key @param {Look} look */
export function keyOf(key, look) {
  const methods = key.methods.map((name) => ({label: name, colour: colourOf(look, name), symbol: symbolOf(look, name)}));
  const numbers = key.numbers.map((name) => ({label: name, colour: look.muted, symbol: 'circle', fill: fillOf(look, name, look.muted), dash: dashOf(look, name)}));
  return [group('Methods', methods, look), group('Number types', numbers, look), group('Marks', key.extra ?? [], look)].filter((part) => part !== null);
}
