// What charts ask points for.

import {isNumber} from '../format.js';
import {paretoFront} from './pareto.js';

/** @typedef {import('../types.js').Point} Point */

/** The settings that a point may differ in, with the words for them. */
export const k_settings = /** @type {[keyof Point & string, string][]} */ ([
  ['method', 'method'], ['library', 'library'], ['formulation', 'formulation'], ['code', 'code'], ['number', 'number type'],
  ['projection', 'projection'], ['engine', 'engine'],
]);

export const error = (/** @type {Point} */ point) => point.error;
export const time = (/** @type {Point} */ point) => point.time_s;
export const calls = (/** @type {Point} */ point) => point.calls ?? null;

/** Settings of which a run was begun: what counts as a run wherever runs are counted. @param {Point[]} points */
export const made = (points) => points.filter(({status}) => status !== 'refused');

/** Not run at all, for the time that the study had. @param {Point} point */
export const hadNoTime = (point) => point.status === 'refused' && /time that the study/.test(point.why ?? '');

/** The settings that runs are told apart by, and their words for one and for many. */
export const k_choices = /** @type {[string, string, string][]} */ ([
  ['method', 'method', 'methods'], ['number', 'number type', 'number types'], ['formulation', 'formulation', 'formulations'], ['projection', 'projection', 'projections'],
]);

/** Choices of a setting of which no run was begun. @param {Point[]} points @param {string} key @returns {[string, Point[]][]} */
const neverBegun = (points, key) => [...grouped(points, [key])].filter(([, group]) => group.every(({status}) => status === 'refused'));

/** What is left to look at: nothing is compared with what was never begun. @param {Point[]} points */
export function begun(points) {
  const none = k_choices.map(([key]) => /** @type {[string, Set<string>]} */ ([key, new Set(neverBegun(points, key).map(([name]) => name))]));
  return points.filter((point) => none.every(([key, names]) => !names.has(settingOf(point, key))));
}

/** Choices without a run, by their reasons, in words. @param {Point[]} points @returns {string[]} */
export const notRun = (points) => k_choices.flatMap(([key, one, many]) => {
  const byReason = /** @type {Map<string, string[]>} */ (new Map());
  for (const [name, group] of neverBegun(points, key)) {
    const why = [...new Set(group.map((point) => (point.why || 'nobody says why').replace(/^method '[^']*': /, '')))].join(' / ');
    byReason.set(why, [...byReason.get(why) ?? [], name]);
  }
  return [...byReason].map(([why, names]) => `${names.length === 1 ? one : many} ${names.join(', ')}: ${why}`);
});

/** Runs that arrived and were compared with the reference. */
export const arrived = (/** @type {Point[]} */ points) => points.filter((point) => point.status === 'ok' && isNumber(point.error));

/** Runs that did not arrive, or whose error nobody knows. */
export const lost = (/** @type {Point[]} */ points) => points.filter((point) => point.status !== 'ok' || !isNumber(point.error));

/** How runs and other settings ended, so that all say the same of them. @param {Point[]} points */
export function tally(points) {
  const runs = made(points);
  const arrivals = arrived(runs).length, stopped = runs.filter(({status}) => status === 'failed').length, late = points.filter(hadNoTime).length;
  return {runs: runs.length, arrived: arrivals, stopped, unknown: runs.length - arrivals - stopped, unmade: points.length - runs.length, late, unfit: points.length - runs.length - late};
}

/** @param {Point[]} points */
export const front = (points, cost = time) => paretoFront(arrived(points), error, cost);

/** Different values of a setting, in the order in which they come. @param {Point[]} points @param {string} key */
export const values = (points, key) => [...new Set(points.map((point) => settingOf(point, key)))];

/** A setting that is not given is a choice of its own. @param {Point} point @param {string} key @returns {string} */
export const settingOf = (point, key) => String(/** @type {any} */ (point)[key] ?? 'not given');

/**
 * @param {Point[]} points @param {string[]} keys
 * @returns {Map<string, Point[]>} by the values of `keys`
 */
export function grouped(points, keys) {
  const groups = new Map();
  for (const point of points) {
    const name = keys.map((key) => settingOf(point, key)).join(' · ');
    if (!groups.has(name)) groups.set(name, []);
    groups.get(name).push(point);
  }
  return groups;
}

/** Those whose other settings were tried with each value of `key`, by a run that was begun, so that nothing else is compared. Tolerances and steps may differ. @param {Point[]} points @param {string} key */
export function alikeBut(points, key) {
  const others = k_settings.map(([other]) => /** @type {string} */ (other)).filter((other) => other !== key && other !== 'library' && other !== 'engine');
  const of = (/** @type {Point} */ point) => others.map((other) => settingOf(point, other)).join(' · ');
  const tried = [...grouped(made(points), [key]).values()].map((group) => new Set(group.map(of)));
  return points.filter((point) => tried.every((some) => some.has(of(point))));
}

/** The cheapest run with an error of at most `target`; none if nobody gets there. @param {Point[]} points @param {number} target */
export function cheapest(points, target, cost = time) {
  let best = null;
  for (const point of arrived(points)) {
    if (Number(point.error) > target || !isNumber(cost(point))) continue;
    if (best === null || Number(cost(point)) < Number(cost(best))) best = point;
  }
  return best;
}

/** 1e-3, 1e-4, ... 1e-12, and on as far as somebody gets, from 1e-15 in steps of three decades. @param {Point[]} points */
export function targets(points) {
  const best = Math.min(...arrived(points).map((point) => Number(point.error)), 1);
  const found = [];
  for (let digits = 3; digits <= 12; ++digits) found.push(Number(`1e-${digits}`));
  for (let digits = 13; digits <= 30 && Number(`1e-${digits}`) >= best; digits += digits < 15 ? 1 : 3) found.push(Number(`1e-${digits}`));
  return found;
}
