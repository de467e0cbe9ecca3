// Error against cost, the cost being time or calls: what a more exact result is paid for with.

import {lostInWords} from '../counts.js';
import {isNumber, plain, small} from '../format.js';
import {arrived, cheapest, front, lost, made, tally, values} from '../maths/points.js';
import {logAxis} from './axes.js';
import {briefly} from './detail.js';
import {frame} from './frame.js';
import {Marks} from './marks.js';
import {runTable} from './run_table.js';

/** @typedef {import('../types.js').Point} Point */
/** @typedef {import('../types.js').Look} Look */
/** @typedef {import('../types.js').Picture} Picture */
/** @typedef {{title: string, of: (point: Point) => any, axis: string, label?: (value: number) => string, write: (value: any) => string, fewest: string, caption: string, more: string}} Cost */

/** @param {Point[]} points @param {Look} look @param {Cost} cost @returns {Picture | string} */
export function workPrecision(points, look, cost) {
  if (points.length === 0) return 'No runs are left: none was made, or the filters leave none.';
  const found = arrived(points).filter((point) => isNumber(cost.of(point)));
  const failed = lost(points);
  if (found.length === 0) return `None of ${plain(made(points).length)} runs has both an error and ${cost.axis.split(',')[0]}.`;
  const best = front(found, cost.of);
  const x = logAxis(look, 'error, relative to the range of an output (more exact to the right)', found.map((point) => point.error), {inverse: true, above: failed.length > 0 ? margin(found) : 0});
  const y = logAxis(look, cost.axis, points.map(cost.of).filter((value) => value > 0), {label: cost.label, gap: 58});
  const marks = new Marks(look, (point) => [x.at(point.error), y.at(cost.of(point))], new Set(best));
  marks.paretoLine(best);
  marks.runs(found, cost.of);
  marks.defaults(found);
  const top = x.axis.max;
  // Spread over the band by turns, so that failures of the same cost do not hide each other.
  const across = spread(failed, x.high + 0.15 * (top - x.high), top - 0.15 * (top - x.high));
  marks.failures(failed, (point) => [across(point), isNumber(cost.of(point)) ? y.at(cost.of(point)) : y.low + 0.03 * (y.high - y.low)], [{xAxis: x.high}, {xAxis: top}]);
  return {
    option: frame(look, {title: cost.title, xAxis: x.axis, yAxis: y.axis, series: marks.series, left: 84}),
    takeaway: takeaway(found, failed, cost),
    note: noteOf(x.hasZero, failed.length, points.length - found.length - failed.length, cost),
    table: runTable(points, best, cost.caption), spots: marks.spots, arrange: marks.arrange, height: 440,
    key: {methods: values(found, 'method'), numbers: values(found, 'number'), extra: extraKey(look, failed.length > 0)},
  };
}

/** Decades for the band of failures: a twelfth of the axis. @param {Point[]} found */
function margin(found) {
  const logs = found.map((point) => Number(point.error)).filter((value) => value > 0).map(Math.log10);
  return Math.max(0.5, (Math.max(...logs, 0) - Math.min(...logs, 0)) / 12);
}

/** @param {Point[]} points @param {number} low @param {number} high @returns {(point: Point) => number} */
function spread(points, low, high) {
  const at = new Map(points.map((point, i) => [point, low + (high - low) * ((i * 0.618034) % 1)]));
  return (point) => at.get(point) ?? low;
}

/** @param {Look} look @param {boolean} failures */
export const extraKey = (look, failures) => [
  {label: 'Pareto front: nobody is more exact at less cost', colour: look.accent, dash: 'band'},
  {label: 'default setting', colour: look.ink, symbol: 'ring'},
  ...(failures ? [{label: 'stopped or not run', colour: look.fault, symbol: 'cross'}] : []),
];

const k_usual = 1e-6;

/** @param {Point[]} found @param {Point[]} failed @param {Cost} cost */
function takeaway(found, failed, cost) {
  const target = cheapest(found, k_usual, cost.of) ? k_usual : Math.max(...[1, ...found.map((point) => Number(point.error))]);
  const best = cheapest(found, target, cost.of);
  const usual = found.find((point) => point.is_default);
  const lines = [best ? `${cost.fewest} for an error of ${small(target)}: ${briefly(best)} (${cost.write(cost.of(best))}).` : ''];
  if (usual) lines.push(besideDefault(usual, found, cost));
  lines.push(lostInWords(tally([...found, ...failed])));
  return lines.filter(Boolean).join(' ');
}

/** @param {Point} usual @param {Point[]} found @param {Cost} cost */
function besideDefault(usual, found, cost) {
  const best = cheapest(found, Number(usual.error), cost.of);
  if (!best || best === usual) return `The default setting is on the front, at ${small(usual.error)}.`;
  return `The default reaches ${small(usual.error)} with ${plain(cost.of(usual) / cost.of(best), 2)} times the ${cost.more} of the best.`;
}

/** @param {boolean} hasZero @param {number} failed @param {number} without @param {Cost} cost */
function noteOf(hasZero, failed, without, cost) {
  const lines = ['Lines join the runs of a method and number type that no other of them beats.'];
  if (hasZero) lines.push('An error of 0 is drawn at the end of the axis.');
  if (failed > 0) lines.push('What stopped on the way or was not run stands in the band at the left; at its bottom where nobody measured it.');
  if (without > 0) lines.push(`${plain(without)} runs do not say their ${cost.more} and are left out.`);
  return lines.join(' ');
}
