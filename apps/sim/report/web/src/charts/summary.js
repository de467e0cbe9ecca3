// All problems beside each other: the fastest time for each error, and the setting that it takes.

import {column, count, counted, plain, seconds, small} from '../format.js';
import {nth} from '../look.js';
import {cheapest, tally, targets} from '../maths/points.js';
import {logAxis, shortSeconds} from './axes.js';
import {accuracyOf, detailOf} from './detail.js';
import {frame} from './frame.js';

/** @typedef {import('../types.js').FullProblem} FullProblem */
/** @typedef {import('../types.js').Look} Look */
/** @typedef {import('../types.js').Point} Point */
/** @typedef {{problem: FullProblem, target: number, point: Point, at: number}} Choice */

/** @param {FullProblem[]} problems @returns {Choice[]} the fastest run of each problem for each error that somebody reaches */
export const choices = (problems) => problems.flatMap((problem, at) => targets(problem.points).flatMap((target) => {
  const point = cheapest(problem.points, target);
  return point ? [{problem, target, point, at}] : [];
}));

/** @param {FullProblem[]} problems @returns {import('../types.js').Chart} */
export const summaryOf = (problems) => ({
  id: 'summary', short: 'Fastest settings', title: 'All problems: the fastest setting for each error',
  about: 'Of all runs of a problem, the fastest one whose error is not above the one asked for.',
  make: (_problem, _points, look) => picture(problems, look),
});

/** @param {FullProblem[]} problems @param {Look} look */
function picture(problems, look) {
  const found = choices(problems);
  if (found.length === 0) return 'No run of any problem reaches an error of 1e-3.';
  const x = logAxis(look, 'error asked for (more exact to the right)', found.map(({target}) => target), {inverse: true});
  const y = logAxis(look, 'fastest time', found.map(({point}) => point.time_s), {label: shortSeconds, gap: 58});
  const spots = found.map(spotOf);
  const series = problems.map((problem, at) => seriesOf(problem, at, found, spots, look, x.at, y.at)).filter(({data}) => data.length > 0);
  return {
    option: frame(look, {title: 'Fastest time for an error, by problem', xAxis: x.axis, yAxis: y.axis, series, left: 84}),
    takeaway: takeaway(problems), table: tableOf(found), height: 400, spots: numberedBySeries(spots, found),
    key: {methods: [], numbers: [], extra: problems.map((problem, at) => ({label: problem.name, ...nth(look, at)}))},
  };
}

/** @param {Choice} choice */
const spotOf = ({problem, target, point}) => ({
  series: 0, index: 0, detail: () => /** @type {[string, string][]} */ ([['problem', problem.name], ['error asked for', small(target)], ...detailOf(point)]),
});

/** @param {import('../types.js').Spot[]} spots @param {Choice[]} found */
function numberedBySeries(spots, found) {
  const seen = [...new Set(found.map(({at}) => at))];
  const next = seen.map(() => 0);
  found.forEach(({at}, i) => {
    spots[i].series = seen.indexOf(at);
    spots[i].index = next[spots[i].series]++;
  });
  return spots;
}

/** @param {FullProblem} problem @param {number} at @param {Choice[]} found @param {any[]} spots @param {Look} look @param {(v: any) => number} x @param {(v: any) => number} y */
function seriesOf(problem, at, found, spots, look, x, y) {
  const {colour, symbol, dash} = nth(look, at);
  const data = found.flatMap((choice, ref) => choice.problem === problem ? [{value: [x(choice.target), y(choice.point.time_s)], ref}] : []);
  return {
    type: 'line', name: problem.name, data, symbol, symbolSize: 9, showSymbol: true, cursor: 'default', lineStyle: {color: colour, width: 2, type: dash},
    itemStyle: {color: colour},
  };
}

const k_usual = 1e-9;

/** @param {FullProblem[]} problems */
function takeaway(problems) {
  const wins = new Map();
  let reached = 0;
  for (const problem of problems) {
    const best = cheapest(problem.points, k_usual);
    if (!best) continue;
    ++reached;
    wins.set(best.method, (wins.get(best.method) ?? 0) + 1);
  }
  if (reached === 0) return `No problem is solved to ${small(k_usual)}.`;
  const order = [...wins].sort((a, b) => b[1] - a[1]);
  const {runs, arrived, unmade} = tally(problems.flatMap(({points}) => points));
  return `For an error of ${small(k_usual)} the fastest method is ${order.map(([name, count]) => `${name} (${plain(count)} of ${plain(reached)} problems)`).join(', ')}. `
    + `${plain(arrived)} of ${counted(runs, 'run')} have a result${unmade > 0 ? `; ${plain(unmade)} more settings were not run` : ''}.`;
}

/** @param {Choice[]} found */
const tableOf = (found) => ({
  caption: 'Fastest setting for each error asked for.',
  columns: [
    {key: 'problem', title: 'problem'}, {key: 'target', title: 'error asked for', format: (/** @type {any} */ v) => small(v), numeric: true},
    {key: 'time', title: 'time', format: seconds, numeric: true}, {key: 'error', title: 'error', format: column, numeric: true},
    {key: 'method', title: 'method'}, {key: 'number', title: 'number type'}, {key: 'formulation', title: 'formulation'}, {key: 'code', title: 'code'}, {key: 'projection', title: 'projection'},
    {key: 'accuracy', title: 'setting'}, {key: 'calls', title: 'calls', format: count, numeric: true},
  ],
  rows: found.map(({problem, target, point}) => ({...point, problem: problem.name, target, time: point.time_s, accuracy: accuracyOf(point)})),
});
