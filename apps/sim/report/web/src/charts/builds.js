// What has to be paid before the first run: generation and compilation, apart.

import {count, isNumber, plain, seconds} from '../format.js';
import {mixed} from '../look.js';
import {categoryAxis, linearAxis} from './axes.js';
import {frame} from './frame.js';

/** @typedef {import('../types.js').Build} Build */

/** @type {import('../types.js').Chart} */
export const builds = {
  id: 'builds', short: 'Generation and compilation', title: 'Generation and compilation: paid once, before the first run',
  about: 'Times of the generator and of the compiler, which no time of a run contains.',
  make: picture,
};

/** @param {import('../types.js').FullProblem} problem @param {import('../types.js').Point[]} points @param {import('../types.js').Look} look */
function picture(problem, points, look) {
  const rows = problem.builds.filter((row) => isNumber(row.generate_s) || isNumber(row.compile_s));
  if (rows.length === 0) return 'Nobody measured generation and compilation.';
  const drawn = [...rows].reverse();
  const parts = [
    part(look, 'generation', drawn.map((row) => row.generate_s), look.colours[0], look.colours[0], 0),
    part(look, 'compilation', drawn.map((row) => row.compile_s), mixed(look.colours[1], look.surface, 0.3), look.colours[1], drawn.length),
  ];
  return {
    option: frame(look, {
      title: `${problem.name}: generation and compilation`, left: 206, xAxis: linearAxis(look, 'time, s', {low: 0, high: Math.max(...rows.map(sum))}),
      yAxis: categoryAxis(look, drawn.map(({formulation, number}) => `${formulation}, ${number}`)), series: parts,
    }),
    takeaway: takeaway(rows), height: 90 + 30 * rows.length, table: tableOf(rows),
    spots: [0, 1].flatMap((series) => drawn.map((row, index) => ({series, index, detail: () => detail(row)}))),
    key: {methods: [], numbers: [], extra: parts.map(({name, itemStyle}) => ({label: name, colour: itemStyle.borderColor, fill: itemStyle.color, symbol: 'rect'}))},
  };
}

/** @param {import('../types.js').Look} look @param {string} name @param {(number | null)[]} values @param {string} fill @param {string} edge @param {number} first */
const part = (look, name, values, fill, edge, first) => ({
  type: 'bar', name, stack: 'all', barMaxWidth: 18, cursor: 'default', itemStyle: {color: fill, borderColor: edge, borderWidth: 1.4},
  data: values.map((value, i) => ({value: value ?? 0, ref: first + i})),
});

/** @param {Build} row @returns {[string, string][]} */
const detail = (row) => [
  ['formulation', row.formulation], ['number type', row.number], ['generation', seconds(row.generate_s)], ['compilation', seconds(row.compile_s)],
  ['operations of the right-hand side', plain(row.operations)],
];

const sum = (/** @type {Build} */ row) => Number(row.generate_s) + Number(row.compile_s);

/** @param {Build[]} rows */
function takeaway(rows) {
  const best = rows.reduce((a, b) => sum(b) < sum(a) ? b : a);
  return `Ready soonest: ${best.formulation} in ${best.number}, generated in ${seconds(best.generate_s)} and compiled in ${seconds(best.compile_s)}.`;
}

/** @param {Build[]} rows */
const tableOf = (rows) => ({
  caption: 'Generation and compilation.', rows,
  columns: [
    {key: 'formulation', title: 'formulation'}, {key: 'number', title: 'number type'}, {key: 'generate_s', title: 'generation', format: seconds, numeric: true},
    {key: 'compile_s', title: 'compilation', format: seconds, numeric: true}, {key: 'operations', title: 'operations', format: count, numeric: true},
  ],
});
