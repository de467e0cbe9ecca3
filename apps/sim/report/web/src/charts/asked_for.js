// Error asked for against the cheapest time that reaches it, by one setting: formulation, number type, projection.

import {column, factors, plain, seconds, small} from '../format.js';
import {nth} from '../look.js';
import {alikeBut, arrived, cheapest, grouped, targets} from '../maths/points.js';
import {logAxis, shortSeconds} from './axes.js';
import {accuracyOf, detailOf} from './detail.js';
import {frame} from './frame.js';

/** @typedef {import('../types.js').Point} Point */
/** @typedef {import('../types.js').Look} Look */
/** @typedef {import('../types.js').Spot} Spot */
/** @typedef {{name: string, at: number, points: {target: number, point: Point, ratio: number}[], best: number, all: Point[]}} Line */
/** @typedef {{key: string, word: string, title: string, sentence: (lines: Line[]) => string, note?: string}} Setting */

/** @param {Point[]} points @param {Look} look @param {Setting} setting @returns {import('../types.js').Picture | string} */
export function askedFor(points, look, setting) {
  const alike = alikeBut(points, setting.key);
  const groups = grouped(alike.length > 0 ? alike : points, [setting.key]);
  if (groups.size === 0) return 'No runs are left: none was made, or the filters leave none.';
  if (groups.size === 1) return `All runs have the same ${setting.word}, ${[...groups.keys()][0]}: there is nothing to compare.`;
  const lines = linesOf([...groups.values()].flat(), groups);
  if (lines.every((line) => line.points.length === 0)) return 'No run reaches an error of 1e-3: there is nothing to compare.';
  const shown = lines.filter((line) => line.points.length > 0);
  const all = shown.flatMap((line) => line.points);
  const x = logAxis(look, 'error asked for (more exact to the right)', all.map(({target}) => target), {inverse: true});
  const y = logAxis(look, 'fastest time that reaches it', all.map(({point}) => point.time_s), {label: shortSeconds, gap: 58});
  const spots = /** @type {Spot[]} */ ([]);
  const series = shown.map((line, at) => seriesOf(line, at, look, spots, x.at, y.at));
  return {
    option: frame(look, {title: setting.title, xAxis: x.axis, yAxis: y.axis, series, left: 84}),
    takeaway: setting.sentence(lines), note: alike.length > 0 ? setting.note : 'They have no other settings in common: those of each are its own.', spots, height: 360, table: tableOf(lines, setting),
    key: {methods: [], numbers: [], extra: shown.map(({name, at}) => ({label: name, ...nth(look, at)}))},
  };
}

/** @param {Point[]} points @param {Map<string, Point[]>} groups @returns {Line[]} */
function linesOf(points, groups) {
  const asked = targets(points);
  const bestOf = new Map(asked.map((target) => [target, cheapest(points, target)]));
  return [...groups].map(([name, group], at) => ({
    name, at, all: group, best: Math.min(...arrived(group).map((point) => Number(point.error))),
    points: asked.flatMap((target) => {
      const point = cheapest(group, target);
      const best = bestOf.get(target);
      return point && best ? [{target, point, ratio: Number(point.time_s) / Number(best.time_s)}] : [];
    }),
  }));
}

/** @param {Line} line @param {number} at @param {Look} look @param {Spot[]} spots @param {(v: any) => number} x @param {(v: any) => number} y */
function seriesOf(line, at, look, spots, x, y) {
  const {colour, symbol, dash} = nth(look, line.at);
  const data = line.points.map(({target, point, ratio}, index) => {
    const detail = () => /** @type {[string, string][]} */ ([['error asked for', small(target)], ['beside the fastest', `${plain(ratio)} times`], ...detailOf(point)]);
    spots.push({series: at, index, detail});
    return {value: [x(target), y(point.time_s)], ref: spots.length - 1};
  });
  return {
    type: 'line', name: line.name, data, symbol, symbolSize: 9, showSymbol: true, cursor: 'default', z: 3,
    lineStyle: {color: colour, width: 2, type: dash}, itemStyle: {color: colour},
  };
}

/** @param {Line[]} lines @param {Setting} setting */
const tableOf = (lines, setting) => ({
  caption: `Fastest run of each ${setting.word} for an error asked for.`,
  columns: [
    {key: 'target', title: 'error asked for', format: (/** @type {any} */ v) => small(v), numeric: true}, {key: 'name', title: setting.word},
    {key: 'time', title: 'time', format: seconds, numeric: true}, {key: 'ratio', title: 'times the fastest', format: factors(lines.flatMap((line) => line.points.map(({ratio}) => ratio))), numeric: true},
    {key: 'method', title: 'method'}, {key: 'accuracy', title: 'setting'}, {key: 'error', title: 'error', format: column, numeric: true},
  ],
  rows: lines.flatMap((line) => line.points.map(({target, point, ratio}) => ({
    target, name: line.name, time: point.time_s, ratio, method: point.method, accuracy: accuracyOf(point), error: point.error,
  }))).sort((a, b) => b.target - a.target || a.ratio - b.ratio),
});

/** How the slowest stands beside the fastest where most of them arrive. @param {Line[]} lines @returns {string} */
export function compared(lines) {
  const common = [1e-6, 1e-9, 1e-3].find((target) => lines.filter((line) => line.points.some((entry) => entry.target === target)).length > 1);
  if (!common) return 'No two of them reach the same error.';
  const reached = lines.flatMap((line) => line.points.filter((entry) => entry.target === common).map((entry) => ({name: line.name, ...entry})))
    .sort((a, b) => a.ratio - b.ratio);
  const [best, worst] = [reached[0], reached[reached.length - 1]];
  return `For an error of ${small(common)}, ${best.name} is fastest (${seconds(best.point.time_s)}), and ${worst.name} takes ${plain(worst.ratio)} times as long.`;
}
