// Light or dark: as the system has it, until somebody says otherwise.

import {k_dark, k_light} from '../look.js';
import {button} from './dom.js';

const k_place = 'gauss-report-theme';

/** A page from a file may have no storage. */
function remembered() {
  try {
    return localStorage.getItem(k_place);
  } catch {
    return null;
  }
}

/** @param {string} theme */
function remember(theme) {
  try {
    localStorage.setItem(k_place, theme);
  } catch {
    // Nothing is lost: the system's choice comes back next time.
  }
}

export class Theme {
  /** @param {() => void} changed @param {{methods: string[], numbers: string[]}} names of the whole study */
  constructor(changed, names) {
    this.changed = changed;
    this.names = names;
    this.chosen = remembered();
    this.system = matchMedia('(prefers-color-scheme: dark)');
    this.system.addEventListener('change', () => this.apply());
    this.element = button('Dark colours', () => this.toggle(), {class: 'theme'});
    this.say();
  }

  dark() {
    return this.chosen === 'dark' || (this.chosen !== 'light' && this.system.matches);
  }

  /** @param {boolean} [dark] @returns {import('../types.js').Look} */
  look(dark = this.dark()) {
    return {...(dark ? k_dark : k_light), ...this.names, still: false};
  }

  toggle() {
    this.chosen = this.dark() ? 'light' : 'dark';
    remember(this.chosen);
    this.apply();
  }

  apply() {
    this.say();
    this.changed();
  }

  say() {
    document.documentElement.dataset.theme = this.dark() ? 'dark' : 'light';
    this.element.setAttribute('aria-pressed', String(this.dark()));
  }
}
