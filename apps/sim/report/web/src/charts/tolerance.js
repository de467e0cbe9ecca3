// Tolerance asked for against error delivered.

import {factors, isNumber, plain} from '../format.js';
import {front, lost, made, values} from '../maths/points.js';
import {logAxis} from './axes.js';
import {frame} from './frame.js';
import {Marks} from './marks.js';
import {runTable} from './run_table.js';

/** @typedef {import('../types.js').Point} Point */

/** @type {import('../types.js').Chart} */
export const tolerance = {
  id: 'tolerance', short: 'Tolerance → error', title: 'Tolerance → delivered error: what is asked for, and what comes',
  about: 'On the diagonal the error of the whole run is the tolerance of a step. Below it a run is better than asked for, above it worse.',
  make: picture,
};

/** @param {import('../types.js').FullProblem} problem @param {Point[]} points @param {import('../types.js').Look} look */
function picture(problem, points, look) {
  const asked = points.filter((point) => isNumber(point.tolerance));
  const found = asked.filter((point) => point.status === 'ok' && isNumber(point.error));
  if (found.length === 0) return 'No run with a tolerance has arrived: there is nothing to compare.';
  const failed = lost(asked);
  const tolerances = asked.map((point) => point.tolerance);
  const x = logAxis(look, 'tolerance asked for (stricter to the right)', tolerances, {inverse: true});
  const y = logAxis(look, 'error delivered', [...found.map((point) => point.error), ...tolerances], {above: failed.length > 0 ? 1 : 0, gap: 58});
  const best = front(points);
  const marks = new Marks(look, (point) => [x.at(point.tolerance), y.at(point.error)], new Set(best));
  marks.series.push(diagonal(look, x));
  marks.runs(found, null);
  marks.defaults(found);
  marks.failures(failed, (point) => [x.at(point.tolerance), y.high + 0.5], [{yAxis: y.high}, {yAxis: y.axis.max}]);
  return {
    option: frame(look, {title: `${problem.name}: tolerance and error`, xAxis: x.axis, yAxis: y.axis, series: marks.series, left: 84}),
    takeaway: takeaway(found), note: note(made(points).length - made(asked).length, y.hasZero), spots: marks.spots, arrange: marks.arrange, height: 440,
    table: tableOf(asked.map(withRatio), best),
    key: {methods: values(found, 'method'), numbers: values(found, 'number'), extra: [
      {label: 'error = tolerance', colour: look.muted, dash: [5, 5]}, {label: 'default setting', colour: look.ink, symbol: 'ring'},
      ...(failed.length > 0 ? [{label: 'stopped or not run', colour: look.fault, symbol: 'cross'}] : []),
    ]},
  };
}

/** @param {(Point & {ratio: number | null})[]} asked @param {Point[]} best */
const tableOf = (asked, best) => runTable(asked, best, 'Runs with a tolerance.', [{key: 'ratio', title: 'error / tolerance', format: factors(asked.map(({ratio}) => ratio)), numeric: true}]);

const ratioOf = (/** @type {Point} */ point) => Number(point.error) / Number(point.tolerance);
const withRatio = (/** @type {Point} */ point) => ({...point, ratio: isNumber(point.error) && point.tolerance ? ratioOf(point) : null});

/** @param {import('../types.js').Look} look @param {{low: number, high: number}} x */
const diagonal = (look, x) => ({
  type: 'line', name: 'error = tolerance', data: [[x.high, x.high], [x.low, x.low]], silent: true, showSymbol: false, z: 1, tooltip: {show: false},
  lineStyle: {color: look.muted, width: 1.4, type: [5, 5]}, itemStyle: {color: look.muted},
});

/** @param {Point[]} found */
function takeaway(found) {
  const ratios = found.filter((point) => Number(point.tolerance) > 0).map(ratioOf).sort((a, b) => a - b);
  if (ratios.length === 0) return 'No tolerance is above 0.';
  const worse = ratios.filter((ratio) => ratio > 10).length;
  const middle = ratios[Math.floor((ratios.length - 1) / 2)];
  return `Errors are ${plain(ratios[0], 2)} to ${plain(ratios[ratios.length - 1], 2)} times the tolerance, ${plain(middle, 2)} times in the middle of ${plain(ratios.length)} runs; `
    + (worse === 0 ? 'none is beyond ten times.' : `${plain(worse)} are beyond ten times.`);
}

/** @param {number} fixed @param {boolean} hasZero */
const note = (fixed, hasZero) => [
  fixed > 0 ? `${plain(fixed)} runs with steps of one length have no tolerance, and are not shown here.` : '',
  'All methods but taylor end a step at each sample: where samples are closer than steps would be, a looser tolerance changes nothing.',
  hasZero ? 'An error of 0 is drawn at the end of the axis.' : '',
].filter(Boolean).join(' ');
