// A table that may be wider than its place: a region that keys scroll, with shadows where it goes on, and a line that says so.

import {el} from './dom.js';

const k_near = 2;  // pixels: browsers round

/** What is seen of something wide. @param {{scrollLeft: number, clientWidth: number, scrollWidth: number}} place */
export const beyond = ({scrollLeft, clientWidth, scrollWidth}) => ({left: scrollLeft > k_near, right: scrollWidth - clientWidth - scrollLeft > k_near});

export class Sideways {
  /** @param {...Node} children */
  constructor(...children) {
    this.scroll = el('div', {class: 'scroll', tabindex: 0, role: 'region', scroll: () => this.look()}, ...children);
    this.hint = el('p', {class: 'sideways-hint', hidden: true}, 'The table is wider than its place: scroll it sideways, or focus it and press the arrow keys.');
    this.frame = el('div', {class: 'sideways'}, this.scroll);
    this.element = el('div', {}, this.frame, this.hint);
    new ResizeObserver(() => this.look()).observe(this.scroll);
  }

  /** Has to be asked for where the content changes: nobody else tells. */
  look() {
    const {left, right} = beyond(this.scroll);
    this.frame.classList.toggle('more-left', left);
    this.frame.classList.toggle('more-right', right);
    this.hint.hidden = !left && !right;
  }
}
