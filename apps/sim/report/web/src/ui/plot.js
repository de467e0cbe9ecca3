// One drawn chart: hints under the pointer, and the same by arrow keys.

import {sizeAt} from '../charts/frame.js';
import {init} from '../echarts.js';
import {el, pairs} from './dom.js';

/** @typedef {import('../types.js').Picture} Picture */

const k_keys = 'Arrow keys go from point to point, Home and End to the first and last, Escape closes.';

export class Plot {
  constructor() {
    this.element = el('div', {class: 'plot', tabindex: 0, role: 'application', 'aria-roledescription': 'chart', keydown: (/** @type {KeyboardEvent} */ event) => this.key(event), blur: () => this.leave()});
    this.spoken = el('div', {class: 'unseen', 'aria-live': 'polite'});
    this.picture = /** @type {Picture | null} */ (null);
    this.at = -1;
    this.chart = /** @type {import('echarts/core').EChartsType | null} */ (null);
  }

  /** @param {Picture} picture @param {string} title @param {number} [width] where the place has none, as in print */
  draw(picture, title, width) {
    this.picture = picture;
    this.at = -1;
    this.element.setAttribute('aria-label', `${title}. ${picture.takeaway} ${k_keys}`);
    const size = sizeAt(picture, width ?? (this.element.clientWidth || 640));
    this.element.style.height = `${size.height}px`;
    this.chart ??= init(this.element, undefined, {renderer: 'svg', ...size});
    this.chart.resize(size);
    picture.option.tooltip.formatter = (/** @type {any} */ {data}) => hint(picture, data);
    this.chart.setOption(picture.option, {notMerge: true, lazyUpdate: false});
    picture.arrange?.(this.chart, picture.option);
  }

  resize() {
    if (!this.chart || !this.picture || this.element.clientWidth === 0) return;
    const size = sizeAt(this.picture, this.element.clientWidth);
    this.element.style.height = `${size.height}px`;
    this.chart.resize(size);
    this.picture.arrange?.(this.chart, this.picture.option);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const last = (this.picture?.spots.length ?? 0) - 1;
    const next = {ArrowRight: Math.min(this.at + 1, last), ArrowDown: Math.min(this.at + 1, last), ArrowLeft: Math.max(this.at - 1, 0), ArrowUp: Math.max(this.at - 1, 0), Home: 0, End: last}[event.key];
    if (event.key === 'Escape') this.leave();
    if (next === undefined || last < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.show(next);
  }

  /** @param {number} at */
  show(at) {
    this.unmark();
    this.at = at;
    const spot = /** @type {Picture} */ (this.picture).spots[at];
    const place = {seriesIndex: spot.series, dataIndex: spot.index};
    this.chart?.dispatchAction({type: 'highlight', ...place});
    this.chart?.dispatchAction({type: 'showTip', ...place});
    this.spoken.textContent = spot.detail().map(([label, value]) => `${label} ${value}`).join(', ');
  }

  unmark() {
    const spot = this.picture?.spots[this.at];
    if (spot) this.chart?.dispatchAction({type: 'downplay', seriesIndex: spot.series, dataIndex: spot.index});
  }

  leave() {
    this.unmark();
    this.at = -1;
    this.chart?.dispatchAction({type: 'hideTip'});
    this.spoken.textContent = '';
  }
}

/** @param {Picture} picture @param {any} data of the item that is pointed at */
function hint(picture, data) {
  const spot = picture.spots[data?.ref];
  return spot ? pairs(spot.detail(), 'pairs hint-text') : '';
}
