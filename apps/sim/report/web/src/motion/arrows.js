// How long arrows of reactions are, and where they end.

import {centreOf, frameAt, largestReaction, usualReaction} from './frames.js';
import {minus, plus, scaled, size} from './vectors.js';

/** @typedef {import('../types.js').Vector} Vector */
/** @typedef {{at: Vector, force: Vector}} Reaction */
/** @typedef {{perForce: number, longest: number, isCut: boolean}} Scale lengths over the radius of what is looked at, of a force of 1 and of what is never exceeded */

const k_usual = 0.4;
const k_least_usual = 0.16;  // and peaks are cut before others cannot be seen
const k_longest = 0.6;

/** @param {import('../types.js').Motion} motion @returns {Scale} */
export function scaleOf(motion) {
  const largest = largestReaction(motion)?.value ?? 0;
  const usual = usualReaction(motion) || largest;
  if (!(largest > 0)) return {perForce: 0, longest: k_longest, isCut: false};
  const perForce = Math.max(k_least_usual / usual, Math.min(k_usual / usual, k_longest / largest));
  return {perForce, longest: k_longest, isCut: perForce * largest > k_longest * (1 + 1e-9)};
}

/**
 * The arrow of a reaction, which is cut where it would be too long. @param {Reaction} reaction @param {number} perForce @param {number} longest
 * @returns {{along: Vector, length: number, isCut: boolean} | null} none of no force
 */
export function arrowOf({force}, perForce, longest) {
  const strength = size(force);
  if (!(strength * perForce > 0)) return null;
  const isCut = strength * perForce > longest * (1 + 1e-9);
  return {along: scaled(force, 1 / strength), length: isCut ? longest : strength * perForce, isCut};
}

/**
 * Where arrows end at all times, for a first view that holds them. @param {import('../types.js').Motion} motion @param {Scale} scale @param {number} radius
 * @param {boolean} follows or else in the axes of the world @returns {Vector[]}
 */
export const tipsOf = (motion, {perForce, longest}, radius, follows) => motion.t.flatMap((time) => {
  const frame = frameAt(motion, time);
  const origin = follows ? centreOf(motion, frame) : /** @type {Vector} */ ([0, 0, 0]);
  return frame.reactions.flatMap((reaction) => {
    const arrow = reaction && arrowOf(reaction, perForce * radius, longest * radius);
    return arrow ? [minus(plus(reaction.at, scaled(arrow.along, arrow.length)), origin)] : [];
  });
});
