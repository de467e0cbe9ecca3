// What each effect costs and changes: the run without it, beside the motion that it leaves.

import {counted, isNumber, plain, seconds, small} from '../format.js';
import {nth} from '../look.js';
import {hasSets, isMeasured} from '../maths/effects.js';
import {categoryAxis, k_room, linearAxis, logAxis, shortSeconds} from './axes.js';
import {changeOf, detailOfSet, setTable, whyNone} from './effect_table.js';
import {frame, k_plot_edges} from './frame.js';

/** @typedef {import('../types.js').Effects} Effects */
/** @typedef {import('../types.js').EffectSet} EffectSet */
/** @typedef {import('../types.js').Look} Look */
/** @typedef {import('../maths/effects.js').MeasuredSet} MeasuredSet */

/** @type {import('../types.js').Chart} */
export const effects = {
  id: 'effects', short: 'Effects', title: 'Effects: what each costs and changes',
  about: 'The scene with all its effects, and without each of them: what a run takes, and by how much the motion changes, relative to the range of the output that changes most.',
  make: (problem, _points, look) => hasSets(problem.effects) ? picture(problem.name, problem.effects, look) : whyNone(problem.effects),
};

/** @param {string} name @param {Effects} effects @param {Look} look */
function picture(name, effects, look) {
  const rows = rowsOf(effects);
  const drawn = rows.filter(isMeasured).reverse();
  const measured = drawn.filter(({what}) => what !== 'all');
  const x = logAxis(look, 'change of the motion', measured.map(({change}) => change));
  const times = linearAxis(look, 'time of a run', {low: 0, high: k_room * 1.2 * Math.max(...drawn.map(({run_seconds}) => Number(run_seconds))), label: shortSeconds});
  const names = drawn.map(({what}) => String(what));
  const option = frame(look, {
    title: `${name}: what effects cost and change`, xAxis: [{...times, gridIndex: 0}, {...x.axis, gridIndex: 1}], yAxis: [0, 1].map((gridIndex) => categoryAxis(look, names, {gridIndex})),
    series: [bars(look, drawn), changes(look, drawn, measured, x)],
  });
  const place = (/** @type {number} */ width) => panels(width, drawn.length, option);
  return {
    option: {...option, ...place(k_narrow)}, height: (/** @type {number} */ width) => heightOf(width, drawn.length),
    arrange: (/** @type {import('echarts/core').EChartsType} */ chart) => chart.setOption(place(chart.getWidth())),
    takeaway: takeaway(effects, measured), note: noteOf(effects), table: setTable(effects, 'All effects, and all but one.', rows),
    spots: drawn.map((one, index) => ({series: 0, index, detail: () => detailOfSet(effects, one)})),
  };
}

const k_narrow = 620;  // below, one panel stands below the other
const k_row = 30;
const k_panel_edges = k_plot_edges + 22;

/** @param {number} width @param {number} rows */
const heightOf = (width, rows) => (width < k_narrow ? 2 : 1) * (k_panel_edges + k_row * rows);

/** Costs and changes beside each other, with names once. @param {number} width @param {number} rows @param {any} option */
function panels(width, rows, option) {
  const {top, bottom, outerBoundsMode} = option.grid;
  const both = {top, height: k_row * rows, outerBoundsMode};
  const label = (/** @type {number} */ wide, show = true) => ({axisLabel: {show, width: wide, overflow: 'break', lineHeight: 14}});
  if (width >= k_narrow) return {grid: [{...both, left: 206, right: '48%'}, {...both, left: '57%', right: 40}], yAxis: [merged(option.yAxis[0], label(192)), merged(option.yAxis[1], label(192, false))]};
  const second = top + k_row * rows + bottom + 46;
  return {grid: [{...both, left: 120, right: 24}, {...both, top: second, left: 120, right: 24}], yAxis: option.yAxis.map((/** @type {any} */ axis) => merged(axis, label(106)))};
}

/** @param {any} axis @param {{axisLabel: object}} more */
const merged = (axis, {axisLabel}) => ({...axis, axisLabel: {...axis.axisLabel, ...axisLabel}});

/** @param {Effects} effects @returns {EffectSet[]} */
const rowsOf = ({all, each = [], none}) => [{.../** @type {EffectSet} */ (all), what: 'all'}, ...each, ...(none ? [{...none, what: 'none'}] : [])];

/** @param {Look} look @param {MeasuredSet[]} drawn */
function bars(look, drawn) {
  const {colour} = nth(look, 0);
  return {
    type: 'bar', name: 'time of a run', barMaxWidth: 18, cursor: 'default', xAxisIndex: 0, yAxisIndex: 0, itemStyle: {color: colour, borderColor: colour, borderWidth: 1.4},
    data: drawn.map((one, ref) => ({value: one.run_seconds ?? 0, ref})),
    label: {show: true, position: 'right', color: look.ink, formatter: (/** @type {{dataIndex: number}} */ {dataIndex}) => seconds(drawn[dataIndex].run_seconds)},
  };
}

/** Symbols, since a bar has no length on an axis without a 0. @param {Look} look @param {MeasuredSet[]} drawn @param {MeasuredSet[]} measured @param {ReturnType<typeof logAxis>} x */
function changes(look, drawn, measured, x) {
  const {colour, symbol} = nth(look, 1);
  const middle = (x.low + x.high) / 2;
  return {
    type: 'scatter', name: 'change of the motion', xAxisIndex: 1, yAxisIndex: 1, symbol, symbolSize: 12, cursor: 'default', itemStyle: {color: colour, borderColor: colour},
    data: measured.map((one) => {
      const at = x.at(one.change);
      return {value: [at, drawn.indexOf(one)], ref: drawn.indexOf(one), label: {show: true, position: at > middle ? 'left' : 'right', formatter: changeOf(one), color: look.ink}};
    }),
  };
}

/** @param {Effects} effects @param {MeasuredSet[]} measured */
function takeaway(effects, measured) {
  const single = measured.filter(({what}) => what !== 'none').sort((a, b) => b.change - a.change);
  if (single.length === 0) return 'There is a motion with all effects alone.';
  const [most, least] = [single[0], single[single.length - 1]];
  const all = /** @type {MeasuredSet} */ (effects.all);
  const text = `The motion changes most ${most.what}: ${changeOf(most)}`;
  if (most === least) return `${text}.`;
  return `${text}; least ${least.what}: ${changeOf(least)}, with ${plain(least.operations)} of ${counted(all.operations, 'operation')}.`;
}

/** @param {Effects} effects */
function noteOf({method, engine, duration, good_to, shared_operations: shared, each = []}) {
  const words = [`Runs of ${plain(duration)} s by ${method ?? 'an unknown method'}${engine ? ` (${engine})` : ''}.`];
  if (isNumber(good_to)) words.push(`The run with all effects is good to ${small(good_to)}: smaller changes say nothing.`);
  if (isNumber(shared)) words.push(`Operations that no effect saves by itself: ${plain(shared)}${shared < 0 ? ' (effects are in each other\'s way)' : ''}.`);
  const without = each.filter((one) => !isMeasured(one)).length;
  if (without > 0) words.push(`${counted(without, 'row')} of the table ${without === 1 ? 'has' : 'have'} no motion.`);
  return words.join(' ');
}
