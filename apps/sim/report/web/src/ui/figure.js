// A chart with what belongs to it: a title that states what it shows, a line that the data say, the key, and the table.

import {button, el, prose} from './dom.js';
import {Plot} from './plot.js';
import {keyOf} from './swatch.js';
import {DataTable} from './table.js';

/** @typedef {import('../types.js').Chart} Chart */
/** @typedef {import('../types.js').FullProblem} FullProblem */

const k_print_width = 680;

export class Figure {
  /** @param {Chart} chart @param {FullProblem} problem @param {() => import('../types.js').Point[]} points @param {() => import('../types.js').Look} look */
  constructor(chart, problem, points, look) {
    this.chart = chart;
    this.problem = problem;
    this.points = points;
    this.look = look;
    this.stale = true;
    this.near = false;
    this.all = false;
    this.plot = new Plot();
    this.table = new DataTable(`${problem.name}-${chart.id}`.replace(/[^A-Za-z0-9_-]+/g, '_'));
    this.takeaway = el('p', {class: 'takeaway'});
    this.note = el('p', {class: 'note'});
    this.keys = el('div', {class: 'keys'});
    this.more = button('', () => this.toggle(), {class: 'more-drawn', hidden: true});
    this.empty = el('p', {class: 'empty', hidden: true});
    this.body = el('div', {class: 'figure-body'}, el('div', {class: 'figure-plot'}, this.plot.element, this.keys, this.more), this.table.element);
    this.heading = el('h3', {tabindex: -1}, chart.title);
    this.element = el('section', {class: 'figure', 'data-chart': chart.id, 'aria-busy': 'true'}, this.heading, el('p', {class: 'about'}, chart.about), this.takeaway, this.empty, this.body, this.note, this.plot.spoken);
    this.watch();
  }

  /** Drawn when it comes near the window: a page of many charts opens at once. */
  watch() {
    const observer = new IntersectionObserver(([entry]) => {
      this.near = entry.isIntersecting;
      if (this.near && this.stale) this.draw();
    }, {rootMargin: '300px'});
    observer.observe(this.element);
    new ResizeObserver(() => { if (!this.stale) this.plot.resize(); }).observe(this.plot.element);
  }

  /** Filters or colours have changed. */
  refresh() {
    this.stale = true;
    this.element.setAttribute('aria-busy', 'true');
    if (this.near) this.draw();
  }

  /** @param {{look?: import('../types.js').Look, print?: boolean}} [how] */
  draw(how = {}) {
    this.stale = how.print ?? false;
    const look = how.look ?? this.look();
    const picture = this.chart.make(this.problem, this.points(), look, this.all);
    const fails = typeof picture === 'string';
    this.empty.hidden = !fails;
    this.body.hidden = this.takeaway.hidden = this.note.hidden = fails;
    if (fails) this.empty.textContent = picture;
    else this.fill(picture, look, how.print ?? false);
    this.element.setAttribute('aria-busy', 'false');
  }

  toggle() {
    this.all = !this.all;
    this.draw();
  }

  /** @param {import('../types.js').Picture['more']} more */
  say(more) {
    this.more.hidden = !more;
    if (more) this.more.textContent = this.all ? `Draw fewer ${more.word}` : `Draw all ${more.all} ${more.word}`;
  }

  /** @param {import('../types.js').Picture} picture @param {import('../types.js').Look} look @param {boolean} print */
  fill(picture, look, print) {
    this.takeaway.replaceChildren(...prose(picture.takeaway));
    this.note.textContent = picture.note ?? '';
    this.note.hidden = !picture.note;
    this.say(picture.more);
    this.keys.replaceChildren(...(picture.key ? keyOf(picture.key, look) : []));
    this.body.classList.toggle('beside', picture.table.columns.length <= 5);
    this.table.show(picture.table, print);
    this.plot.draw(picture, this.chart.title, print ? k_print_width : undefined);
  }
}
