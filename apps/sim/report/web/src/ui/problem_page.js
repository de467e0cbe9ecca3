// All about one problem: facts, motion, filters and charts.

import {chartsOf, isOfEffects} from '../charts/all.js';
import {canPlay, largestReaction} from '../motion/frames.js';
import {MotionView} from '../motion/view.js';
import {plain} from '../format.js';
import {begun} from '../maths/points.js';
import {el} from './dom.js';
import {factsOf} from './facts.js';
import {Figure} from './figure.js';
import {Filters} from './filters.js';

/** @typedef {import('../types.js').FullProblem} FullProblem */

export class ProblemPage {
  /** @param {FullProblem} problem @param {string} link of the problem @param {import('./theme.js').Theme} theme */
  constructor(problem, link, theme) {
    this.name = problem.name;
    const shown = {...problem, points: begun(problem.points)};
    this.filters = new Filters(shown.points, () => this.figures.forEach((figure) => figure.refresh()));
    const charts = chartsOf(shown);
    this.figures = charts.map((chart) => new Figure(chart, shown, () => this.filters.shown(), () => theme.look()));
    this.motion = canPlay(problem.motion) ? new MotionView(/** @type {any} */ (problem.motion), () => theme.dark()) : null;
    this.motionHeading = el('h3', {tabindex: -1}, 'The motion');
    const heading = el('h2', {tabindex: -1}, problem.name);
    this.headings = new Map(/** @type {[string, HTMLElement][]} */ ([['', heading], ['motion', this.motionHeading], ...this.figures.map(({chart, heading: of}) => [chart.id, of])]));
    const links = [...(isOfEffects(problem) ? [] : [['motion', 'The motion']]), ...charts.map(({id, short}) => [id, short])];
    this.element = el('div', {class: 'problem'}, el('div', {class: 'side'}, sections(link, links), this.filters.element),
      el('div', {class: 'charts'}, el('header', {class: 'intro'}, heading, problem.about ? el('p', {class: 'lead'}, problem.about) : null,
        problem.why ? el('p', {class: 'fault'}, `There is no reference, so no run was measured: ${problem.why}.`) : null, factsOf(problem)),
        isOfEffects(problem) ? null : this.motionSection(problem), ...this.figures.map(({element}) => element)));
  }

  /** @param {FullProblem} problem */
  motionSection(problem) {
    if (!this.motion) return el('section', {class: 'figure', 'data-chart': 'motion'}, this.motionHeading, el('p', {class: 'empty'}, 'No motion is recorded.'));
    const largest = largestReaction(/** @type {any} */ (problem.motion));
    const takeaway = largest ? `Largest reaction that is drawn: ${largest.name}, ${plain(largest.value)} ${largest.unit} at ${plain(largest.time)} s.` : 'No reaction is known as a force on a body, so that none is drawn.';
    return el('section', {class: 'figure', 'data-chart': 'motion'}, this.motionHeading,
      el('p', {class: 'about'}, 'The run itself. Arrows are reactions, on the body that is named: those that are known as forces on a body.'), el('p', {class: 'takeaway'}, takeaway), this.motion.element);
  }

  open() {
    this.motion?.open();
  }

  close() {
    this.motion?.close();
  }

  refresh() {
    this.figures.forEach((figure) => figure.refresh());
    this.motion?.refresh();
  }

  /** @param {import('../types.js').Look} look */
  print(look) {
    this.figures.forEach((figure) => figure.draw({look, print: true}));
    this.motion?.print();
  }
}

/** @param {string} link @param {string[][]} links */
const sections = (link, links) => el('nav', {class: 'sections', 'aria-label': 'Charts of this problem'},
  el('ul', {}, ...links.map(([id, title]) => el('li', {}, el('a', {href: `${link}/${encodeURIComponent(id)}`, 'data-section': id}, title)))));
