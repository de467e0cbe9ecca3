// What symbols, their filling, and dashes mean: rows of entries, for the page and for still pictures.

import {colourOf, dashOf, fillOf, symbolOf} from './look.js';

/** @typedef {import('./types.js').KeyEntry} KeyEntry */
/** @typedef {import('./types.js').Look} Look */

const k_paths = /** @type {Record<string, string>} */ ({
  circle: 'M0,5 A5,5 0 1 0 10,5 A5,5 0 1 0 0,5 Z', rect: 'M0.5,0.5 H9.5 V9.5 H0.5 Z', triangle: 'M5,0 L10,10 L0,10 Z', diamond: 'M5,0 L10,5 L5,10 L0,5 Z',
  cross: 'M1,0 L5,4 L9,0 L10,1 L6,5 L10,9 L9,10 L5,6 L1,10 L0,9 L4,5 L0,1 Z', ring: 'M-1,5 A6,6 0 1 0 11,5 A6,6 0 1 0 -1,5 Z',
});

/** Of a symbol that is 10 wide and high. */
export const pathOf = (/** @type {string} */ symbol) => symbol.startsWith('path://') ? symbol.slice(7) : k_paths[symbol] ?? k_paths.circle;

/** @param {NonNullable<import('./types.js').Picture['key']>} key @param {Look} look @returns {[string, KeyEntry[]][]} rows with their names */
export function keyRows(key, look) {
  const methods = key.methods.map((name) => ({label: name, colour: colourOf(look, name), symbol: symbolOf(look, name)}));
  const numbers = key.numbers.map((name) => ({label: name, colour: look.muted, symbol: 'circle', fill: fillOf(look, name, look.muted), dash: dashOf(look, name)}));
  return /** @type {[string, KeyEntry[]][]} */ ([['Methods', methods], ['Number types', numbers], ['Marks', key.extra ?? []]]).filter(([, entries]) => entries.length > 0);
}

/**
 * How an entry is drawn in a place of 34 by 16: tags of SVG with their attributes. @param {KeyEntry} entry @param {Look} look
 * @returns {[string, Record<string, string | number>][]}
 */
export function swatchParts(entry, look) {
  const colour = entry.colour ?? look.ink;
  const parts = /** @type {[string, Record<string, string | number>][]} */ ([]);
  if (entry.dash) {
    const band = entry.dash === 'band';
    const dashes = /** @type {Record<string, string>} */ (Array.isArray(entry.dash) ? {'stroke-dasharray': entry.dash.join(' ')} : {});
    parts.push(['line', {x1: 1, x2: 33, y1: 8, y2: 8, stroke: colour, 'stroke-width': band ? 8 : 2, opacity: band ? 0.42 : 1, ...dashes}]);
  }
  if (entry.symbol) {
    const fill = entry.symbol === 'ring' ? 'none' : entry.fill ?? colour;
    parts.push(['path', {d: pathOf(entry.symbol), transform: 'translate(12 3)', fill, stroke: entry.symbol === 'cross' ? 'none' : colour, 'stroke-width': 1.4}]);
  }
  return parts;
}
