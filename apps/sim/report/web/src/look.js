// Colours, symbols and dashes. Methods differ by colour and symbol, number types by fill and dashes: nothing is told by a colour
// alone. The first eight colours are by Okabe and Ito, and by Tol, darker or lighter until they have a contrast of 3 : 1 with the page;
// each later one is that which is farthest from all before it, for usual and for colour-blind eyes (tests/sim/report/test_look.mjs
// measures contrasts and distances). They are as many as gauss-sim has methods.

/** @typedef {import('./types.js').Look} Look */

/** @type {Omit<Look, 'methods' | 'numbers' | 'still'>} */
export const k_light = {
  ink: '#1b2530', muted: '#55616d', grid: '#dfe4e9', surface: '#ffffff', accent: '#0a5aa8', fault: '#a3262a', band: '#f3eeee',
  colours: [
    '#0072b2', '#d55e00', '#00875a', '#cc6fa8', '#7a5c00', '#332288', '#5d6872', '#882255', '#a878fc', '#cc3048', '#304818', '#30a830', '#a81890',
    '#0060cc', '#cc7878', '#54306c', '#d83084', '#9c84d8', '#84000c', '#603030', '#6c603c', '#24909c', '#b48454', '#004848', '#485490', '#b45430',
  ],
};

/** @type {Omit<Look, 'methods' | 'numbers' | 'still'>} */
export const k_dark = {
  ink: '#e8edf2', muted: '#a7b3bf', grid: '#313b46', surface: '#171d24', accent: '#7cb8f5', fault: '#ff8f8a', band: '#241f23',
  colours: [
    '#56b4e9', '#f0802f', '#2fc797', '#e29ad0', '#e6bd3c', '#9d92f0', '#b4bec8', '#f2728f', '#c0189c', '#90603c', '#b4d878', '#247860', '#2460e4',
    '#9048c0', '#cc3018', '#846c84', '#cc1860', '#546ca8', '#e4846c', '#fcb4b4', '#3c780c', '#00e4fc', '#d89c54', '#3ca8b4', '#0084f0', '#9c843c',
  ],
};

const k_symbols = [
  'circle', 'rect', 'triangle', 'diamond',
  'path://M0,0 L10,0 L5,9 Z',
  'path://M3,0 H7 V3 H10 V7 H7 V10 H3 V7 H0 V3 H3 Z',
  'path://M2.5,0 H7.5 L10,5 L7.5,10 H2.5 L0,5 Z',
  'path://M5,0 L6.5,3.5 L10,3.8 L7.3,6.2 L8.2,10 L5,7.9 L1.8,10 L2.7,6.2 L0,3.8 L3.5,3.5 Z',
];

const k_dashes = /** @type {(string | number[])[]} */ (['solid', [7, 4], [2, 3], [9, 3, 2, 3]]);

/** How much of a symbol is filled, by number type: all, nothing, a third, two thirds. */
const k_fills = [1, 0, 0.35, 0.7];

const place = (/** @type {string[]} */ names, /** @type {string} */ name) => Math.max(0, names.indexOf(name));

/** @param {Look} look @param {string} method */
export const colourOf = (look, method) => look.colours[place(look.methods, method) % look.colours.length];

/** The symbol moves on by one with each round of colours, so that methods of one colour differ. @param {Look} look @param {string} method */
export function symbolOf(look, method) {
  const at = place(look.methods, method);
  return k_symbols[(at + Math.floor(at / look.colours.length)) % k_symbols.length];
}

/** @param {Look} look @param {string} number */
export const dashOf = (look, number) => k_dashes[place(look.numbers, number) % k_dashes.length];

/** @param {Look} look @param {string} number @param {string} colour */
export function fillOf(look, number, colour) {
  const part = k_fills[place(look.numbers, number) % k_fills.length];
  return part === 1 ? colour : part === 0 ? look.surface : mixed(colour, look.surface, part);
}

/** @param {string} a @param {string} b @param {number} part of `a` */
export function mixed(a, b, part) {
  const channels = (/** @type {string} */ colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
  const [from, to] = [channels(a), channels(b)];
  return `#${from.map((value, i) => Math.round(value * part + to[i] * (1 - part)).toString(16).padStart(2, '0')).join('')}`;
}

/** Colours for what is no method (formulations, outputs), with a symbol each. @param {Look} look @param {number} at */
export const nth = (look, at) => ({
  colour: look.colours[at % look.colours.length],
  symbol: k_symbols[(at + Math.floor(at / look.colours.length)) % k_symbols.length],
  dash: k_dashes[at % k_dashes.length],
});
