// Sets of effects that were run, and which of them an accuracy needs.

import {isNumber} from '../format.js';

/** @typedef {import('../types.js').Effects} Effects */
/** @typedef {import('../types.js').EffectSet} EffectSet */
/** @typedef {EffectSet & {change: number, operations: number}} MeasuredSet */

/** There is a motion with it. @param {EffectSet | undefined} one @returns {one is MeasuredSet} */
export const isMeasured = (one) => isNumber(one?.change) && isNumber(one?.operations);

export const namesIn = (/** @type {EffectSet} */ {effects}) => effects.length > 0 ? effects.join(', ') : 'none';

/** Whether any set can be shown. @param {Effects | null | undefined} effects @returns {effects is Effects} */
export const hasSets = (effects) => isMeasured(effects?.all);

/** All sets that were run, each once: that of all first, then those of the ladder, then others. @param {Effects} effects @returns {MeasuredSet[]} */
export function setsOf({all, none, each = [], ladder = []}) {
  const found = new Map();
  const named = [...(all ? [{...all, what: 'all'}] : []), ...ladder, ...each, ...(none ? [{...none, what: 'none'}] : [])];
  for (const one of named) if (isMeasured(one) && !found.has(namesIn(one))) found.set(namesIn(one), one);
  return [...found.values()];
}

/** As gauss-sim --need compares them: fewer operations, then fewer effects. @param {MeasuredSet} a @param {MeasuredSet} b */
const isCheaper = (a, b) => a.operations < b.operations || (a.operations === b.operations && a.effects.length < b.effects.length);

/**
 * What an accuracy needs, from the strictest on: `set` is the cheapest one for changes from `from` on, until the next takes its place.
 * @param {Effects} effects @returns {{from: number, set: MeasuredSet}[]}
 */
export function needed(effects) {
  const [all, ...others] = setsOf(effects);
  const picks = [{from: 0, set: all}];
  for (const set of others.sort((a, b) => a.change - b.change)) {
    const last = picks[picks.length - 1];
    if (!isCheaper(set, last.set)) continue;
    if (last.from === set.change) picks.pop();
    picks.push({from: set.change, set});
  }
  return picks;
}

/** @param {Effects} effects @param {number} change @returns {MeasuredSet} */
export const neededFor = (effects, change) => {
  const within = needed(effects).filter(({from}) => from <= change);
  return within[within.length - 1].set;
};
