// The controls of a motion: elements alone, which call back.

import {button, el} from '../ui/dom.js';

const k_speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10];

/**
 * @param {{start: number, end: number, hasReactions: boolean, toggle: () => void, seek: (time: number) => void, speed: (factor: number) => void, show: () => void, first: () => void}} on
 */
export function controls({start, end, hasReactions, toggle, seek, speed, show, first}) {
  const play = button('Play', toggle, {class: 'play'});
  const scrub = input({type: 'range', min: start, max: end, step: (end - start) / 1000, value: start, 'aria-label': 'time of the motion in seconds', input: () => seek(Number(scrub.value))});
  const clock = el('output', {class: 'clock'});
  const pace = /** @type {HTMLSelectElement} */ (el('select', {'aria-label': 'speed', change: () => speed(Number(pace.value))},
    ...k_speeds.map((factor) => el('option', {value: factor, selected: factor === 1}, `${factor} ×`))));
  const arrows = input({type: 'range', min: 0, max: 3, step: 0.05, value: 1, input: show});
  const traced = input({type: 'checkbox', checked: true, change: show});
  const bar = el('div', {class: 'motion-bar'}, play, scrub, clock, pace);
  const sliders = el('div', {class: 'motion-sliders'}, hasReactions ? el('label', {}, el('span', {}, 'Reaction arrows'), arrows) : null,
    el('label', {class: 'check'}, traced, el('span', {}, 'Traces of bodies')), button('First view', first));
  return {play, scrub, clock, arrows, traced, bar, sliders};
}

/** @param {Record<string, any>} attributes */
const input = (attributes) => /** @type {HTMLInputElement} */ (el('input', attributes));
