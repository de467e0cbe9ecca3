// The controls of a motion: elements alone, which call back.

import {button, el} from '../ui/dom.js';

const k_speeds = [0.1, 0.25, 0.5, 1, 2, 5, 10];

/**
 * @param {{start: number, end: number, hasReactions: boolean, travels: boolean, follows: boolean, toggle: () => void, seek: (time: number) => void, speed: (factor: number) => void, show: () => void, first: () => void, follow: (on: boolean) => void}} on
 */
export function controls({start, end, hasReactions, travels, follows, toggle, seek, speed, show, first, follow}) {
  const play = button('Play', toggle, {class: 'play'});
  const scrub = input({type: 'range', min: start, max: end, step: (end - start) / 1000, value: start, 'aria-label': 'time of the motion in seconds', input: () => seek(Number(scrub.value))});
  const clock = el('output', {class: 'clock'});
  const pace = /** @type {HTMLSelectElement} */ (el('select', {'aria-label': 'speed', change: () => speed(Number(pace.value))},
    ...k_speeds.map((factor) => el('option', {value: factor, selected: factor === 1}, `${factor} ×`))));
  const arrows = input({type: 'range', min: 0, max: 5, step: 0.05, value: 1, input: show});
  const traced = input({type: 'checkbox', checked: true, change: show});
  const camera = /** @type {HTMLSelectElement} */ (el('select', {change: () => follow(camera.value === 'follow')},
    el('option', {value: 'follow', selected: follows}, 'follows the mechanism'), el('option', {value: 'whole', selected: !follows}, 'holds the whole path')));
  const bar = el('div', {class: 'motion-bar'}, play, scrub, clock, pace);
  const sliders = el('div', {class: 'motion-sliders'}, hasReactions ? el('label', {}, el('span', {}, 'Reaction arrows'), arrows) : null,
    travels ? el('label', {}, el('span', {}, 'Camera'), camera) : null, el('label', {class: 'check'}, traced, el('span', {}, 'Traces of bodies')), button('First view', first));
  return {play, scrub, clock, arrows, traced, camera, bar, sliders};
}

/** @param {Record<string, any>} attributes */
const input = (attributes) => /** @type {HTMLInputElement} */ (el('input', attributes));
