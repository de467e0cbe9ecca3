// All problems on one page: the fastest settings, and in short for four errors.

import {summaryOf} from '../charts/summary.js';
import {briefly} from '../charts/detail.js';
import {seconds, small} from '../format.js';
import {cheapest, hadNoTime} from '../maths/points.js';
import {el, prose} from './dom.js';
import {Figure} from './figure.js';
import {Sideways} from './sideways.js';

/** @typedef {import('../types.js').FullProblem} FullProblem */

const k_errors = [1e-3, 1e-6, 1e-9, 1e-12];

export class SummaryPage {
  /** @param {FullProblem[]} problems @param {string[]} links @param {import('./theme.js').Theme} theme */
  constructor(problems, links, theme) {
    this.name = 'Summary';
    const nothing = /** @type {FullProblem} */ ({name: 'summary', outputs: [], builds: [], points: [], drifts: [], lanes: []});
    this.figures = [new Figure(summaryOf(problems), nothing, () => [], () => theme.look())];
    const heading = el('h2', {tabindex: -1}, 'Summary');
    this.headings = new Map([['', heading], ['summary', this.figures[0].heading]]);
    this.element = el('div', {class: 'summary'}, el('header', {class: 'intro'}, heading,
      el('p', {class: 'lead'}, 'How long a run takes for the accuracy that you need, and with which setting.')), ...matrix(problems, links), this.figures[0].element);
  }

  open() {}

  close() {}

  refresh() {
    this.figures[0].refresh();
  }

  /** @param {import('../types.js').Look} look */
  print(look) {
    this.figures[0].draw({look, print: true});
  }
}

/** @param {FullProblem[]} problems @param {string[]} links */
function matrix(problems, links) {
  if (problems.length === 0) return [el('p', {class: 'empty'}, 'The study has no problems.')];
  const head = el('tr', {}, el('th', {scope: 'col'}, 'problem'), ...k_errors.map((target) => el('th', {scope: 'col'}, `error ${small(target)}`)));
  const rows = problems.map((problem, i) => el('tr', {}, el('th', {scope: 'row'}, el('a', {href: links[i]}, problem.name)), ...k_errors.map((target) => choice(problem, target))));
  const faults = problems.flatMap(({name, why}) => why ? [el('p', {class: 'fault'}, `${name}: there is no reference: ${why}.`)] : []);
  const sideways = new Sideways(el('table', {class: 'matrix'}, el('caption', {}, 'Fastest run of each problem for four errors, and its setting.'), el('thead', {}, head), el('tbody', {}, ...rows)));
  sideways.scroll.setAttribute('aria-label', 'Table: fastest settings in short');
  sideways.element.className = 'short';
  return [sideways.element, ...faults];
}

/** @param {FullProblem} problem @param {number} target */
function choice(problem, target) {
  const point = cheapest(problem.points, target);
  if (!point) return el('td', {class: 'none'}, problem.why ? 'no reference' : problem.points.some(hadNoTime) ? 'nobody gets there in the time of the study' : 'nobody gets there');
  return el('td', {}, el('strong', {}, seconds(point.time_s)), el('span', {}, ...prose(briefly(point))));
}
