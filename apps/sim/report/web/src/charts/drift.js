// Drift of one invariant, or of the constraints, over time. There is a chart for each that the study has.

import {column, count, isNumber, plain, small} from '../format.js';
import {colourOf, dashOf, nth} from '../look.js';
import {linearAxis, logAxis} from './axes.js';
import {brieflyBeside, detailOf} from './detail.js';
import {endLabels} from './end_labels.js';
import {frame} from './frame.js';

/** @typedef {import('../types.js').Point} Point */
/** @typedef {import('../types.js').Drift} Drift */
/** @typedef {import('../types.js').Look} Look */
/** @typedef {import('../types.js').FullProblem} FullProblem */
/** @typedef {{name: string, rank: number, point: Point | null, t: number[], sizes: number[], soFar: number[], stroke: Stroke}} Curve `soFar`: the largest one up to each time */
/** @typedef {{colour: string, dash: string | number[], symbol: string}} Stroke */

const k_first = 6;  // curves, and more on demand
const k_height = 340;

/** What drifts are told of: energy and constraints first. @param {FullProblem} problem */
export function drifting(problem) {
  const names = new Set(['energy', 'constraints']);
  for (const drift of problem.drifts) for (const key of Object.keys(drift)) if (key !== 'point' && key !== 't' && Array.isArray(drift[key])) names.add(key);
  return [...names];
}

/** @param {string} name @returns {import('../types.js').Chart} */
export const driftOf = (name) => ({
  id: `drift-${name.replace(/[^A-Za-z0-9]+/g, '-')}`, short: `Drift: ${name}`, title: `Drift of ${name} over time`,
  about: `The largest drift of ${name} up to each time of the motion, in some of the runs.`,
  make: (problem, points, look, all = false) => picture(name, problem, points, look, all),
});

/** @param {string} name @param {Drift} drift @param {Point | null} point @param {Stroke} stroke @returns {Curve} */
function curveOf(name, drift, point, stroke) {
  const pairs = drift.t.map((t, i) => [t, drift[name][i]]).filter(([t, value]) => isNumber(t) && isNumber(value));
  const sizes = pairs.map(([, value]) => Math.abs(value));
  let most = 0;
  return {name: `run ${drift.point}`, rank: 0, point, t: pairs.map(([t]) => Number(t)), sizes, soFar: sizes.map((size) => most = Math.max(most, size)), stroke};
}

/** @param {string} name @param {FullProblem} problem @param {Point[]} points @param {Look} look @returns {Curve[]} of runs that the filters leave, the largest drift first */
function curvesOf(name, problem, points, look) {
  const left = new Set(points.map(({id}) => id));
  const byId = new Map(problem.points.map((point) => [point.id, point]));
  const recorded = problem.drifts.filter((drift) => Array.isArray(drift[name]) && Array.isArray(drift.t));
  const strokes = strokesOf(recorded.map(({point}) => byId.get(point) ?? null), look);
  const curves = recorded.map((drift, i) => curveOf(name, drift, byId.get(drift.point) ?? null, strokes[i]))
    .filter(({t}, i) => t.length > 0 && (left.has(recorded[i].point) || !byId.has(recorded[i].point)));
  const say = brieflyBeside(curves.flatMap(({point}) => point ?? []));
  curves.sort((a, b) => last(b.soFar) - last(a.soFar));
  return curves.map((curve, i) => ({...curve, rank: i + 1, name: curve.point ? say(curve.point) : curve.name}));
}

const last = (/** @type {number[]} */ values) => values[values.length - 1];

/**
 * The first run of a method has its colour; others of it have colours that no method here has. They stay whichever runs are shown.
 * @param {(Point | null)[]} points @param {Look} look @returns {Stroke[]}
 */
function strokesOf(points, look) {
  const methods = [...new Set(points.flatMap((point) => point ? [point.method] : []))];
  const taken = methods.map((method) => colourOf(look, method));
  const spare = look.colours.filter((colour) => !taken.includes(colour));
  let next = 0;
  return points.map((point, i) => {
    const isFirst = point !== null && points.findIndex((other) => other?.method === point.method) === i;
    const colour = isFirst ? colourOf(look, point.method) : spare[next++ % spare.length];
    return {colour, symbol: nth(look, i).symbol, dash: point ? dashOf(look, String(point.number)) : 'solid'};
  });
}

const alikeIn = (/** @type {Curve} */ {soFar}) => [0.25, 0.5, 1].map((part) => small(soFar[Math.round(part * (soFar.length - 1))])).join();

/** The default, the most and the least, and others evenly between them; of such as lie on each other the first. @param {Curve[]} curves by size @returns {Curve[]} */
function firstOf(curves) {
  const usual = curves.find(({point}) => point?.is_default);
  const seen = new Set(usual ? [alikeIn(usual)] : []);
  const others = curves.filter((curve) => curve !== usual && !seen.has(alikeIn(curve)) && seen.add(alikeIn(curve)));
  const wanted = usual ? k_first - 1 : k_first;
  const chosen = others.length <= wanted ? new Set(others) : new Set(Array.from({length: wanted}, (_, k) => others[Math.round(k * (others.length - 1) / (wanted - 1))]));
  return curves.filter((curve) => curve === usual || chosen.has(curve));
}

const k_rounding = /** @type {Record<string, number>} */ ({float: 6e-8, double: 1.1e-16, 'long-double': 5.4e-20, float128: 9.6e-35});

/** What is worth looking at: down to a tenth of the rounding of the number type, or to a hundredth of what a run drifts. @param {Curve[]} curves */
function leastOf(curves) {
  const most = Math.max(...curves.map(({soFar}) => last(soFar)));
  const least = curves.filter(({soFar}) => last(soFar) > 0).map(({soFar, point}) => Math.max(0.01 * last(soFar), 0.1 * (k_rounding[String(point?.number)] ?? 0)));
  return Math.min(...least, 0.1 * most);
}

/** @param {string} name @param {FullProblem} problem @param {Point[]} points @param {Look} look @param {boolean} all */
function picture(name, problem, points, look, all) {
  const curves = curvesOf(name, problem, points, look);
  if (curves.length === 0) return nothing(name, problem);
  const most = Math.max(...curves.map(({soFar}) => last(soFar)));
  if (most === 0) return `${name[0].toUpperCase()}${name.slice(1)}: 0 at all times, in each of ${curves.length} recorded runs.`;
  const shown = all || curves.length <= k_first ? curves : firstOf(curves);
  const y = logAxis(look, `drift of ${name} so far`, [leastOf(curves), most], {gap: 58, clipped: true});
  const end = Math.max(...curves.flatMap((curve) => curve.t));
  const spots = shown.map((curve, series) => spotsOf(curve, series, name));
  const before = shown.map((_, i) => spots.slice(0, i).reduce((sum, some) => sum + some.length, 0));
  const drawn = [...shown.map((curve, i) => seriesOf(curve, y.at, before[i])), endLabels(look, shown.map((curve) => ({text: String(curve.rank), x: end, y: y.at(last(curve.soFar))})), [y.low, y.high], k_height)];
  return {
    option: frame(look, {title: `${problem.name}: drift of ${name}`, xAxis: linearAxis(look, 'time of the motion, s', {low: 0, high: end, ends: true}, {splitLine: {show: false}}), yAxis: y.axis, series: drawn, left: 84, right: 64}),
    takeaway: takeaway(name, curves), note: noteOf(shown.length, curves.length, y.low),
    table: tableOf(name, curves), height: k_height, spots: spots.flat(), more: curves.length > k_first ? {drawn: shown.length, all: curves.length, word: 'curves'} : undefined,
    key: {methods: [], numbers: [], extra: shown.map(({rank, name: of, stroke}) => ({label: `${rank}: ${of}`, ...stroke}))},
  };
}

/** @param {number} shown @param {number} all @param {number} low exponent of the end of the axis */
function noteOf(shown, all, low) {
  const lines = ['A curve is the largest drift up to a time, so that a drift that passes through 0 is not taken for a small one. Numbers at the ends are those of the key and of the table.'];
  if (shown < all) lines.push(`${plain(shown)} of ${plain(all)} curves are drawn: the default, the most, the least, and some between them; of those that lie on each other one. The table has all.`);
  lines.push(`What is below ${small(10 ** low)} is drawn at the lower end of the axis: it is far below rounding, or below a hundredth of the least that a run drifts.`);
  return lines.join(' ');
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

const k_symbols = 12;

/** @param {Curve} curve */
const stride = (curve) => Math.max(1, Math.floor(curve.t.length / k_symbols));

/** By turns, so that of curves which lie on each other all symbols are seen. @param {Curve} curve */
const phase = (curve) => Math.floor((curve.rank - 1) % 3 * stride(curve) / 3);

/** @param {Curve} curve @param {(v: any) => number} at @param {number} first its first spot */
function seriesOf(curve, at, first) {
  const {colour, dash, symbol} = curve.stroke;
  const [every, begin] = [stride(curve), phase(curve)];
  return {
    type: 'line', name: curve.name, cursor: 'default', z: 2, symbol, showAllSymbol: true, lineStyle: {color: colour, width: 2, type: dash}, itemStyle: {color: colour},
    data: curve.t.map((t, i) => ({value: [t, at(curve.soFar[i])], symbolSize: i % every === begin ? 8 : 0, ref: first + Math.max(0, Math.floor((i - begin) / every))})),
  };
}

/** Every twelfth of the time can be pointed at. @param {Curve} curve @param {number} series @param {string} name */
function spotsOf(curve, series, name) {
  const [every, begin] = [stride(curve), phase(curve)];
  return curve.t.flatMap((t, index) => index % every !== begin ? [] : [{
    series, index, detail: () => /** @type {[string, string][]} */ ([
      ['time of the motion', `${small(t, 3)} s`], [`drift of ${name} so far`, small(curve.soFar[index])], ['at this time', small(curve.sizes[index])], ...(curve.point ? detailOf(curve.point) : [['run', curve.name]]),
    ]),
  }]);
}

/** @param {string} name @param {Curve[]} curves the largest first */
function takeaway(name, curves) {
  const say = (/** @type {Curve} */ curve) => `${curve.name} (${small(last(curve.soFar))} at most)`;
  const [worst, best] = [curves[0], curves[curves.length - 1]];
  return curves.length === 1 ? `${say(best)}.` : `Least drift of ${name}: ${say(best)}; most: ${say(worst)}.`;
}

/** @param {string} name @param {Curve[]} curves */
const tableOf = (name, curves) => ({
  caption: [`Drift of ${name} at half time, at the end, and at most.`, brieflyBeside(curves.flatMap(({point}) => point ?? [])).common].filter(Boolean).join(' '),
  columns: [
    {key: 'rank', title: 'no.', numeric: true}, {key: 'name', title: 'run'}, ...[['half', 'at half time'], ['end', 'at the end'], ['most', 'at most']]
      .map(([key, title]) => ({key, title, format: column, numeric: true})),
    {key: 'samples', title: 'samples', format: count, numeric: true},
  ],
  rows: curves.map(({rank, name: of, sizes, soFar}) => ({rank, name: of, half: sizes[Math.floor(sizes.length / 2)], end: last(sizes), most: last(soFar), samples: sizes.length})),
});
