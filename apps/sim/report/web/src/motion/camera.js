// A camera that goes around the motion. Both drawings, by WebGL and flat, see through the same one.

import {across, cross, dot, minus, plus, scaled, unit} from './vectors.js';

/** @typedef {import('../types.js').Vector} Vector */

export const k_field = 32 * Math.PI / 180;  // of view, from top to bottom
const k_steepest = 1.55;
const k_filled = 0.78;      // of the window, in the first view, by the box of the motion
const k_filled_by_tips = 0.94;

export class Camera {
  /** @param {Vector} up @param {import('./frames.js').Extent} extent */
  constructor(up, extent) {
    this.up = up;
    this.extent = extent;
    this.tips = /** @type {Vector[]} */ ([]);  // of arrows, which the first view holds
    this.carried = /** @type {Vector} */ ([0, 0, 0]);  // with a mechanism that is followed, from whose centre places of `extent` are seen
    this.first = across(up);
    this.second = cross(up, this.first);
    this.floor = /** @type {number | null} */ (null);
    this.aspect = 1.6;
    this.touched = false;
    this.azimuth = this.elevation = 0;
    this.distance = 1;
    this.target = extent.middle;
    this.reset();
  }

  /**
   * Looks at another box, in its first view. @param {import('./frames.js').Extent} extent @param {number | null} floor its height; null: below the box
   * @param {Vector[]} [tips] of arrows, which reach beyond the box
   */
  show(extent, floor, tips = []) {
    this.extent = extent;
    this.tips = tips;
    this.floor = floor;
    this.carried = /** @type {Vector} */ ([0, 0, 0]);
    this.reset();
  }

  /** Motions in a plane are seen from the front of it, others from a corner. */
  reset() {
    const {high, low, middle, radius} = this.extent;
    const span = minus(high, low);
    const along = (/** @type {Vector} */ axis) => axis.reduce((sum, part, i) => sum + Math.abs(part) * span[i], 0);
    const [first, second, upright] = [this.first, this.second, this.up].map(along);
    const flat = 0.2 * Math.max(first, second, upright);
    this.azimuth = second <= flat ? -Math.PI / 2 : first <= flat ? 0 : -1.05;
    this.elevation = second <= flat || first <= flat ? 0.12 : upright <= flat ? 0.75 : 0.32;
    this.target = middle;
    this.distance = radius / Math.sin(k_field / 2);
    this.touched = false;
    for (let i = 0; i < 4; ++i) {
      if (this.tips.length > 0) this.centre();
      this.distance *= Math.max(this.filling() / k_filled, this.filledBy(this.tips) / k_filled_by_tips);  // perspective makes it a little less than proportional
    }
  }

  /** The first view fits its window; one that somebody has turned stays. @param {number} aspect width over height */
  shape(aspect) {
    this.aspect = aspect;
    if (!this.touched) this.reset();
  }

  /** How much of the window the box of the motion takes, 1 being all of it. */
  filling() {
    return this.filledBy(this.corners());
  }

  /** @returns {Vector[]} of the box of the motion */
  corners() {
    const ends = [this.extent.low, this.extent.high];
    return ends.flatMap((a) => ends.flatMap((b) => ends.map((c) => /** @type {Vector} */ ([a[0], b[1], c[2]]))));
  }

  /** Looks at the middle of the box and the arrows, where they are seen. */
  centre() {
    const project = this.projection(2, 2);
    const seen = [...this.corners(), ...this.tips].map((place) => project(plus(this.carried, place)));
    const middle = (/** @type {'x' | 'y'} */ axis) => seen.reduce(([low, high], one) => [Math.min(low, one[axis]), Math.max(high, one[axis])], [Infinity, -Infinity]).reduce((a, b) => 0.5 * (a + b));
    const {right, upright} = this.axes();
    const pixel = this.distance * Math.tan(k_field / 2);
    this.target = plus(this.target, plus(scaled(right, pixel * (middle('x') - 1)), scaled(upright, -pixel * (middle('y') - 1))));
  }

  /** @param {Vector[]} places in the axes of `extent` */
  filledBy(places) {
    const project = this.projection(2 * this.aspect, 2);
    return places.reduce((most, place) => {
      const {x, y} = project(plus(this.carried, place));
      return Math.max(most, Math.abs(x / this.aspect - 1), Math.abs(y - 1));
    }, 1e-3);
  }

  /** @param {number} azimuth @param {number} elevation in radians */
  turn(azimuth, elevation) {
    this.touched = true;
    this.azimuth += azimuth;
    this.elevation = Math.max(-k_steepest, Math.min(k_steepest, this.elevation + elevation));
  }

  /** @param {number} factor below 1: nearer */
  zoom(factor) {
    this.touched = true;
    const usual = this.extent.radius / Math.sin(k_field / 2);
    this.distance = Math.max(0.05 * usual, Math.min(20 * usual, this.distance * factor));
  }

  /** @returns {Vector} from the target to the eye, of length 1 */
  direction() {
    const level = plus(scaled(this.first, Math.cos(this.azimuth)), scaled(this.second, Math.sin(this.azimuth)));
    return plus(scaled(level, Math.cos(this.elevation)), scaled(this.up, Math.sin(this.elevation)));
  }

  aim() {
    return plus(this.target, this.carried);
  }

  eye() {
    return plus(this.aim(), scaled(this.direction(), this.distance));
  }

  /** @returns {{back: Vector, right: Vector, upright: Vector}} of the window */
  axes() {
    const back = this.direction();
    const right = unit(cross(this.up, back));
    return {back, right, upright: cross(back, right)};
  }

  /** @param {number} width @param {number} height @returns {(place: Vector) => {x: number, y: number, depth: number, scale: number}} pixels; scale: pixels for a unit of length there */
  projection(width, height) {
    const {back, right, upright} = this.axes();
    const eye = this.eye();
    const focus = 0.5 * height / Math.tan(k_field / 2);
    return (place) => {
      const seen = minus(place, eye);
      const depth = Math.max(-dot(seen, back), 1e-3 * this.distance);
      const scale = focus / depth;
      return {x: 0.5 * width + dot(seen, right) * scale, y: 0.5 * height - dot(seen, upright) * scale, depth, scale};
    };
  }
}
