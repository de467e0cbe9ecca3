// All that is known of a run, in words: what hovering and focus show.

import {isNumber, k_missing, plain, seconds, small} from '../format.js';
import {k_settings} from '../maths/points.js';

/** @typedef {import('../types.js').Point} Point */

/** @param {Point} point @returns {(string | null | undefined | false)[]} what tells it apart from others, the method first */
const wordsOf = (point) => [
  point.method, point.number, point.formulation, point.code && point.code !== 'optimised' && `${point.code} code`, point.projection && point.projection !== 'none' && `projection ${point.projection}`, accuracyOf(point),
];

/** A run in a few words, for sentences. @param {Point} point */
export const briefly = (point) => wordsOf(point).filter(Boolean).join(', ');

/** The same without what all of `points` have in common, which `common` says. @param {Point[]} points */
export function brieflyBeside(points) {
  const all = points.map(wordsOf);
  const isCommon = all.length > 1 ? all[0].map((word, i) => i > 0 && all.every((words) => words[i] === word)) : [];
  const common = (all[0] ?? []).filter((word, i) => word && isCommon[i]).join(', ');
  return Object.assign((/** @type {Point} */ point) => wordsOf(point).filter((word, i) => word && !isCommon[i]).join(', '), {common: common && `All: ${common}.`});
}

/** @param {Point} point */
export function accuracyOf(point) {
  if (isNumber(point.tolerance)) return `tolerance ${small(point.tolerance)}`;
  return isNumber(point.step) ? `step ${small(point.step)} s` : 'no tolerance';
}

const k_status = {ok: 'ok', failed: 'failed', refused: 'refused'};

/** @param {Point} point */
export const statusOf = (point) => k_status[point.status] ?? String(point.status);

/** @param {Point} point */
function timeOf(point) {
  if (!isNumber(point.time_s)) return k_missing;
  const spread = isNumber(point.time_min_s) && isNumber(point.time_max_s) ? ` (${seconds(point.time_min_s)} to ${seconds(point.time_max_s)}` : '';
  const repeats = isNumber(point.repeats) ? `${spread ? ', ' : ' ('}${plain(point.repeats)} runs` : '';
  return `${seconds(point.time_s)}${spread}${repeats}${spread || repeats ? ')' : ''}`;
}

/** @param {Point} point @param {{onFront?: boolean}} [more] @returns {[string, string][]} */
export function detailOf(point, more = {}) {
  const found = /** @type {[string, string][]} */ ([]);
  const say = (/** @type {string} */ label, /** @type {any} */ value) => value !== null && value !== undefined && value !== '' && value !== k_missing && found.push([label, String(value)]);
  for (const [key, label] of k_settings) say(label, point[key]);
  say('tolerance', small(point.tolerance));
  say('step', isNumber(point.step) ? `${small(point.step)} s` : null);
  say('status', statusOf(point));
  say('why', point.why);
  say('error', small(point.error));
  say('worst output', point.worst_output);
  say('time', timeOf(point));
  say('calls', plain(point.calls));
  say('steps', plain(point.steps));
  say('rejected steps', plain(point.rejected));
  for (const [name, value] of Object.entries(point.drift ?? {})) say(`drift of ${name}`, small(value));
  if (more.onFront) say('Pareto front', 'yes');
  if (point.is_default) say('default', 'yes: what gauss-sim takes where nothing is said');
  return found;
}
