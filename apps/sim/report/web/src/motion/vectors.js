// Vectors and quaternions of three and four numbers, for drawing.

/** @typedef {import('../types.js').Vector} Vector */
/** @typedef {[number, number, number, number]} Quaternion scalar part first */

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** @param {Vector} a @param {number} factor @returns {Vector} */
export const scaled = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
/** @param {Vector} a @param {Vector} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {Vector} a @param {Vector} b @returns {Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @param {Vector} a */
export const size = (a) => Math.hypot(...a);

/** @param {Vector} a @returns {Vector} */
export function unit(a) {
  const length = size(a);
  return length > 0 ? scaled(a, 1 / length) : [0, 0, 1];
}

/** A direction across `a`. @param {Vector} a @returns {Vector} */
export function across(a) {
  const axis = /** @type {Vector} */ (Math.abs(a[0]) < 0.9 * size(a) ? [1, 0, 0] : [0, 1, 0]);
  return unit(minus(axis, scaled(a, dot(axis, a) / dot(a, a))));
}

/** @param {Quaternion} q @param {Vector} v @returns {Vector} v turned by q */
export function turned([w, x, y, z], v) {
  const axis = /** @type {Vector} */ ([x, y, z]);
  const twice = scaled(cross(axis, v), 2);
  return plus(plus(v, scaled(twice, w)), cross(axis, twice));
}
