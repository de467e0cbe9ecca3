// What all charts have in common: no animation (nobody waits for numbers), margins, hints, and a title in still pictures.

import {k_font} from './axes.js';

/** @typedef {import('../types.js').Look} Look */

/** @param {Look} look @param {{title: string, left?: number, xAxis: any, yAxis: any, series: any[]}} parts */
export const frame = (look, {title, xAxis, yAxis, series, left = 74}) => ({
  animation: false, backgroundColor: look.still ? look.surface : 'transparent', textStyle: {fontFamily: k_font}, xAxis, yAxis, series,
  grid: {left, right: 22, top: look.still ? 44 : 24, bottom: 54, outerBoundsMode: 'none'},
  tooltip: {trigger: 'item', confine: true, transitionDuration: 0, className: 'hint', borderWidth: 0, padding: 0, backgroundColor: 'transparent'},
  title: look.still ? {text: title, left: 12, top: 10, textStyle: {color: look.ink, fontSize: 15, fontWeight: 600, fontFamily: k_font}} : {show: false},
});
