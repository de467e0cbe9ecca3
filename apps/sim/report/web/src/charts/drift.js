// Drift of one invariant, or of the constraints, over time. There is a chart for each that the study has.

import {column, isNumber, small} from '../format.js';
import {colourOf, dashOf, nth} from '../look.js';
import {linearAxis, logAxis} from './axes.js';
import {briefly, detailOf} from './detail.js';
import {frame} from './frame.js';

/** @typedef {import('../types.js').Point} Point */
/** @typedef {import('../types.js').Drift} Drift */
/** @typedef {import('../types.js').Look} Look */
/** @typedef {import('../types.js').FullProblem} FullProblem */
/** @typedef {{name: string, point: Point | null, t: number[], sizes: number[], at: number}} Curve */

/** What drifts are told of: energy and constraints first. @param {FullProblem} problem */
export function drifting(problem) {
  const names = new Set(['energy', 'constraints']);
  for (const drift of problem.drifts) for (const key of Object.keys(drift)) if (key !== 'point' && key !== 't' && Array.isArray(drift[key])) names.add(key);
  return [...names];
}

/** @param {string} name @returns {import('../types.js').Chart} */
export const driftOf = (name) => ({
  id: `drift-${name.replace(/[^A-Za-z0-9]+/g, '-')}`, short: `Drift: ${name}`, title: `Drift of ${name} over time`,
  about: `How far ${name} ${name.endsWith('s') ? 'are' : 'is'} off as the motion goes on, in some of the runs.`,
  make: (problem, points, look) => picture(name, problem, points, look),
});

/** @param {string} name @param {FullProblem} problem @param {Point[]} points @returns {Curve[]} of runs that the filters leave */
function curvesOf(name, problem, points) {
  const byId = new Map(points.map((point) => [point.id, point]));
  const known = new Set(problem.points.map(({id}) => id));
  return problem.drifts.filter((drift) => Array.isArray(drift[name]) && Array.isArray(drift.t) && (byId.has(drift.point) || !known.has(drift.point)))
    .map((drift, at) => {
      const point = byId.get(drift.point) ?? null;
      const pairs = drift.t.map((t, i) => [t, drift[name][i]]).filter(([t, value]) => isNumber(t) && isNumber(value));
      return {name: point ? briefly(point) : `run ${drift.point}`, point, t: pairs.map(([t]) => t), sizes: pairs.map(([, value]) => Math.abs(value)), at};
    }).filter((curve) => curve.t.length > 0);
}

/** @param {string} name @param {FullProblem} problem @param {Point[]} points @param {Look} look */
function picture(name, problem, points, look) {
  const curves = curvesOf(name, problem, points);
  if (curves.length === 0) return nothing(name, problem);
  const sizes = curves.flatMap((curve) => curve.sizes);
  if (sizes.every((size) => size === 0)) return `${name[0].toUpperCase()}${name.slice(1)}: 0 at all times, in each of ${curves.length} recorded runs.`;
  const y = logAxis(look, `drift of ${name}`, sizes, {gap: 58});
  const end = Math.max(...curves.flatMap((curve) => curve.t));
  const xAxis = linearAxis(look, 'time of the motion, s', {low: 0, high: end, ends: true}, {splitLine: {show: false}});
  const spots = curves.map((curve, series) => spotsOf(curve, series, name));
  const before = curves.map((_, i) => spots.slice(0, i).reduce((sum, some) => sum + some.length, 0));
  const drawn = curves.map((curve, i) => seriesOf(curve, look, y.at, before[i]));
  return {
    option: frame(look, {title: `${problem.name}: drift of ${name}`, xAxis, yAxis: y.axis, series: drawn, left: 84}),
    takeaway: takeaway(name, curves), note: y.hasZero ? 'No drift at all is drawn at the lower end of the axis.' : '',
    table: tableOf(name, curves), height: 320, spots: spots.flat(),
    key: {methods: [], numbers: [], extra: curves.map((curve) => ({label: curve.name, ...strokeOf(curve, look)}))},
  };
}

/** @param {string} name @param {FullProblem} problem */
function nothing(name, problem) {
  const isRecorded = problem.drifts.length === 0 || problem.drifts.some((drift) => Array.isArray(drift[name]));
  if (isRecorded || !(name in k_why_none)) return `No run that is shown has a record of ${name} over time.`;
  return k_why_none[/** @type {keyof typeof k_why_none} */ (name)];
}

const k_why_none = {
  energy: 'The energy of this model may change, by forces, inputs or time: there is nothing that it drifts from.',
  constraints: 'The model has no constraints that could drift.',
};

/** Runs of one method with other settings have its colour, and other symbols. @param {Curve} curve @param {Look} look */
function strokeOf(curve, look) {
  const other = nth(look, curve.at);
  return curve.point ? {colour: colourOf(look, curve.point.method), dash: dashOf(look, String(curve.point.number)), symbol: other.symbol} : other;
}

const k_symbols = 12;

/** @param {Curve} curve */
const stride = (curve) => Math.max(1, Math.floor(curve.t.length / k_symbols));

/** @param {Curve} curve @param {Look} look @param {(v: any) => number} at @param {number} first its first spot */
function seriesOf(curve, look, at, first) {
  const {colour, dash, symbol} = strokeOf(curve, look);
  const every = stride(curve);
  return {
    type: 'line', name: curve.name, cursor: 'default', z: 2, symbol, showAllSymbol: true, lineStyle: {color: colour, width: 1.6, type: dash}, itemStyle: {color: colour},
    data: curve.t.map((t, i) => ({value: [t, at(curve.sizes[i])], symbolSize: i % every === 0 ? 7 : 0, ref: first + Math.floor(i / every)})),
  };
}

/** Every twelfth of the time can be pointed at. @param {Curve} curve @param {number} series @param {string} name */
function spotsOf(curve, series, name) {
  const every = stride(curve);
  return curve.t.flatMap((t, index) => index % every !== 0 ? [] : [{
    series, index, detail: () => /** @type {[string, string][]} */ ([
      ['time of the motion', `${small(t, 3)} s`], [`drift of ${name}`, small(curve.sizes[index])], ...(curve.point ? detailOf(curve.point) : [['run', curve.name]]),
    ]),
  }]);
}

const last = (/** @type {Curve} */ curve) => curve.sizes[curve.sizes.length - 1];

/** @param {string} name @param {Curve[]} curves */
function takeaway(name, curves) {
  const sorted = [...curves].sort((a, b) => Math.max(...a.sizes) - Math.max(...b.sizes));
  const [best, worst] = [sorted[0], sorted[sorted.length - 1]];
  const say = (/** @type {Curve} */ curve) => `${curve.name} (${small(Math.max(...curve.sizes))} at most)`;
  return curves.length === 1 ? `${say(best)}.` : `Least drift of ${name}: ${say(best)}; most: ${say(worst)}.`;
}

/** @param {string} name @param {Curve[]} curves */
const tableOf = (name, curves) => ({
  caption: `Drift of ${name} at half time, at the end, and at most.`,
  columns: [
    {key: 'name', title: 'run'}, ...[['half', 'at half time'], ['end', 'at the end'], ['most', 'at most']]
      .map(([key, title]) => ({key, title, format: column, numeric: true})),
    {key: 'samples', title: 'samples', numeric: true},
  ],
  rows: curves.map((curve) => ({
    name: curve.name, half: curve.sizes[Math.floor(curve.sizes.length / 2)], end: last(curve), most: Math.max(...curve.sizes), samples: curve.sizes.length,
  })),
});
