// What the charts of a problem show: any run, unless its method, number type, formulation or projection is switched off.

import {plain} from '../format.js';
import {grouped, k_choices, made, settingOf, values} from '../maths/points.js';
import {breakable, button, el} from './dom.js';

/** @typedef {import('../types.js').Point} Point */

export class Filters {
  /** @param {Point[]} points @param {() => void} changed */
  constructor(points, changed) {
    this.points = points;
    this.changed = changed;
    this.off = new Set();
    this.count = el('p', {role: 'status', class: 'count'});
    this.boxes = /** @type {HTMLInputElement[]} */ ([]);
    const groups = k_choices.map(([key, word]) => this.group(key, `${word[0].toUpperCase()}${word.slice(1)}`)).filter((group) => group !== null);
    this.reset = button('Show all', () => this.showAll(), {class: 'reset'});
    this.element = el('form', {class: 'filters', 'aria-label': 'Which runs are shown', submit: (/** @type {Event} */ event) => event.preventDefault()},
      ...groups, el('div', {class: 'filters-foot'}, this.count, this.reset));
    this.element.hidden = groups.length === 0;
    this.say();
  }

  /** No group where all runs are alike. @param {string} key @param {string} label */
  group(key, label) {
    const names = values(this.points, key);
    if (names.length < 2) return null;
    const counts = grouped(made(this.points), [key]);
    return el('fieldset', {'data-filter': key}, el('legend', {}, label), ...names.map((name) => this.choice(key, name, counts.get(name)?.length ?? 0)));
  }

  /** @param {string} key @param {string} name @param {number} count */
  choice(key, name, count) {
    const box = /** @type {HTMLInputElement} */ (el('input', {type: 'checkbox', checked: true, value: name, change: () => this.set(key, name, box.checked)}));
    this.boxes.push(box);
    return el('label', {}, box, el('span', {}, ...breakable(name)), el('small', {}, plain(count)));
  }

  /** @param {string} key @param {string} name @param {boolean} on */
  set(key, name, on) {
    if (on) this.off.delete(`${key}\n${name}`);
    else this.off.add(`${key}\n${name}`);
    this.say();
    this.changed();
  }

  showAll() {
    this.off.clear();
    for (const box of this.boxes) box.checked = true;
    this.say();
    this.changed();
  }

  /** @returns {Point[]} */
  shown() {
    return this.off.size === 0 ? this.points : this.points.filter((point) => k_choices.every(([key]) => !this.off.has(`${key}\n${settingOf(point, key)}`)));
  }

  say() {
    const [shown, all] = [this.shown(), this.points].map((points) => made(points).length);
    this.count.textContent = shown === all ? `All ${plain(shown)} runs` : `${plain(shown)} of ${plain(all)} runs`;
    /** @type {HTMLButtonElement} */ (this.reset).disabled = this.off.size === 0;
  }
}
