// Where a label hides no point. It is found when a chart has its size: nobody knows before how far points are apart.

/** @typedef {[number, number]} Pixel */
/** @typedef {{left: number, right: number, top: number, bottom: number}} Area */

const k_point = 8;    // the radius of the largest symbol, and a little
const k_ring = 11;
const k_letter = 7;   // the width of one, in pixels
const k_half_height = 8;
const k_turns = 24;
const k_farthest = 240;

/** @param {Pixel} centre @param {number} half the width, in two @returns {Area} */
const boxAround = ([x, y], half) => ({left: x - half, right: x + half, top: y - k_half_height, bottom: y + k_half_height});

/** @param {Area} box @param {Pixel} point @param {number} radius */
function isHit(box, [x, y], radius) {
  const beside = Math.max(box.left - x, x - box.right, 0);
  const over = Math.max(box.top - y, y - box.bottom, 0);
  return Math.hypot(beside, over) < radius;
}

/** @param {Area} box @param {Area} area */
const isWithin = (box, area) => box.left >= area.left && box.right <= area.right && box.top >= area.top && box.bottom <= area.bottom;

/**
 * The nearest place for a text that belongs to `at`: its middle. None where points are everywhere.
 * @param {string} text @param {Pixel} at @param {Pixel[]} points @param {Area} area @returns {Pixel | null}
 */
export function freePlace(text, at, points, area) {
  const half = 0.5 * k_letter * text.length;
  for (let away = k_ring + k_half_height + 2; away <= k_farthest; away += 6) {
    for (let i = 0; i < k_turns; ++i) {
      const angle = (i * 2 / k_turns - 0.5) * Math.PI;  // the first is above, since y goes down
      const middle = /** @type {Pixel} */ ([at[0] + (away + half - k_half_height) * Math.cos(angle), at[1] + away * Math.sin(angle)]);
      const box = boxAround(middle, half);
      if (isWithin(box, area) && !isHit(box, at, k_ring) && !points.some((point) => isHit(box, point, k_point))) return middle;
    }
  }
  return null;
}

/** From the ring to the edge of the text, both along the line between their middles. @param {Pixel} at @param {Pixel} middle @param {number} half @returns {[Pixel, Pixel]} */
function leader(at, middle, half) {
  const [dx, dy] = [middle[0] - at[0], middle[1] - at[1]];
  const length = Math.hypot(dx, dy);
  const within = Math.min(half / Math.abs(dx || 1e-9), k_half_height / Math.abs(dy || 1e-9), 1);
  const along = (/** @type {number} */ part) => /** @type {Pixel} */ ([at[0] + part * dx, at[1] + part * dy]);
  return [along(Math.min(k_ring / length, 1 - within)), along(1 - within)];
}

/**
 * The series of a label: without a place, until `place` has found one.
 * @param {import('../types.js').Look} look @param {string} text
 */
export const freeLabel = (look, text) => ({
  type: 'line', id: `label of ${text}`, name: text, data: [], silent: true, z: 5, symbol: 'circle', symbolSize: 0, showSymbol: true, tooltip: {show: false}, animation: false,
  lineStyle: {color: look.ink, width: 1}, itemStyle: {color: look.ink},
  label: {show: false, position: 'inside', formatter: text, color: look.ink, fontSize: 12, fontWeight: 600, textBorderColor: look.surface, textBorderWidth: 3},
});

/** Points that are drawn as symbols, in the units of the axes. @param {any} option @returns {Pixel[]} */
const symbolsOf = (option) => option.series.filter((/** @type {any} */ {type, silent}) => type === 'scatter' && !silent)
  .flatMap((/** @type {any} */ {data}) => data.map((/** @type {any} */ {value}) => value));

/** Places that a label covers, as close as symbols are. @param {string} text @param {Pixel} middle @returns {Pixel[]} */
function coveredBy(text, [x, y]) {
  const half = 0.5 * k_letter * text.length;
  const count = Math.ceil(2 * half / k_point);
  return Array.from({length: count + 1}, (_, i) => [x - half + 2 * half * i / count, y]);
}

/** One after the other: each finds its place beside those before it. @param {import('echarts/core').EChartsType} chart @param {any} option @param {{text: string, at: Pixel}[]} labels `at` in the units of the axes */
export function placeLabels(chart, option, labels) {
  const pixel = (/** @type {Pixel} */ value) => /** @type {Pixel} */ (chart.convertToPixel('grid', value));
  const value = (/** @type {Pixel} */ place) => chart.convertFromPixel('grid', place);
  const [a, b] = [pixel([option.xAxis.min, option.yAxis.min]), pixel([option.xAxis.max, option.yAxis.max])];
  const area = {left: Math.min(a[0], b[0]), right: Math.max(a[0], b[0]), top: Math.min(a[1], b[1]), bottom: Math.max(a[1], b[1])};
  const taken = symbolsOf(option).map(pixel);
  const series = labels.map(({text, at}) => {
    const middle = freePlace(text, pixel(at), taken, area);
    if (middle) taken.push(...coveredBy(text, middle));
    const data = middle ? [...leader(pixel(at), middle, 0.5 * k_letter * text.length).map(value), {value: value(middle), label: {show: true}}] : [];
    return {id: `label of ${text}`, data};
  });
  chart.setOption({series});
}

/** @param {import('echarts/core').EChartsType} chart @param {any} option @param {string} text @param {Pixel} at in the units of the axes */
export const placeLabel = (chart, option, text, at) => placeLabels(chart, option, [{text, at}]);
