// What charts of effects have in common: their table, and what is said of one set.

import {count, isNumber, k_missing, plain, seconds, small} from '../format.js';
import {namesIn} from '../maths/effects.js';

/** @typedef {import('../types.js').Effects} Effects */
/** @typedef {import('../types.js').EffectSet} EffectSet */

/** Beside all effects: 1 where they cost the same. @param {Effects} effects @param {EffectSet} one */
const shareOf = (effects, one) => isNumber(one.run_seconds) && effects.all?.run_seconds ? one.run_seconds / effects.all.run_seconds : null;

const k_part = 0.01;

/** Parts of a range: 0.94, 3.5, and with a power of ten what is tiny. */
export const part = (/** @type {any} */ value) => isNumber(value) && value >= k_part ? plain(value, 2) : small(value);

/** What all effects are beside themselves is nothing. @param {EffectSet} one */
export const changeOf = (one) => isNumber(one.change) ? `${part(one.change)}${one.output ? ` of ${one.output}` : ''}` : k_missing;

/** @param {Effects} effects @param {EffectSet} one @param {[string, string][]} [more] @returns {[string, string][]} */
export function detailOfSet(effects, one, more = []) {
  const share = shareOf(effects, one);
  const lacks = one.lacks && one.lacks.length > 0 ? /** @type {[string, string][]} */ ([['without outputs', one.lacks.join(', ')]]) : [];
  return [
    ['set', String(one.what)], ['effects', namesIn(one)], ['changes the motion by', changeOf(one)], ['operations', count(one.operations)], ['call of the rates', isNumber(one.ns) ? `${plain(one.ns)} ns` : k_missing],
    ['run', seconds(one.run_seconds)], ['beside all', isNumber(share) ? `${plain(share)} of the time` : k_missing], ['calls in a run', count(one.calls)], ...lacks, ...more,
  ];
}

/** @param {Effects} effects @param {string} caption @param {EffectSet[]} rows @param {import('../types.js').Column[]} [more] behind the name of each */
export const setTable = (effects, caption, rows, more = []) => ({
  caption, rows: rows.map((one) => ({...one, names: namesIn(one), share: shareOf(effects, one)})),
  columns: [
    {key: 'what', title: 'set'}, ...more,
    {key: 'change', title: 'changes the motion by', format: part, numeric: true}, {key: 'output', title: 'of'},
    {key: 'operations', title: 'operations', format: count, numeric: true}, {key: 'ns', title: 'ns of a call', format: (/** @type {any} */ v) => isNumber(v) ? v.toPrecision(3) : k_missing, numeric: true},
    {key: 'run_seconds', title: 'run', format: seconds, numeric: true}, {key: 'share', title: 'time / all', format: (/** @type {any} */ v) => isNumber(v) ? v.toPrecision(2) : k_missing, numeric: true},
    {key: 'names', title: 'effects'}, ...(rows.some(({why}) => why) ? [{key: 'why', title: 'why not'}] : []),
  ],
});

/** Why nothing can be drawn. @param {Effects | null | undefined} effects */
export const whyNone = (effects) => effects?.why ? `Nobody measured what effects cost and change: ${effects.why}.` : 'Nobody measured what effects cost and change.';
