// Where a motion is drawn: by WebGL where the browser has it, flat else.

import {FlatStage} from './stage_flat.js';
import {SolidStage} from './stage_solid.js';

/**
 * @typedef {object} Scene what is drawn now
 * @property {import('./frames.js').Frame} frame
 * @property {import('./camera.js').Camera} camera
 * @property {import('./colours.js').SceneColours} colours
 * @property {import('../types.js').Vector[][]} traces of bodies, up to now
 * @property {number} arrow length of an arrow for a force of 1
 * @property {number} longest arrow: longer ones are cut
 */

const k_context = {alpha: true, antialias: true, depth: true, preserveDrawingBuffer: true};

/** For paper: a browser gives few contexts of WebGL, and a study may have many problems. @param {HTMLElement} place @param {import('../types.js').Motion} motion */
export function flatStageIn(place, motion) {
  const canvas = document.createElement('canvas');
  place.replaceChildren(canvas);
  return new FlatStage(canvas, motion);
}

/** three.js reports a missing WebGL to the console; asked beforehand, it is no fault. @param {HTMLElement} place @param {import('../types.js').Motion} motion */
export function stageIn(place, motion) {
  const canvas = document.createElement('canvas');
  place.replaceChildren(canvas);
  const context = /** @type {WebGL2RenderingContext | null} */ (canvas.getContext('webgl2', k_context));
  if (context) return new SolidStage(canvas, context, motion);
  return flatStageIn(place, motion);
}
