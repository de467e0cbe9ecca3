// A motion at any time between its samples, and how large it is.

import {dot, minus, scaled, plus, size, unit} from './vectors.js';

/** @typedef {import('../types.js').Motion} Motion */
/** @typedef {import('../types.js').Vector} Vector */
/** @typedef {import('./vectors.js').Quaternion} Quaternion */
/** @typedef {{position: Vector, orientation: Quaternion}} Pose */
/** @typedef {{bodies: (Pose | null)[], lines: (Vector[] | null)[], reactions: ({at: Vector, force: Vector} | null)[]}} Frame */

/** @typedef {{low: Vector, high: Vector, middle: Vector, radius: number}} Extent */
/** @typedef {{low: Vector, high: Vector}} Box */

export const isVector = (/** @type {any} */ value) => Array.isArray(value) && value.length === 3 && value.every((part) => typeof part === 'number' && Number.isFinite(part));

/** @param {any} motion @returns {motion is Motion} whether there is something to show */
export const canPlay = (motion) => Boolean(motion) && Array.isArray(motion.t) && motion.t.length > 1 && motion.t.every(Number.isFinite)
  && [motion.bodies, motion.lines, motion.reactions].some((parts) => Array.isArray(parts) && parts.length > 0);

/** @param {number[]} t @param {number} time @returns {[number, number]} the sample before, and the part of the way to the next */
export function sampleAt(t, time) {
  let [low, high] = [0, t.length - 1];
  if (time <= t[low]) return [low, 0];
  if (time >= t[high]) return [high, 0];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (t[middle] <= time) low = middle;
    else high = middle;
  }
  return [low, (time - t[low]) / (t[high] - t[low])];
}

/** @param {any} a @param {any} b @param {number} part @returns {Vector | null} */
function between(a, b, part) {
  if (!isVector(a)) return null;
  return part > 0 && isVector(b) ? plus(scaled(a, 1 - part), scaled(b, part)) : a;
}

/** @param {any} a @param {any} b @param {number} part @returns {Quaternion} */
function turnBetween(a, b, part) {
  if (!Array.isArray(a) || a.length !== 4) return [1, 0, 0, 0];
  if (part === 0 || !Array.isArray(b)) return /** @type {Quaternion} */ (a);
  const sign = a.reduce((/** @type {number} */ sum, /** @type {number} */ value, /** @type {number} */ i) => sum + value * b[i], 0) < 0 ? -1 : 1;  // q and -q are the same turn
  const mixed = a.map((/** @type {number} */ value, /** @type {number} */ i) => value * (1 - part) + sign * b[i] * part);
  const length = Math.hypot(...mixed) || 1;
  return /** @type {Quaternion} */ (mixed.map((/** @type {number} */ value) => value / length));
}

/** @param {Motion} motion @param {number} time @returns {Frame} */
export function frameAt(motion, time) {
  const [i, part] = sampleAt(motion.t, time);
  return {
    bodies: (motion.bodies ?? []).map((body) => {
      const position = between(body.position?.[i], body.position?.[i + 1], part);
      return position && {position, orientation: turnBetween(body.orientation?.[i], body.orientation?.[i + 1], part)};
    }),
    lines: (motion.lines ?? []).map(({points}) => {
      const found = (points?.[i] ?? []).map((point, k) => between(point, points[i + 1]?.[k], part));
      return found.length > 1 && found.every((point) => point !== null) ? /** @type {Vector[]} */ (found) : null;
    }),
    reactions: (motion.reactions ?? []).map(({at, force}) => {
      const [place, value] = [between(at?.[i], at?.[i + 1], part), between(force?.[i], force?.[i + 1], part)];
      return place && value && {at: place, force: value};
    }),
  };
}

/** How far a body reaches from its place. @param {import('../types.js').Body} body */
export function reachOf({shape}) {
  if (shape?.kind === 'sphere') return shape.radius ?? 0;
  if (shape?.kind === 'box') return isVector(shape.size) ? 0.5 * size(/** @type {Vector} */ (shape.size)) : 0;
  if (shape?.kind === 'cylinder') return Math.hypot(shape.radius ?? 0, 0.5 * (shape.length ?? 0));
  return 0;
}

/** @returns {Box} */
const emptyBox = () => ({low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity]});

/** @param {Box} box @param {Vector} place @param {number} reach */
function grow({low, high}, place, reach) {
  for (let axis = 0; axis < 3; ++axis) {
    low[axis] = Math.min(low[axis], place[axis] - reach);
    high[axis] = Math.max(high[axis], place[axis] + reach);
  }
}

/** @param {Box} box */
const diagonal = ({low, high}) => isVector(low) ? size(minus(high, low)) : 0;

/** @param {Box} box @returns {Extent} */
function closed(box) {
  if (!isVector(box.low)) return {low: [-1, -1, -1], high: [1, 1, 1], middle: [0, 0, 0], radius: 1};
  return {...box, middle: scaled(plus(box.low, box.high), 0.5), radius: 0.5 * diagonal(box) || 1};
}

/** All places at a time, with how far something reaches there. @param {Motion} motion @param {Frame} frame @returns {Generator<[Vector, number]>} */
function* placesIn(motion, frame) {
  for (const [i, pose] of frame.bodies.entries()) if (pose) yield [pose.position, reachOf(/** @type {import('../types.js').Body[]} */ (motion.bodies)[i])];
  for (const line of frame.lines) for (const place of line ?? []) yield [place, 0];
  for (const reaction of frame.reactions) if (reaction) yield [reaction.at, 0];
}

/** @param {Motion} motion @returns {Extent} the box of all places */
export function extent(motion) {
  const box = emptyBox();
  for (const time of motion.t) for (const [place, reach] of placesIn(motion, frameAt(motion, time))) grow(box, place, reach);
  return closed(box);
}

/** Where a mechanism is: the mean of its bodies, else of its other places. @param {Motion} motion @param {Frame} frame @returns {Vector} */
export function centreOf(motion, frame) {
  const bodies = frame.bodies.flatMap((pose) => pose ? [pose.position] : []);
  const all = bodies.length > 0 ? bodies : [...placesIn(motion, frame)].map(([place]) => place);
  return all.reduce((sum, place) => plus(sum, scaled(place, 1 / all.length)), /** @type {Vector} */ ([0, 0, 0]));
}

/**
 * A mechanism beside its path. Sizes of bodies do not count: where nothing but a body is known, its size says little, and there is nothing to follow.
 * @param {Motion} motion @returns {{extent: Extent, times: number} | null} the box that holds it at any time, seen from its centre, and how much larger that of the path is
 */
export function travel(motion) {
  const [path, around] = [emptyBox(), emptyBox()];
  let own = 0;
  for (const time of motion.t) {
    const frame = frameAt(motion, time);
    const centre = centreOf(motion, frame);
    const now = emptyBox();
    for (const [place, reach] of placesIn(motion, frame)) {
      for (const box of [path, now]) grow(box, place, 0);
      grow(around, minus(place, centre), reach);
    }
    own = Math.max(own, diagonal(now));
  }
  return own > 1e-6 * diagonal(path) ? {extent: closed(around), times: diagonal(path) / own} : null;
}

/** From where to where along `axis`. @param {Extent} box @param {Vector} axis @returns {[number, number]} */
export function reachAlong({low, high}, axis) {
  const ends = axis.map((part, i) => [part * low[i], part * high[i]]);
  return [ends.reduce((sum, pair) => sum + Math.min(...pair), 0), ends.reduce((sum, pair) => sum + Math.max(...pair), 0)];
}

/** @param {Motion} motion @returns {{value: number, name: string, unit: string, time: number} | null} the largest reaction */
export function largestReaction(motion) {
  let best = /** @type {{value: number, name: string, unit: string, time: number} | null} */ (null);
  for (const {name, force, unit: of} of motion.reactions ?? []) {
    (force ?? []).forEach((vector, i) => {
      const value = isVector(vector) ? size(/** @type {Vector} */ (vector)) : -1;
      if (value >= 0 && (best === null || value > best.value)) best = {value, name, unit: of ?? '', time: motion.t[i]};
    });
  }
  return best;
}

/** The largest reaction at a time, at half of the times: some are far beyond all others. @param {Motion} motion */
export function usualReaction(motion) {
  const largest = motion.t.map((_, i) => Math.max(0, ...(motion.reactions ?? []).map(({force}) => isVector(force?.[i]) ? size(/** @type {Vector} */ (force[i])) : 0)));
  return largest.sort((a, b) => a - b)[largest.length >> 1];
}

/** Which way is up. @param {Motion} motion @returns {Vector} */
export const upOf = (motion) => isVector(motion.up) && dot(/** @type {Vector} */ (motion.up), /** @type {Vector} */ (motion.up)) > 0 ? unit(/** @type {Vector} */ (motion.up)) : [0, 0, 1];
