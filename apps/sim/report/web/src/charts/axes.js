// Axes. A logarithmic one is drawn as a plain axis of exponents: its ends and labels are then ours to choose, and 1e-30 is a
// number as any other.

import {isNumber, power, seconds, small} from '../format.js';

/** @typedef {import('../types.js').Look} Look */

// No quotes: the library writes this into an attribute as it is.
export const k_font = 'system-ui, Segoe UI, Roboto, Helvetica Neue, Arial, sans-serif';

/** @param {Look} look @param {string} name @param {object} more */
function axis(look, name, more) {
  return {
    name, nameLocation: 'middle', nameTextStyle: {color: look.ink, fontSize: 13, fontFamily: k_font},
    axisLine: {show: true, onZero: false, lineStyle: {color: look.muted}},
    axisTick: {show: true, lineStyle: {color: look.muted}},
    axisLabel: {color: look.muted, fontSize: 12, fontFamily: k_font, hideOverlap: true},
    splitLine: {show: true, lineStyle: {color: look.grid}},
    ...more,
  };
}

/** Labels every so many decades, eight of them at most; three decades are what prefixes are apart. @param {number} decades */
const decadesBetween = (decades) => [1, 2, 3, 6, 12, 24].find((step) => decades / step <= 8) ?? 48;

/** @param {number[]} numbers @returns {[number, number]} whole exponents around all of them */
function exponents(numbers) {
  const logs = numbers.filter((value) => isNumber(value) && value > 0).map(Math.log10);
  if (logs.length === 0) return [-1, 0];
  const low = Math.floor(Math.min(...logs) + 1e-9);
  const high = Math.ceil(Math.max(...logs) - 1e-9);
  return high > low ? [low, high] : [low - 1, high + (low === high ? 0 : 1)];
}

/**
 * @param {Look} look @param {string} name @param {(number | null | undefined)[]} numbers that shall fit
 * @param {{inverse?: boolean, above?: number, label?: (value: number) => string, gap?: number}} [how] `above`: decades that are kept
 *   free beyond the largest number
 * @returns {{axis: any, at: (value: any) => number, low: number, high: number, hasZero: boolean}} `at`: where a number is on the
 *   axis; 0 is at its lower end
 */
export function logAxis(look, name, numbers, how = {}) {
  const all = /** @type {number[]} */ (numbers.filter(isNumber));
  const hasZero = all.some((value) => value === 0);
  let [low, high] = exponents(all);
  if (hasZero) low -= 1;
  const step = decadesBetween(high - low);
  [low, high] = [step * Math.floor(low / step), step * Math.ceil(high / step)];  // so that there is a label at both ends
  const label = how.label ?? power;
  return {
    hasZero, low, high,
    at: (value) => value > 0 ? Math.log10(value) : low,
    axis: axis(look, name, {
      type: 'value', min: low, max: high + (how.above ?? 0), inverse: how.inverse ?? false, interval: step, nameGap: how.gap ?? 34,
      axisLabel: {
        color: look.muted, fontSize: 12, fontFamily: k_font, hideOverlap: true,
        formatter: (/** @type {number} */ value) => {
          if (value > high + 1e-9 || Math.abs(value - Math.round(value)) > 1e-9) return '';
          return hasZero && Math.round(value) === low ? '0' : label(Number(`1e${Math.round(value)}`));
        },
      },
    }),
  };
}

/** 1 µs, 10 µs: a power of ten in seconds, without digits that say nothing. */
export const shortSeconds = (/** @type {number} */ value) => value >= 1000 ? `${small(value)} s` : seconds(value).replace(/\.?0+ /, (zeros) => zeros.startsWith('.') ? ' ' : zeros);

/** @param {Look} look @param {string} name @param {object} [more] */
export const linearAxis = (look, name, more = {}) => axis(look, name, {type: 'value', nameGap: 34, ...more});

/** @param {Look} look @param {string[]} names @param {object} [more] */
export const categoryAxis = (look, names, more = {}) => axis(look, '', {
  type: 'category', data: names, splitLine: {show: false}, axisTick: {show: false},
  axisLabel: {color: look.ink, fontSize: 12, fontFamily: k_font, width: 192, overflow: 'truncate'}, ...more,
});
