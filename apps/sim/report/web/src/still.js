// Charts as SVG text, for documents.

import {chartsOf} from './charts/all.js';
import {summaryOf} from './charts/summary.js';
import {init} from './echarts.js';
import {k_light} from './look.js';
import {settingOf} from './maths/points.js';

/** @typedef {import('./types.js').FullProblem} FullProblem */

const k_width = 760;

/** Pictures of all charts that have something to show. @param {FullProblem[]} problems @returns {{name: string, svg: string}[]} */
export function stills(problems) {
  const runs = problems.flatMap(({points}) => points);
  const names = (/** @type {string} */ key) => [...new Set(runs.map((point) => settingOf(point, key)))];
  const look = {...k_light, methods: names('method'), numbers: names('number'), still: true};
  const nothing = /** @type {FullProblem} */ ({name: '', outputs: [], builds: [], points: [], drifts: [], lanes: []});
  const all = [{name: 'summary', chart: summaryOf(problems), problem: problems[0] ?? nothing}, ...problems.flatMap((problem) => chartsOf(problem).map((chart) => ({name: `${fileOf(problem.name)}-${chart.id}`, chart, problem})))];
  return all.flatMap(({name, chart, problem}) => {
    const picture = chart.make(problem, problem.points, look);
    return typeof picture === 'string' ? [] : [{name: `${name}.svg`, svg: still(picture, chart.title)}];
  });
}

const fileOf = (/** @type {string} */ name) => name.replace(/[^A-Za-z0-9_-]+/g, '_');

/** @param {import('./types.js').Picture} picture @param {string} title */
function still(picture, title) {
  const extra = Math.max(0, picture.option.grid.bottom - 54) + 22;
  const chart = init(null, undefined, {renderer: 'svg', ssr: true, width: k_width, height: (picture.height ?? 360) + extra});
  chart.setOption({...picture.option, tooltip: {show: false}});
  const text = chart.renderToSVGString();
  chart.dispose();
  return `${labelled(numberedAnew(text), `${title}. ${picture.takeaway}`)}\n`;
}

/** The library counts its charts in the names of parts; a chart shall not depend on those before it. @param {string} svg */
const numberedAnew = (svg) => svg.replace(/zr\d+-/g, 'zr-');

/** @param {string} svg @param {string} label */
function labelled(svg, label) {
  const text = label.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
  return svg.replace('<svg ', () => `<svg role="img" aria-label="${text}" `);
}
