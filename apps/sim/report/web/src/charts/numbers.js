// Number types: what more digits in the arithmetic cost, and how far they reach.

import {plain, small} from '../format.js';
import {hadNoTime} from '../maths/points.js';
import {askedFor, compared} from './asked_for.js';

/** @param {import('./asked_for.js').Line} line */
function reachOf({name, best, all}) {
  const late = all.filter(hadNoTime).length;
  const untried = late > 0 ? ` (${plain(late)} of ${plain(all.length)} settings had no time)` : '';
  return `${name} ${Number.isFinite(best) ? `to ${small(best)}` : 'nowhere'}${untried}`;
}

/** @param {import('./asked_for.js').Line[]} lines */
const reach = (lines) => lines.map(reachOf).join(', ');

/** @type {import('../types.js').Chart} */
export const numbers = {
  id: 'numbers', short: 'Number types', title: 'Number types: how far each reaches, and at what price',
  about: 'For each error, the fastest run of each number type, all else alike. A line ends where rounding lets nobody come nearer, or where the time of the study was over.',
  make: (problem, points, look) => askedFor(points, look, {
    key: 'number', word: 'number type', title: `${problem.name}: number types`, sentence: (lines) => `${compared(lines)} They reach: ${reach(lines)}.`,
  }),
};
