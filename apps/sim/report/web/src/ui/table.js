// A table beside a chart: sorted by a click or a key on a heading, copied, downloaded. It begins with some rows and shows all on
// demand; thousands of rows would make the page slow.

import {k_missing, plain} from '../format.js';
import {copy, csv, download, tabbed} from './csv.js';
import {button, el, prose} from './dom.js';
import {Sideways} from './sideways.js';

/** @typedef {import('../types.js').Table} Table */
/** @typedef {import('../types.js').Column} Column */

const k_first_rows = 40;
const k_first_rows_on_paper = 24;

export class DataTable {
  /** @param {string} name of the file that is downloaded */
  constructor(name) {
    this.name = name;
    this.table = /** @type {Table} */ ({caption: '', columns: [], rows: []});
    this.rows = /** @type {Table['rows']} */ ([]);
    this.sortedBy = /** @type {string | null} */ (null);
    this.falling = false;
    this.all = false;
    this.print = false;
    this.said = el('span', {role: 'status', class: 'said'});
    this.more = button('', () => this.showAll(), {class: 'more'});
    this.sideways = new Sideways();
    this.scroll = this.sideways.scroll;
    this.element = el('div', {class: 'data'}, this.sideways.element, el('div', {class: 'tools'}, this.more,
      button('Copy', () => this.copy()), button('CSV', () => download(`${this.name}.csv`, csv(this.sorted()))), this.said));
  }

  /** @param {Table} table @param {boolean} [print] */
  show(table, print = false) {
    this.table = table;
    this.print = print;
    if (!table.columns.some(({key}) => key === this.sortedBy)) this.sortedBy = null;
    this.scroll.setAttribute('aria-label', `Table: ${table.caption}`);
    this.order();
  }

  order() {
    const column = this.table.columns.find(({key}) => key === this.sortedBy);
    this.rows = column ? [...this.table.rows].sort(by(column, this.falling)) : this.table.rows;
    this.draw();
  }

  sorted() {
    return {...this.table, rows: this.rows};
  }

  /** @param {string} key rising first, then falling, then as it was */
  sortBy(key) {
    if (this.sortedBy !== key) [this.sortedBy, this.falling] = [key, false];
    else if (!this.falling) this.falling = true;
    else this.sortedBy = null;
    this.order();
    /** @type {HTMLElement | null} */ (this.scroll.querySelector(`button[data-key="${CSS.escape(key)}"]`))?.focus();
  }

  showAll() {
    this.all = true;
    this.draw();
    this.scroll.focus();
  }

  async copy() {
    const done = await copy(tabbed(this.sorted()));
    this.said.textContent = done ? `${plain(this.rows.length)} rows copied` : 'The browser refuses the clipboard: take the CSV.';
    setTimeout(() => { this.said.textContent = ''; }, 4000);
  }

  draw() {
    const shown = this.all ? this.rows : this.rows.slice(0, this.print ? k_first_rows_on_paper : k_first_rows);
    const {columns, caption} = this.table;
    this.scroll.replaceChildren(el('table', {}, el('caption', {}, el('span', {}, caption)), el('thead', {}, el('tr', {}, ...columns.map((column) => this.heading(column)))),
      el('tbody', {}, ...shown.map((row) => el('tr', {}, ...columns.map((column) => cell(column, row)))))));
    this.more.hidden = shown.length === this.rows.length;
    this.more.textContent = `Show all ${plain(this.rows.length)} rows`;
    this.sideways.look();
    this.element.dataset.left = this.more.hidden ? '' : `The first ${plain(shown.length)} of ${plain(this.rows.length)} rows.`;
  }

  /** @param {Column} column */
  heading({key, title, numeric}) {
    const sort = this.sortedBy !== key ? 'none' : this.falling ? 'descending' : 'ascending';
    return el('th', {scope: 'col', 'data-column': key, class: numeric ? 'number' : null, 'aria-sort': sort}, el('button', {type: 'button', 'data-key': key, click: () => this.sortBy(key)}, ...prose(title)));
  }
}

/** @param {Column} column @param {Record<string, any>} row */
function cell({key, format, numeric}, row) {
  const value = row[key];
  const text = format ? format(value) : value === null || value === undefined || value === '' ? k_missing : String(value);
  return numeric ? el('td', {'data-column': key, class: 'number'}, text) : el('td', {'data-column': key}, ...prose(text));
}

/** What is missing comes last either way. @param {Column} column @param {boolean} falling */
function by({key, numeric}, falling) {
  const missing = (/** @type {any} */ value) => value === null || value === undefined || value === '';
  return (/** @type {Record<string, any>} */ a, /** @type {Record<string, any>} */ b) => {
    const [x, y] = [a[key], b[key]];
    if (missing(x) || missing(y)) return Number(missing(x)) - Number(missing(y));
    const order = numeric ? x - y : String(x).localeCompare(String(y), 'en', {numeric: true});
    return falling ? -order : order;
  };
}
