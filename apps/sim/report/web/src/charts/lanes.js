// Batches: trajectories in lanes of one register, on several threads.

import {count, counted, factors, isNumber, plain} from '../format.js';
import {fillOf, nth} from '../look.js';
import {categoryAxis, k_room, linearAxis} from './axes.js';
import {frame} from './frame.js';

/** @typedef {import('../types.js').Lanes} Lanes */

/** @type {import('../types.js').Chart} */
export const lanes = {
  id: 'lanes', short: 'Batch lanes', title: 'Batch lanes: many trajectories at once',
  about: 'How many times as many trajectories in a second as one after the other on one thread.',
  make: picture,
};

const nameOf = (/** @type {Lanes} */ row) => `${row.number}, ${plain(row.lanes)} × ${plain(row.threads)}`;

/** @param {import('../types.js').FullProblem} problem @param {import('../types.js').Point[]} points @param {import('../types.js').Look} look */
function picture(problem, points, look) {
  const rows = problem.lanes.filter((row) => isNumber(row.ratio) || isNumber(row.trajectories_per_s));
  if (rows.length === 0) return 'No batches were measured.';
  const drawn = [...rows].reverse();
  return {
    option: frame(look, {
      title: `${problem.name}: trajectories at once`, left: 150, xAxis: linearAxis(look, 'times as many trajectories in a second', {low: 0, high: k_room * Math.max(0, ...rows.map(({ratio}) => Number(ratio)))}),
      yAxis: categoryAxis(look, drawn.map(nameOf)), series: [bars(look, drawn, [...new Set(rows.map(({number}) => number))])],
    }),
    takeaway: takeaway(rows), note: 'A row is number type, lanes × threads.', height: 90 + 30 * rows.length, table: tableOf(rows),
    spots: drawn.map((row, index) => ({series: 0, index, detail: () => detail(row)})),
  };
}

/** @param {import('../types.js').Look} look @param {Lanes[]} rows @param {string[]} numbers in the order of the study */
function bars(look, rows, numbers) {
  return {
    type: 'bar', barMaxWidth: 18, cursor: 'default',
    data: rows.map((row, ref) => {
      const {colour} = nth(look, numbers.indexOf(row.number));
      return {value: row.ratio, ref, itemStyle: {color: fillOf(look, row.number, colour), borderColor: colour, borderWidth: 1.4}};
    }),
    label: {show: true, position: 'right', color: look.ink, formatter: (/** @type {{value: any}} */ {value}) => isNumber(value) ? `× ${plain(value)}` : ''},
  };
}

/** @param {Lanes} row @returns {[string, string][]} */
const detail = (row) => [
  ['number type', row.number], ['lanes', plain(row.lanes)], ['threads', plain(row.threads)], ['trajectories', plain(row.trajectories)],
  ['trajectories in a second', plain(row.trajectories_per_s)], ['beside one at a time', isNumber(row.ratio) ? `${plain(row.ratio)} times` : 'not known'],
];

/** @param {Lanes[]} rows */
function takeaway(rows) {
  const best = rows.reduce((a, b) => Number(b.trajectories_per_s) > Number(a.trajectories_per_s) ? b : a);
  return `Most in a second: ${plain(best.trajectories_per_s)} trajectories, with ${best.number} in ${counted(best.lanes, 'lane')} on ${counted(best.threads, 'thread')}`
    + (isNumber(best.ratio) ? `, ${plain(best.ratio)} times as many as one at a time.` : '.');
}

/** @param {Lanes[]} rows */
const tableOf = (rows) => ({
  caption: 'Batches.', rows,
  columns: [{key: 'number', title: 'number type'}, ...[['lanes', 'lanes'], ['threads', 'threads'], ['trajectories', 'trajectories'], ['trajectories_per_s', 'in a second'], ['ratio', 'ratio']]
    .map(([key, title]) => ({key, title, format: key === 'ratio' ? factors(rows.map(({ratio}) => ratio)) : count, numeric: true}))],
});
