// What one more digit costs, by method and number type.

import {column, count, factors, isNumber, plain, small} from '../format.js';
import {colourOf, fillOf} from '../look.js';
import {digitCost as costOf, digitCostBetween} from '../maths/digit_cost.js';
import {arrived, grouped} from '../maths/points.js';
import {categoryAxis, k_room, linearAxis} from './axes.js';
import {frame} from './frame.js';

/** @typedef {import('../types.js').Point} Point */
/** @typedef {{name: string, method: string, number: string, factor: number, from: number, to: number, runs: number, [range: string]: any}} Row */

/** @type {import('../types.js').Chart} */
export const digitCost = {
  id: 'digit-cost', short: 'One more digit', title: 'What one more digit costs',
  about: 'The factor in time for an error ten times as small, along the best runs of each method and number type.',
  make: picture,
};

const k_ranges = /** @type {[number, number, string][]} */ ([[1e-3, 1e-6, 'to 1e-6'], [1e-6, 1e-9, 'to 1e-9'], [1e-9, 1e-12, 'to 1e-12']]);

/** @param {Point[]} points @returns {Row[]} the cheapest digit first */
function rowsOf(points) {
  const rows = [];
  for (const [name, group] of grouped(arrived(points), ['method', 'number'])) {
    const cost = costOf(group);
    if (!cost) continue;
    const ranges = Object.fromEntries(k_ranges.map(([from, to, key]) => [key, digitCostBetween(group, from, to)]));
    rows.push({name, method: group[0].method, number: String(group[0].number), ...cost, ...ranges});
  }
  return rows.sort((a, b) => a.factor - b.factor);
}

/** @param {import('../types.js').FullProblem} problem @param {Point[]} points @param {import('../types.js').Look} look */
function picture(problem, points, look) {
  const rows = rowsOf(points);
  if (rows.length === 0) return 'No method has three runs on its front, a digit apart: the cost of a digit cannot be told.';
  const drawn = [...rows].reverse();
  const all = rows.map((row) => row.factor);
  return {
    option: frame(look, {
      title: `${problem.name}: time for one more digit`, left: 206,
      xAxis: linearAxis(look, 'factor in time for one more digit (1 would be free)', {low: Math.min(...all) < 1 ? 0 : 1, high: k_room * Math.max(...all), digits: [1, 5], label: (value) => `× ${plain(value)}`}),
      yAxis: categoryAxis(look, drawn.map(({name}) => name)), series: [bars(look, drawn, factors(all))],
    }),
    takeaway: takeaway(rows), note: 'Of each method only runs that no other run of it beats count; a line of least squares through log(time) over digits. '
      + 'Between two errors the cost is that of the front, read off at both.',
    table: tableOf(rows), height: 90 + 30 * rows.length,
    spots: drawn.map((row, index) => ({series: 0, index, detail: () => detail(row)})),
  };
}

/** @param {import('../types.js').Look} look @param {Row[]} rows @param {(value: number) => string} write */
const bars = (look, rows, write) => ({
  type: 'bar', barMaxWidth: 18, cursor: 'default',
  data: rows.map((row, ref) => {
    const colour = colourOf(look, row.method);
    return {value: row.factor, ref, itemStyle: {color: fillOf(look, row.number, colour), borderColor: colour, borderWidth: 1.4}};
  }),
  label: {show: true, position: 'right', color: look.ink, formatter: (/** @type {{value: number}} */ {value}) => write(value)},
});

/** @param {Row} row @returns {[string, string][]} */
const detail = (row) => [
  ['method', row.method], ['number type', row.number], ['one more digit', `${plain(row.factor)} times the time`],
  ['errors', `${small(row.from)} to ${small(row.to)}`], ['runs on the front', plain(row.runs)],
];

/** @param {Row[]} rows */
function takeaway(rows) {
  const [best, worst] = [rows[0], rows[rows.length - 1]];
  if (rows.length === 1) return `${best.name}: ${plain(best.factor)} times the time for one more digit.`;
  return `A digit costs least with ${best.name}: ${plain(best.factor)} times the time; most with ${worst.name}: ${plain(worst.factor)} times.`;
}

/** @param {Row[]} rows */
const tableOf = (rows) => ({
  caption: 'Factor in time for one more digit.', rows,
  columns: [
    {key: 'method', title: 'method'}, {key: 'number', title: 'number type'},
    {key: 'factor', title: 'over all', format: factors(rows.map((row) => row.factor)), numeric: true},
    ...k_ranges.filter(([, , key]) => rows.some((row) => isNumber(row[key]))).map(([from, , key]) => ({key, title: `${small(from)} ${key}`, format: factors(rows.map((row) => row[key])), numeric: true})),
    {key: 'from', title: 'largest error', format: column, numeric: true},
    {key: 'to', title: 'smallest error', format: column, numeric: true},
    {key: 'runs', title: 'runs', format: count, numeric: true},
  ],
});
