// What all charts have in common: no animation (nobody waits for numbers), margins, hints, and for still pictures title and legend.

import {k_font} from './axes.js';

/** @typedef {import('../types.js').Look} Look */

/** @param {Look} look @param {{title: string, legend?: string[], left?: number, xAxis: any, yAxis: any, series: any[], bottom?: number}} parts */
export function frame(look, parts) {
  const {title, legend, xAxis, yAxis, series, left = 74, bottom = 54} = parts;
  return {
    animation: false, backgroundColor: 'transparent', textStyle: {fontFamily: k_font},
    grid: {left, right: 22, top: look.still ? 40 : 18, bottom: look.still && legend ? bottom + legendHeight(legend) : bottom, outerBoundsMode: 'none'},
    tooltip: {trigger: 'item', confine: true, transitionDuration: 0, className: 'hint', borderWidth: 0, padding: 0, backgroundColor: 'transparent'},
    xAxis, yAxis, series, ...stillParts(look, title, legend),
  };
}

/** Rows of a legend in a picture of 760 pixels. @param {string[]} names */
function legendRows(names) {
  let [rows, width] = [1, 0];
  for (const name of names) {
    const entry = 46 + 6.6 * name.length;
    if (width + entry > 720) [rows, width] = [rows + 1, 0];
    width += entry;
  }
  return rows;
}

const legendHeight = (/** @type {string[]} */ names) => 20 * legendRows(names) + 4;

/** @param {Look} look @param {string} title @param {string[]} [legend] */
function stillParts(look, title, legend) {
  if (!look.still) return {legend: {show: false}};
  return {
    backgroundColor: look.surface,
    title: {text: title, left: 12, top: 8, textStyle: {color: look.ink, fontSize: 15, fontWeight: 600, fontFamily: k_font}},
    legend: legend
      ? {data: legend, left: 12, right: 12, bottom: 4, itemWidth: 26, itemHeight: 10, itemGap: 14, textStyle: {color: look.ink, fontSize: 12, fontFamily: k_font}}
      : {show: false},
  };
}
