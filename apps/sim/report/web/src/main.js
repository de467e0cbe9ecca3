// The page: reads the study in it, and shows one problem after the other as the address says.

import {isOfEffects} from './charts/all.js';
import {readStudy} from './study.js';
import {el} from './ui/dom.js';
import {interruptionOf, machineOf} from './ui/facts.js';
import {ProblemPage} from './ui/problem_page.js';
import {SummaryPage} from './ui/summary_page.js';
import {Theme} from './ui/theme.js';
import {begun, settingOf} from './maths/points.js';

/** @typedef {import('./types.js').FullProblem} FullProblem */
/** @typedef {ProblemPage | SummaryPage} Page */

const k_title = 'What accuracy costs in time';

class Report {
  /** @param {import('./types.js').Study} study @param {FullProblem[]} problems */
  constructor(study, problems) {
    this.problems = problems;
    // Each link has a name of its own, also where two problems are called alike.
    this.slugs = problems.map(({name}, i) => problems.findIndex((other) => other.name === name) === i ? name : `${name}-${i + 1}`);
    const runs = problems.flatMap(({points}) => begun(points));
    const names = (/** @type {string} */ key) => [...new Set(runs.map((point) => settingOf(point, key)))];
    this.title = problems.length > 0 && problems.every(isOfEffects) ? 'What effects cost and change' : k_title;
    this.theme = new Theme(() => this.refresh(), {methods: names('method'), numbers: names('number')});
    this.pages = /** @type {Map<string, Page>} */ (new Map());
    this.current = /** @type {Page | null} */ (null);
    this.main = el('main', {id: 'main', tabindex: -1});
    // One alone needs no summary and no choice.
    this.start = problems.length === 1 ? this.slugs[0] : '';
    this.links = problems.length === 1 ? new Map() : new Map([['', el('a', {href: '#/'}, 'Summary')], ...this.slugs.map((slug) => /** @type {[string, HTMLElement]} */ ([slug, el('a', {href: linkOf(slug)}, slug)]))]);
    document.body.append(this.header(study), this.main, footer(this.title !== k_title));
    addEventListener('hashchange', () => this.go());
    addEventListener('beforeprint', () => this.print());
    addEventListener('afterprint', () => this.afterPrint());
    this.go(true);
  }

  /** @param {import('./types.js').Study} study */
  header(study) {
    const skip = el('a', {class: 'skip', href: '#main', click: (/** @type {Event} */ event) => { event.preventDefault(); this.main.focus(); }}, 'Skip to the content');
    return el('header', {class: 'top'}, skip, el('div', {class: 'title'}, el('div', {}, el('h1', {}, this.title), machineOf(study), interruptionOf(study)), this.theme.element),
      this.links.size > 0 ? el('nav', {class: 'problems', 'aria-label': 'Problems'}, ...this.links.values()) : null);
  }

  /** @param {string} slug as somebody may have typed it */
  known(slug) {
    return this.slugs.includes(slug) ? slug : this.start;
  }

  /** A page is made when it is first asked for. @param {string} asked @returns {Page} */
  page(asked) {
    const slug = this.known(asked);
    const at = this.slugs.indexOf(slug);
    let page = this.pages.get(slug);
    if (!page) {
      page = at < 0 ? new SummaryPage(this.problems, this.slugs.map(linkOf), this.theme) : new ProblemPage(this.problems[at], linkOf(slug), this.theme);
      page.element.hidden = true;
      this.pages.set(slug, page);
      this.insert(page, at);
    }
    return page;
  }

  /** In the order of the study, as paper has them. @param {Page} page @param {number} at */
  insert(page, at) {
    const next = this.slugs.slice(at + 1).map((slug) => this.pages.get(slug)).find((other) => other !== undefined);
    this.main.insertBefore(page.element, next?.element ?? null);
  }

  /** To where the address says: #/problem/chart. @param {boolean} [first] */
  go(first = false) {
    const [slug, section] = addressed(location.hash);
    const page = this.page(slug);
    if (page !== this.current) this.turnTo(page, slug);
    const heading = page.headings.get(section) ?? page.headings.get('');
    if (!first || section) {
      this.drawBefore(page, section);
      heading?.focus({preventScroll: true});
      if (section) heading?.scrollIntoView({block: 'start'});
      else scrollTo(0, 0);
    }
    for (const link of page.element.querySelectorAll('.sections a')) mark(link, /** @type {HTMLElement} */ (link).dataset.section === section);
  }

  /** Charts above a place have their height only when they are drawn: else the place would move away. @param {Page} page @param {string} section */
  drawBefore(page, section) {
    const at = page.figures.findIndex(({chart}) => chart.id === section);
    for (const figure of page.figures.slice(0, at + 1)) if (figure.stale) figure.draw();
  }

  /** @param {Page} page @param {string} slug */
  turnTo(page, slug) {
    this.current?.close();
    if (this.current) this.current.element.hidden = true;
    page.element.hidden = false;
    page.open();
    this.current = page;
    for (const [name, link] of this.links) mark(link, name === this.known(slug));
    document.title = `${page.name} – ${this.title[0].toLowerCase()}${this.title.slice(1)}`;
  }

  refresh() {
    for (const page of this.pages.values()) page.refresh();
  }

  /** Paper has all problems, and is light. */
  print() {
    document.documentElement.dataset.theme = 'light';
    const look = this.theme.look(false);
    for (const slug of [this.start, ...this.slugs]) this.page(slug).print(look);
  }

  afterPrint() {
    this.theme.say();
    for (const page of this.pages.values()) if (page !== this.current) page.close();
    this.refresh();
  }
}

/** @param {Element} link @param {boolean} here */
function mark(link, here) {
  if (here) link.setAttribute('aria-current', 'page');
  else link.removeAttribute('aria-current');
}

const linkOf = (/** @type {string} */ slug) => `#/${encodeURIComponent(slug)}`;

/** @param {string} hash @returns {[string, string]} problem and chart */
function addressed(hash) {
  const [slug = '', section = ''] = hash.replace(/^#\/?/, '').split('/').map((part) => {
    try {
      return decodeURIComponent(part);
    } catch {
      return part;
    }
  });
  return [slug, section];
}

/** @param {boolean} isOfEffects */
function footer(isOfEffects) {
  const licences = document.getElementById('licences')?.textContent ?? '';
  return el('footer', {}, el('p', {}, `${isOfEffects ? 'Changes are the largest difference from the motion with all effects' : 'Errors are the largest difference from the reference'} over all samples and outputs, each output divided by its range; of one that does not change, by its size or the range of others with its unit.`),
    el('details', {}, el('summary', {}, 'Licences of the libraries in this page'), el('pre', {tabindex: 0}, licences.trim())));
}

const found = readStudy(document.getElementById('study')?.textContent ?? '');
if (typeof found === 'string') document.body.append(el('main', {}, el('h1', {}, k_title), el('p', {class: 'empty'}, found)));
else new Report(found.study, found.problems);
