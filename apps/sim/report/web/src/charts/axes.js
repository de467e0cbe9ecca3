// Axes. A logarithmic one is drawn as a plain axis of exponents: its ends and labels are then ours to choose, and 1e-30 is a
// number as any other.

import {alike, isNumber, seconds} from '../format.js';

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

/** Lines and labels at these places alone. @param {Look} look @param {number[]} ticks @param {(value: number) => string} write */
const labelled = (look, ticks, write) => ({
  axisTick: {show: true, lineStyle: {color: look.muted}, customValues: ticks},
  axisLabel: {color: look.muted, fontSize: 12, fontFamily: k_font, hideOverlap: true, customValues: ticks, formatter: write},
});

/** Labels every so many decades, eight of them at most; three decades are what prefixes are apart. @param {number} decades */
const decadesBetween = (decades) => [1, 2, 3, 6, 12, 24].find((step) => decades / step <= 8) ?? 48;

const k_within_decade = [0, Math.log10(2), Math.log10(5)];
const k_fewest_labels = 3;
const k_near = 1e-9;

/** Exponents of 1, 2, 5 times powers of ten: from the last that is not above `low` to the first that is not below `high`. @param {number} low @param {number} high */
function withinDecades(low, high) {
  const all = [];
  for (let decade = Math.floor(low) - 1; decade <= Math.ceil(high) + 1; ++decade) all.push(...k_within_decade.map((part) => decade + part));
  let first = all.filter((one) => one <= low + k_near).length - 1;
  const last = Math.max(all.findIndex((one) => one >= high - k_near), first + 1);
  if (last - first + 1 < k_fewest_labels) --first;
  return all.slice(first, last + 1);
}

const k_few_decades = 2;

/** Exponents that get a label: over few decades those of 1, 2 and 5, else whole ones; the first and the last hold all numbers between them. @param {number[]} numbers */
function exponents(numbers) {
  const logs = numbers.filter((value) => isNumber(value) && value > 0).map(Math.log10);
  if (logs.length === 0) logs.push(-1, 0);
  const [low, high] = [Math.min(...logs), Math.max(...logs)];
  const fine = withinDecades(low, high);
  if (fine[fine.length - 1] - fine[0] <= k_few_decades + k_near) return fine;
  const decades = Math.ceil(high - k_near) - Math.floor(low + k_near);
  const step = decadesBetween(decades);
  const [first, last] = [step * Math.floor((low + k_near) / step), step * Math.ceil((high - k_near) / step)];
  return Array.from({length: Math.round((last - first) / step) + 1}, (_, i) => first + i * step);
}

/** The number that a label names, without what rounding leaves of 10^log10(2). @param {number} exponent */
const numberAt = (exponent) => Number((10 ** (exponent - Math.floor(exponent + k_near))).toPrecision(1) + `e${Math.floor(exponent + k_near)}`);

/**
 * @param {Look} look @param {string} name @param {(number | null | undefined)[]} numbers that shall fit
 * @param {{inverse?: boolean, above?: number, label?: (value: number) => string, gap?: number, clipped?: boolean}} [how] `above`: decades that are
 *   kept free beyond the largest number; `clipped`: some that are drawn have less than the least of `numbers`
 * @returns {{axis: any, at: (value: any) => number, low: number, high: number, hasZero: boolean}} `at`: where a number is on the
 *   axis; what is below, as 0, is at its lower end
 */
export function logAxis(look, name, numbers, how = {}) {
  const all = /** @type {number[]} */ (numbers.filter(isNumber));
  const hasZero = all.some((value) => value === 0);
  const ticks = exponents(all);
  const label = how.label ?? alike(ticks.map(numberAt));
  if (hasZero) ticks.unshift(ticks[0] - Math.max(ticks[1] - ticks[0], (ticks[ticks.length - 1] - ticks[0]) / 8));
  const [low, high] = [ticks[0], ticks[ticks.length - 1]];
  const write = (/** @type {number} */ value) => value > low + k_near ? label(numberAt(value)) : hasZero ? '0' : `${how.clipped ? '≤ ' : ''}${label(numberAt(value))}`;
  return {
    hasZero, low, high, at: (value) => value > 0 ? Math.max(low, Math.log10(value)) : low,
    axis: axis(look, name, {type: 'value', min: low, max: high + (how.above ?? 0), inverse: how.inverse ?? false, nameGap: how.gap ?? 34, ...labelled(look, ticks, write)}),
  };
}

/** 1 µs, 10 µs: a power of ten in seconds, without digits that say nothing. */
export const shortSeconds = (/** @type {number} */ value) => seconds(value).replace(/\.0+ /, ' ');

const k_most_parts = 8;

/** The least step that parts `span` into few: one of `digits` times a power of ten. @param {number} span @param {number[]} digits */
function roundStep(span, digits) {
  const decade = Math.floor(Math.log10(span / k_most_parts));
  const steps = [decade, decade + 1].flatMap((exponent) => digits.map((digit) => Number(`${digit}e${exponent}`)));
  return steps.find((step) => span / step <= k_most_parts + k_near) ?? steps[steps.length - 1];
}

/**
 * From `low` to a round number above `high`; or else, where `ends` is set, to `high` itself. Labels are at multiples of a round step, and at `low`.
 * @param {Look} look @param {string} name @param {{low: number, high: number, ends?: boolean, digits?: number[], label?: (value: number) => string}} range @param {object} [more]
 */
export function linearAxis(look, name, {low, high, ends = false, digits = [1, 2, 5], label}, more = {}) {
  const top = high > low ? high : low + 1;
  const step = roundStep(top - low, digits);
  const last = ends ? Math.floor(top / step + k_near) : Math.ceil(top / step - k_near);
  const ticks = [low];
  for (let i = Math.floor(low / step + k_near) + 1; i <= last; ++i) ticks.push(Number((i * step).toPrecision(12)));
  return axis(look, name, {type: 'value', nameGap: 34, min: low, max: ends ? top : ticks[ticks.length - 1], ...labelled(look, ticks, label ?? alike(ticks)), ...more});
}

/** Behind the longest bar for the number that stands at its end. */
export const k_room = 1.06;

/** @param {Look} look @param {string[]} names @param {object} [more] */
export const categoryAxis = (look, names, more = {}) => axis(look, '', {
  type: 'category', data: names, splitLine: {show: false}, axisTick: {show: false},
  axisLabel: {color: look.ink, fontSize: 12, fontFamily: k_font, width: 192, overflow: 'truncate'}, ...more,
});
