// Names at the ends of curves, beside the chart: those that would lie over each other move apart, and those of one place share it.

import {k_plot_edges} from './frame.js';

/** @typedef {{text: string, x: number, y: number}} End in the units of the axes */

const k_line = 14;   // pixels
const k_alike = 2;

/** More than two are the first and the last, since the margin holds no more. @param {string[]} texts */
const together = (texts) => texts.length > 2 ? `${texts[0]} … ${texts[texts.length - 1]}` : texts.join(', ');

/** @param {End[]} ends the highest first @param {number} near in the units of the axis @returns {End[]} */
function merged(ends, near) {
  const groups = /** @type {End[][]} */ ([]);
  for (const end of ends) {
    const above = groups[groups.length - 1];
    if (above && above[0].y - end.y < near) above.push(end);
    else groups.push([end]);
  }
  return groups.map((group) => ({...group[0], text: together(group.map(({text}) => text))}));
}

/**
 * As near to where they belong as they can be, one line apart: each is pushed below the one before, and back where the end of the axis is reached.
 * @param {number[]} places the highest first @param {number} apart @param {[number, number]} range @returns {number[]}
 */
export function apartBy(places, apart, [low, high]) {
  const found = /** @type {number[]} */ ([]);
  for (const place of places) found.push(Math.min(place, high, (found[found.length - 1] ?? Infinity) - apart));
  for (let i = found.length - 1, least = low; i >= 0 && found[i] < least; --i, least += apart) found[i] = least;
  return found;
}

/**
 * @param {import('../types.js').Look} look @param {End[]} ends @param {[number, number]} range of the axis @param {number} height of the chart
 */
export function endLabels(look, ends, range, height) {
  const perPixel = (range[1] - range[0]) / (height - k_plot_edges);
  const labels = merged([...ends].sort((a, b) => b.y - a.y), k_alike * perPixel);
  const places = apartBy(labels.map(({y}) => y), k_line * perPixel, range);
  return {
    type: 'scatter', name: 'numbers of curves', silent: true, symbolSize: 0, z: 4, clip: false, tooltip: {show: false},
    data: labels.map(({text, x}, i) => ({value: [x, places[i]], label: {show: true, formatter: text, position: 'right', distance: 8, color: look.ink, fontSize: 12, fontWeight: 600}})),
  };
}
