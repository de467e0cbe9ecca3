// Number types: what more digits in the arithmetic cost, and how far they reach.

import {small} from '../format.js';
import {askedFor, compared} from './asked_for.js';

/** @param {import('./asked_for.js').Line[]} lines */
const reach = (lines) => lines.map((line) => `${line.name} ${Number.isFinite(line.best) ? `to ${small(line.best)}` : 'nowhere'}`).join(', ');

/** @type {import('../types.js').Chart} */
export const numbers = {
  id: 'numbers', short: 'Number types', title: 'Number types: how far each reaches, and at what price',
  about: 'For each error, the fastest run of each number type. A line ends where rounding lets nobody come nearer.',
  make: (problem, points, look) => askedFor(points, look, {
    key: 'number', word: 'number type', title: `${problem.name}: number types`, sentence: (lines) => `${compared(lines)} They reach: ${reach(lines)}.`,
  }),
};
