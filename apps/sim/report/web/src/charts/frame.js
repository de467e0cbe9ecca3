// What all charts have in common: no animation (nobody waits for numbers), margins, hints, and a title in still pictures.

import {k_font} from './axes.js';

/** @typedef {import('../types.js').Look} Look */

const k_top = 24, k_bottom = 54;

/** Of the height of a chart, what is not its plot. */
export const k_plot_edges = k_top + k_bottom;

const k_height = 360;

/** @param {import('../types.js').Picture} picture @param {number} width */
export const sizeAt = ({height = k_height}, width) => ({width, height: typeof height === 'function' ? height(width) : height});

/** @param {Look} look @param {{title: string, left?: number, right?: number, xAxis: any, yAxis: any, series: any[]}} parts */
export const frame = (look, {title, xAxis, yAxis, series, left = 74, right = 22}) => ({
  animation: false, backgroundColor: look.still ? look.surface : 'transparent', textStyle: {fontFamily: k_font}, xAxis, yAxis, series,
  grid: {left, right, top: look.still ? k_top + 32 : k_top, bottom: k_bottom, outerBoundsMode: 'none'},
  tooltip: {trigger: 'item', confine: true, transitionDuration: 0, className: 'hint', borderWidth: 0, padding: 0, backgroundColor: 'transparent'},
  title: look.still ? {text: title, left: 12, top: 10, textStyle: {color: look.ink, fontSize: 15, fontWeight: 600, fontFamily: k_font}} : {show: false},
});
