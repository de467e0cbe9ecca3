// Charts as SVG text, for documents.

import {k_font} from './charts/axes.js';
import {chartsOf} from './charts/all.js';
import {sizeAt} from './charts/frame.js';
import {summaryOf} from './charts/summary.js';
import {init} from './echarts.js';
import {keyRows, swatchParts} from './key.js';
import {k_light} from './look.js';
import {settingOf} from './maths/points.js';

/** @typedef {import('./types.js').FullProblem} FullProblem */
/** @typedef {import('./types.js').Look} Look */
/** @typedef {import('./types.js').Picture} Picture */

const k_width = 760;

/** Pictures of all charts that have something to show. @param {FullProblem[]} problems @returns {{name: string, svg: string}[]} */
export function stills(problems) {
  const runs = problems.flatMap(({points}) => points);
  const names = (/** @type {string} */ key) => [...new Set(runs.map((point) => settingOf(point, key)))];
  const look = {...k_light, methods: names('method'), numbers: names('number'), still: true};
  return allOf(problems).flatMap(({name, chart, problem}) => {
    const picture = chart.make(problem, problem.points, look);
    return typeof picture === 'string' ? [] : [{name: `${name}.svg`, svg: still(picture, chart.title, look)}];
  });
}

/** @param {FullProblem[]} problems */
function allOf(problems) {
  const nothing = /** @type {FullProblem} */ ({name: '', outputs: [], builds: [], points: [], drifts: [], lanes: []});
  const files = problems.map(({name}) => name.replace(/[^A-Za-z0-9_-]+/g, '_'));
  // Names that are alike as files get a number, so that none is lost.
  const unlike = files.map((file, i) => files.indexOf(file) === i ? file : `${file}-${i + 1}`);
  return [{name: 'summary', chart: summaryOf(problems), problem: problems[0] ?? nothing},
    ...problems.flatMap((problem, i) => chartsOf(problem).map((chart) => ({name: `${unlike[i]}-${chart.id}`, chart, problem})))];
}

/** @param {Picture} picture @param {string} title @param {Look} look */
function still(picture, title, look) {
  const height = sizeAt(picture, k_width).height + 26;  // the title is inside
  const chart = init(null, undefined, {renderer: 'svg', ssr: true, width: k_width, height});
  chart.setOption({...picture.option, tooltip: {show: false}});
  picture.arrange?.(chart, picture.option);
  const inner = withoutPointer(chart.renderToSVGString());
  chart.dispose();
  const key = keyText(picture, look, height);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${k_width} ${key.bottom}" width="${k_width}" height="${key.bottom}" role="img" aria-label="${escaped(`${title}. ${picture.takeaway}`)}">\n`
    + `<rect width="${k_width}" height="${key.bottom}" fill="${look.surface}"/>\n${inner}\n${key.text}</svg>\n`;
}

/** What a pointer would do has no place in a document; nor have names with the number of a chart, which would depend on those before it. @param {string} svg */
const withoutPointer = (svg) => svg.replace(/<style\b[^]*?<\/style>\n?/g, '').replace(/ (class="zr\d+-cls-\d+"|pointer-events="visible")/g, '').replace(/zr\d+-/g, 'zr-');

const k_row = 21;
const k_letter = 7.2;  // pixels: without a browser nobody measures text

/** The key below a chart, in rows. @param {Picture} picture @param {Look} look @param {number} top */
function keyText(picture, look, top) {
  let [x, y, text] = [12, top, ''];
  for (const [, entries] of picture.key ? keyRows(picture.key, look) : []) {
    for (const entry of entries) {
      const width = 40 + k_letter * entry.label.length + 16;
      if (x > 12 && x + width > k_width) [x, y] = [12, y + k_row];
      text += `<g transform="translate(${x} ${y})">${swatchParts(entry, look).map(tagOf).join('')}<text x="40" y="12.5" font-size="12" font-family="${k_font}" fill="${look.ink}">${escaped(entry.label)}</text></g>\n`;
      x += Math.round(width);
    }
    [x, y] = [12, y + k_row];
  }
  return {text, bottom: text ? y + 8 : top};
}

/** @param {[string, Record<string, string | number>]} part */
const tagOf = ([tag, attributes]) => `<${tag}${Object.entries(attributes).map(([name, value]) => ` ${name}="${escaped(String(value))}"`).join('')}/>`;

const escaped = (/** @type {string} */ text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
