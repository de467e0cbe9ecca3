// Series that charts of single runs share: runs as symbols, the best of each method joined, the front, the default, and what failed.

import {colourOf, dashOf, fillOf, symbolOf} from '../look.js';
import {paretoFront} from '../maths/pareto.js';
import {grouped} from '../maths/points.js';
import {detailOf} from './detail.js';
import {freeLabel, placeLabel} from './free_label.js';

/** @typedef {import('../types.js').Point} Point */
/** @typedef {import('../types.js').Look} Look */
/** @typedef {import('../types.js').Spot} Spot */
/** @typedef {(point: Point) => [number, number]} Place */

const k_default = 'default';
const k_cross = 'path://M1,0 L5,4 L9,0 L10,1 L6,5 L10,9 L9,10 L5,6 L1,10 L0,9 L4,5 L0,1 Z';

/** Collects series and spots: a spot knows the number of its series. */
export class Marks {
  /** @param {Look} look @param {Place} place @param {Set<Point>} front */
  constructor(look, place, front) {
    this.look = look;
    this.place = place;
    this.front = front;
    this.series = /** @type {any[]} */ ([]);
    this.spots = /** @type {Spot[]} */ ([]);
    this.arrange = /** @type {import('../types.js').Picture['arrange']} */ (undefined);
  }

  /** Runs of each method and number type. With a cost, the best of them are joined: those that no other of the group beats. @param {Point[]} points @param {((point: Point) => any) | null} cost */
  runs(points, cost) {
    for (const [name, group] of grouped(points, ['method', 'number'])) {
      const {method} = group[0];
      const number = String(group[0].number);
      const colour = colourOf(this.look, method);
      if (cost) this.joined(name, paretoFront(group, (point) => point.error, cost), colour, number);
      const [symbol, itemStyle] = [symbolOf(this.look, method), {color: fillOf(this.look, number, colour), borderColor: colour, borderWidth: 1.4}];
      this.symbols(name, [...group].sort((a, b) => Number(b.error) - Number(a.error)), {symbol, itemStyle});
    }
  }

  /** @param {string} name @param {Point[]} points @param {string} colour @param {string} number */
  joined(name, points, colour, number) {
    this.series.push({
      type: 'line', name, data: points.map(this.place), silent: true, showSymbol: false, z: 2, tooltip: {show: false},
      lineStyle: {color: colour, width: 1.4, type: dashOf(this.look, number), opacity: 0.75}, itemStyle: {color: colour},
    });
  }

  /** @param {string} name @param {Point[]} points @param {object} style */
  symbols(name, points, style) {
    const data = points.map((point) => {
      this.spots.push({series: this.series.length, index: 0, detail: () => detailOf(point, {onFront: this.front.has(point)})});
      return {value: this.place(point), ref: this.spots.length - 1, symbolSize: this.front.has(point) ? 11 : 8};
    });
    data.forEach(({ref}, index) => { this.spots[ref].index = index; });
    this.series.push({type: 'scatter', name, data, z: 3, cursor: 'default', emphasis: {scale: 1.5}, ...style});
  }

  /** The Pareto front, as a broad line below all. @param {Point[]} points */
  paretoLine(points) {
    this.series.push({
      type: 'line', name: 'Pareto front', data: points.map(this.place), silent: true, showSymbol: false, z: 1, tooltip: {show: false},
      lineStyle: {color: this.look.accent, width: 8, opacity: 0.42, cap: 'round', join: 'round'}, itemStyle: {color: this.look.accent},
    });
  }

  /** A ring around what is taken where nothing is said. @param {Point[]} points */
  defaults(points) {
    const data = points.filter((point) => point.is_default).map(this.place);
    if (data.length === 0) return;
    this.series.push({
      type: 'scatter', name: k_default, data, silent: true, symbol: 'circle', symbolSize: 20, z: 4, tooltip: {show: false},
      itemStyle: {color: 'transparent', borderColor: this.look.ink, borderWidth: 2},
    });
    this.series.push(freeLabel(this.look, k_default));
    const [at] = data;
    this.arrange = (/** @type {import('echarts/core').EChartsType} */ chart, /** @type {any} */ option) => placeLabel(chart, option, k_default, at);
  }

  /**
   * What failed or was refused, in a band at the margin. @param {Point[]} points @param {Place} place
   * @param {[object, object]} area its corners
   */
  failures(points, place, area) {
    if (points.length === 0) return;
    const usual = this.place;
    this.place = place;
    this.symbols('failed or refused', points, {symbol: k_cross, itemStyle: {color: this.look.fault}});
    this.place = usual;
    this.series[this.series.length - 1].markArea = {
      silent: true, itemStyle: {color: this.look.band},
      label: {show: true, formatter: 'no result', color: this.look.fault, fontSize: 11, position: 'top', distance: 8}, data: [area]  // outside, where no point is,
    };
  }
}
