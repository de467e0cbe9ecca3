// Colours of a scene: bodies in turn, reactions in one that no body has.

import {k_dark, k_light} from '../look.js';

/** @typedef {{bodies: string[], line: string, reaction: string, ground: string, ink: string, surface: string}} SceneColours */

/** @param {boolean} dark @returns {SceneColours} */
export function sceneColours(dark) {
  const look = dark ? k_dark : k_light;
  const [first, reaction, ...rest] = look.colours;
  return {bodies: [first, ...rest], line: look.muted, reaction, ground: look.grid, ink: look.ink, surface: look.surface};
}

/** @param {SceneColours} colours @param {number} at */
export const bodyColour = (colours, at) => colours.bodies[at % colours.bodies.length];
