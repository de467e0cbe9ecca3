// What one more digit costs: the factor in time by which an error ten times as small is paid for.

import {front} from './points.js';

/** @typedef {import('../types.js').Point} Point */

const k_least_points = 3;
const k_least_digits = 1;

const log = Math.log10;

/** Digits of a run: an error of 1e-6 is 6. */
const digitsOf = (/** @type {Point} */ point) => -log(Number(point.error));

/** The line of least squares through log(time) over digits. @param {Point[]} points @returns {number} its slope */
function slope(points) {
  const x = points.map(digitsOf);
  const y = points.map((point) => log(Number(point.time_s)));
  const mean = (/** @type {number[]} */ values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [x0, y0] = [mean(x), mean(y)];
  const above = x.reduce((sum, value, i) => sum + (value - x0) * (y[i] - y0), 0);
  const below = x.reduce((sum, value) => sum + (value - x0) ** 2, 0);
  return above / below;
}

/**
 * Of runs of one method: only those that none of the same method beats count, so that settings which waste time, and errors
 * which rounding holds up, do not. None if these are too few, or span less than a digit.
 * @param {Point[]} points
 * @returns {{factor: number, from: number, to: number, runs: number} | null} errors from the largest to the smallest
 */
export function digitCost(points) {
  const envelope = front(points).filter((point) => Number(point.error) > 0 && Number(point.time_s) > 0);
  if (envelope.length < k_least_points) return null;
  const errors = envelope.map((point) => Number(point.error));
  const [from, to] = [Math.max(...errors), Math.min(...errors)];
  if (log(from / to) < k_least_digits) return null;
  return {factor: 10 ** slope(envelope), from, to, runs: envelope.length};
}

/**
 * The same between two errors: of the envelope at each, by straight lines between its runs on paper with two logarithmic scales.
 * @param {Point[]} points @param {number} from @param {number} to @returns {number | null}
 */
export function digitCostBetween(points, from, to) {
  const envelope = front(points).filter((point) => Number(point.error) > 0 && Number(point.time_s) > 0);
  const [first, last] = [timeAt(envelope, from), timeAt(envelope, to)];
  return first === null || last === null ? null : (last / first) ** (1 / log(from / to));
}

/** @param {Point[]} envelope sorted by error @param {number} error @returns {number | null} */
function timeAt(envelope, error) {
  for (let i = 0; i + 1 < envelope.length; ++i) {
    const [low, high] = [Number(envelope[i].error), Number(envelope[i + 1].error)];
    if (error < low || error > high) continue;
    const part = log(error / low) / log(high / low);
    return Number(envelope[i].time_s) ** (1 - part) * Number(envelope[i + 1].time_s) ** part;
  }
  return null;
}
