// A grid below the motion, which gives its size and which way is up.

import {reachAlong} from './frames.js';
import {dot, plus, scaled} from './vectors.js';

/** @typedef {import('../types.js').Vector} Vector */

const k_cells = 12;

/** A round length for the side of a cell: 1, 2 or 5 times a power of ten. @param {number} length */
export function roundLength(length) {
  const decade = 10 ** Math.floor(Math.log10(length));
  return decade * ([5, 2].find((step) => length >= step * decade) ?? 1);
}

/**
 * Below a mechanism that is followed it goes along by whole cells, and so seems to lie still.
 * @param {import('./camera.js').Camera} camera
 * @returns {{lines: [Vector, Vector][], cell: number}}
 */
export function ground({up, first, second, extent, carried, floor}) {
  const cell = roundLength(extent.radius / 4);
  const height = floor ?? reachAlong(extent, up)[0] + dot(carried, up);
  const middle = plus(extent.middle, carried);
  // On multiples of a cell, so that the grid can be counted from the origin.
  const round = (/** @type {Vector} */ axis) => Math.round(dot(middle, axis) / cell) * cell;
  const origin = plus(plus(scaled(first, round(first)), scaled(second, round(second))), scaled(up, height));
  const half = cell * k_cells / 2;
  const lines = [];
  for (let i = -k_cells / 2; i <= k_cells / 2; ++i) {
    for (const [along, over] of [[first, second], [second, first]]) {
      const base = plus(origin, scaled(over, i * cell));
      lines.push(/** @type {[Vector, Vector]} */ ([plus(base, scaled(along, -half)), plus(base, scaled(along, half))]));
    }
  }
  return {lines, cell};
}

/** Edges of a box, as pairs of corners in its own axes. @param {Vector} size @returns {[Vector, Vector][]} */
export function boxEdges(size) {
  const half = scaled(size, 0.5);
  const edges = [];
  for (let axis = 0; axis < 3; ++axis) {
    for (const [a, b] of [[-1, -1], [-1, 1], [1, -1], [1, 1]]) {
      const from = /** @type {Vector} */ ([0, 0, 0]);
      from[axis] = -half[axis];
      from[(axis + 1) % 3] = a * half[(axis + 1) % 3];
      from[(axis + 2) % 3] = b * half[(axis + 2) % 3];
      const to = /** @type {Vector} */ ([...from]);
      to[axis] = half[axis];
      edges.push(/** @type {[Vector, Vector]} */ ([from, to]));
    }
  }
  return edges;
}

/** A circle across z, in the axes of a body. @param {number} radius @param {number} z @returns {Vector[]} */
export const circle = (radius, z) => Array.from({length: 33}, (_, i) => [radius * Math.cos(i * Math.PI / 16), radius * Math.sin(i * Math.PI / 16), z]);

