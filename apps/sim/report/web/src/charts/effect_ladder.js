// The ladder of effects: what the motion is off by when one after the other is left out, against what it costs.

import {counted, isNumber, plain, small} from '../format.js';
import {nth} from '../look.js';
import {hasSets, isMeasured, namesIn, needed, neededFor, setsOf} from '../maths/effects.js';
import {logAxis, shortSeconds} from './axes.js';
import {detailOfSet, part, setTable, whyNone} from './effect_table.js';
import {frame} from './frame.js';
import {freeLabel, placeLabels} from './free_label.js';

/** @typedef {import('../types.js').Effects} Effects */
/** @typedef {import('../types.js').Look} Look */
/** @typedef {import('../types.js').Spot} Spot */
/** @typedef {import('../maths/effects.js').MeasuredSet} MeasuredSet */
/** @typedef {(set: MeasuredSet) => [number, number]} Place */

/** @type {import('../types.js').Chart} */
export const effectLadder = {
  id: 'effect-ladder', short: 'Effect ladder', title: 'The effect ladder: model error removed against time paid',
  about: 'Each symbol is the scene with some of its effects. To the right the motion is nearer to that with all of them; up it takes longer.',
  make: (problem, _points, look) => hasSets(problem.effects) ? picture(problem.name, problem.effects, look) : whyNone(problem.effects),
};

const k_usual = 1e-3;

/** @param {string} name @param {Effects} effects @param {Look} look */
function picture(name, effects, look) {
  const sets = setsOf(effects).filter(({run_seconds}) => Number(run_seconds) > 0);
  if (sets.length < 2) return 'There is a motion with one set of effects alone: nothing can be left out.';
  const x = logAxis(look, 'model error (nearer to all effects to the right)', sets.map(({change}) => change), {inverse: true});
  const y = logAxis(look, 'time of a run', sets.map(({run_seconds}) => run_seconds), {label: shortSeconds, gap: 58});
  const marks = new Rungs(look, effects, (set) => [x.at(set.change), y.at(set.run_seconds)]);
  const rungs = (effects.ladder ?? []).filter(isMeasured).flatMap((rung) => sets.filter((set) => namesIn(set) === namesIn(rung)));
  const stairs = needed(effects).flatMap(({set}) => sets.filter((other) => namesIn(other) === namesIn(set)));
  marks.line('what an error needs', stairs, {color: look.accent, width: 8, opacity: 0.42, cap: 'round', join: 'round'}, 1);
  marks.line('left out in turn', rungs, {color: nth(look, 0).colour, width: 1.6}, 2);
  marks.symbols('left out in turn', rungs, true);
  marks.symbols('other sets', sets.filter((set) => !rungs.includes(set)), false);
  const isNoiseShown = isNumber(effects.good_to) && x.at(effects.good_to) > x.low;
  if (isNoiseShown) marks.noise(x.at(effects.good_to));
  const ringed = effects.need ? neededFor(effects, effects.need.change) : null;
  if (ringed) marks.ring(ringed);
  const labels = marks.labels(rungs);
  return {
    option: frame(look, {title: `${name}: the ladder of effects`, xAxis: x.axis, yAxis: y.axis, series: marks.series, left: 84}),
    takeaway: takeaway(effects), note: noteOf(x.hasZero, isNoiseShown, effects), height: 440, spots: marks.spots, table: tableOf(effects, rungs, sets),
    arrange: (/** @type {import('echarts/core').EChartsType} */ chart, /** @type {any} */ option) => placeLabels(chart, option, labels),
    key: {methods: [], numbers: [], extra: keyOf(look, effects, isNoiseShown, ringed !== null)},
  };
}

class Rungs {
  /** @param {Look} look @param {Effects} effects @param {Place} place */
  constructor(look, effects, place) {
    this.look = look;
    this.effects = effects;
    this.place = place;
    this.series = /** @type {any[]} */ ([]);
    this.spots = /** @type {Spot[]} */ ([]);
  }

  /** @param {string} name @param {MeasuredSet[]} sets @param {object} lineStyle @param {number} z */
  line(name, sets, lineStyle, z) {
    this.series.push({type: 'line', name, data: sets.map(this.place), silent: true, showSymbol: false, z, tooltip: {show: false}, lineStyle, itemStyle: {color: this.look.accent}});
  }

  /** @param {string} name @param {MeasuredSet[]} sets @param {boolean} full */
  symbols(name, sets, full) {
    const {colour, symbol} = nth(this.look, full ? 0 : 1);
    const data = sets.map((set, index) => {
      this.spots.push({series: this.series.length, index, detail: () => detailOfSet(this.effects, set)});
      return {value: this.place(set), ref: this.spots.length - 1};
    });
    this.series.push({type: 'scatter', name, data, z: 3, cursor: 'default', symbol, symbolSize: 11, emphasis: {scale: 1.5}, itemStyle: {color: full ? colour : this.look.surface, borderColor: colour, borderWidth: 1.6}});
  }

  /** Where the error of the run itself hides what effects change. @param {number} at */
  noise(at) {
    this.series.push({
      type: 'line', name: 'error of the run itself', data: [], silent: true, tooltip: {show: false},
      markLine: {silent: true, symbol: 'none', lineStyle: {color: this.look.muted, type: [5, 5], width: 1.4}, label: {show: false}, data: [{xAxis: at}]},
    });
  }

  /** @param {MeasuredSet} set */
  ring(set) {
    this.series.push({type: 'scatter', name: 'needed', data: [this.place(set)], silent: true, symbol: 'circle', symbolSize: 22, z: 4, tooltip: {show: false}, itemStyle: {color: 'transparent', borderColor: this.look.ink, borderWidth: 2}});
  }

  /** What each rung leaves out. @param {MeasuredSet[]} rungs */
  labels(rungs) {
    const labels = rungs.map((set) => ({text: String(set.what), at: this.place(set)}));
    this.series.push(...labels.map(({text}) => freeLabel(this.look, text)));
    return labels;
  }
}

/** @param {Look} look @param {Effects} effects @param {boolean} isNoiseShown @param {boolean} isRinged */
function keyOf(look, effects, isNoiseShown, isRinged) {
  const [rung, other] = [nth(look, 0), nth(look, 1)];
  return [
    {label: 'effects left out in turn', colour: rung.colour, symbol: rung.symbol, dash: 'solid'}, {label: 'other sets', colour: other.colour, symbol: other.symbol, fill: look.surface},
    {label: 'what an error needs: the fewest operations', colour: look.accent, dash: 'band'},
    ...(isNoiseShown ? [{label: 'error of the run itself', colour: look.muted, dash: [5, 5]}] : []),
    ...(isRinged ? [{label: `needed for ${small(effects.need?.change)}`, colour: look.ink, symbol: 'ring'}] : []),
  ];
}

/** @param {Effects} effects */
function takeaway(effects) {
  const change = effects.need?.change ?? k_usual;
  const [set, all] = [neededFor(effects, change), setsOf(effects)[0]];
  if (namesIn(set) === namesIn(all)) return `A model error of ${small(change)} needs all effects: ${counted(all.operations, 'operation')}.`;
  const share = Number(all.run_seconds) > 0 ? `, and ${plain(Number(set.run_seconds) / Number(all.run_seconds), 2)} of the time` : '';
  return `A model error of ${small(change)} needs ${namesIn(set)}: ${plain(set.operations)} of ${counted(all.operations, 'operation')}${share}.`;
}

/** @param {boolean} hasZero @param {boolean} isNoiseShown @param {Effects} effects */
function noteOf(hasZero, isNoiseShown, effects) {
  const words = ['Each rung leaves out the effect whose absence changes the motion least, of those that cost no more without it.'];
  if (hasZero) words.push('An error of 0, as that of all effects, is drawn at the end of the axis.');
  if (isNoiseShown) words.push('Right of the broken line the run with all effects has a larger error itself.');
  else if (isNumber(effects.good_to)) words.push(`The run with all effects is good to ${small(effects.good_to)}.`);
  return words.join(' ');
}

/** Which errors a set is needed for, in words. @param {Effects} effects @returns {Map<string, string>} by the names in the set */
function needsOf(effects) {
  const picks = needed(effects);
  return new Map(picks.map(({from, set}, i) => [namesIn(set), i + 1 === picks.length ? `from ${part(from)} on` : from === 0 ? `below ${part(picks[i + 1].from)}` : `${part(from)} to ${part(picks[i + 1].from)}`]));
}

/** The rungs, and what else an error may need. @param {Effects} effects @param {MeasuredSet[]} rungs @param {MeasuredSet[]} sets */
function tableOf(effects, rungs, sets) {
  const needs = needsOf(effects);
  const others = sets.filter((set) => !rungs.includes(set) && needs.has(namesIn(set)));
  const table = setTable(effects, 'Left out in turn, and what else an error may need.', [...rungs, ...others], [{key: 'needed', title: 'needed for errors'}]);
  return {...table, rows: table.rows.map((row) => ({...row, needed: needs.get(row.names) ?? ''}))};
}
