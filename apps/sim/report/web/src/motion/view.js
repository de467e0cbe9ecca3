// The motion with its controls: play, speed, time, arrows, traces, camera.

import {isNumber, plain} from '../format.js';
import {el} from '../ui/dom.js';
import {scaleOf, tipsOf} from './arrows.js';
import {Camera} from './camera.js';
import {sceneColours} from './colours.js';
import {controls} from './controls.js';
import {centreOf, extent, frameAt, isVector, largestReaction, reachAlong, sampleAt, travel, upOf} from './frames.js';
import {Player} from './player.js';
import {flatStageIn, stageIn} from './stage.js';
import {size} from './vectors.js';

/** @typedef {import('../types.js').Vector} Vector */

const k_turn = 0.09;        // radians for a key
const k_travels = 3;        // times its own size, and a mechanism may be followed
const k_gets_lost = 4;      // and it is followed from the beginning
const k_rounding = 1e-12;    // of the largest reaction
const k_paper = /** @type {[number, number]} */ ([460, 256]);

export class MotionView {
  /** @param {import('../types.js').Motion} motion @param {() => boolean} dark */
  constructor(motion, dark) {
    this.motion = motion;
    this.dark = dark;
    this.colours = sceneColours(dark());
    this.whole = extent(motion);
    const way = travel(motion);
    this.followed = way && way.times >= k_travels ? way.extent : null;
    this.follows = way !== null && way.times >= k_gets_lost;
    this.scale = scaleOf(motion);
    this.camera = new Camera(upOf(motion), this.whole);
    this.look();
    this.largest = largestReaction(motion);
    this.player = new Player(motion.t[0], motion.t[motion.t.length - 1], () => this.show());
    this.stage = /** @type {ReturnType<typeof stageIn> | null} */ (null);
    this.place = el('div', {class: 'stage', tabindex: 0, role: 'application', 'aria-roledescription': 'moving picture', 'aria-label': this.label(), keydown: (/** @type {KeyboardEvent} */ event) => this.key(event)});
    this.ui = controls({
      start: this.player.start, end: this.player.end, hasReactions: this.largest !== null, travels: this.followed !== null, follows: this.follows, toggle: () => this.toggle(), seek: (time) => this.player.seek(time),
      speed: (factor) => { this.player.speed = factor; }, show: () => this.show(), first: () => this.firstView(), follow: (on) => this.follow(on),
    });
    this.values = el('dl', {class: 'pairs reactions'});
    this.element = el('div', {class: 'motion'}, el('div', {class: 'motion-picture'}, this.place, this.ui.bar), el('div', {class: 'motion-side'}, this.ui.sliders, this.reactionList(), el('p', {class: 'note'}, 'Drag or arrow keys turn the view, the wheel or plus and minus zoom, space plays.')));
    this.pointer();
    new ResizeObserver(() => this.fit()).observe(this.place);
  }

  label() {
    const names = (this.motion.bodies ?? []).map(({name}) => name).join(', ');
    return `The motion${names ? ` of ${names}` : ''}. Space plays and stops, arrow keys turn the view, plus and minus zoom, comma and full stop go to the sample before and after, 0 brings the first view back${this.followed ? ', f follows the mechanism or holds its whole path' : ''}.`;
  }

  reactionList() {
    const cut = this.scale.isCut ? el('p', {class: 'note cut'}, `Arrows of more than ${plain(this.scale.longest / this.scale.perForce, 2)} ${this.largest?.unit ?? ''} would leave the picture: they are cut, and have two heads.`) : null;
    return this.largest ? el('div', {}, el('h4', {}, 'Reactions now'), this.values, cut) : el('p', {class: 'note'}, 'No reaction is known as a force on a body, so that none is drawn.');
  }

  /** A floor on which something goes along lies still; below what climbs or falls far it goes with it. */
  look() {
    const tips = (/** @type {import('./frames.js').Extent} */ {radius}) => tipsOf(this.motion, this.scale, radius, this.follows);
    if (!this.follows || !this.followed) return this.camera.show(this.whole, null, tips(this.whole));
    const [[lowest, highest], [low, high]] = [this.whole, this.followed].map((box) => reachAlong(box, this.camera.up));
    return this.camera.show(this.followed, highest - lowest < 2 * (high - low) ? lowest : null, tips(this.followed));
  }

  /** @param {boolean} on or else the whole path is held */
  follow(on) {
    if (!this.followed) return;
    this.follows = on;
    this.ui.camera.value = on ? 'follow' : 'whole';
    this.look();
    this.show();
  }

  firstView() {
    this.camera.reset();
    this.show();
  }

  toggle() {
    if (this.player.playing) this.player.pause();
    else this.player.play();
  }

  /** A stage is made when it is seen, and given back when it is not: browsers allow few of them. */
  open() {
    if (this.stage) return;
    this.stage = stageIn(this.place, this.motion);
    this.place.dataset.stage = this.stage.kind;
    this.fit();
  }

  /** As it stands, in light colours, also where the page is not open and so has no size. */
  print() {
    this.colours = sceneColours(false);
    this.stage ??= flatStageIn(this.place, this.motion);
    this.fit(...k_paper);
    this.show();
  }

  close() {
    this.player.pause();
    this.stage?.destroy();
    this.stage = null;
  }

  /** The colours of the page have changed. */
  refresh() {
    this.colours = sceneColours(this.dark());
    this.show();
  }

  /** @param {number} [otherWidth] @param {number} [otherHeight] where the place has no size */
  fit(otherWidth = 0, otherHeight = 0) {
    if (!this.stage) return;
    const [width, height] = [this.place.clientWidth || otherWidth, this.place.clientHeight || otherHeight];
    if (width === 0 || height === 0) return;
    this.stage.resize(width, height, Math.min(globalThis.devicePixelRatio || 1, 2));
    this.camera.shape(width / height);
    this.show();
  }

  show() {
    const {player} = this;
    const frame = frameAt(this.motion, player.time);
    this.ui.play.textContent = player.playing ? 'Pause' : 'Play';
    this.ui.scrub.value = String(player.time);
    this.ui.clock.textContent = `${player.time.toFixed(2)} s`;
    this.say(frame);
    if (this.follows) this.camera.carried = centreOf(this.motion, frame);
    this.stage?.draw({frame, camera: this.camera, colours: this.colours, traces: this.ui.traced.checked ? this.traces() : this.motion.bodies?.map(() => []) ?? [], ...this.arrows()});
  }

  /** As somebody wants them: those of the first view are as long as `scale` says. */
  arrows() {
    const unit = Number(this.ui.arrows.value) * this.camera.extent.radius;
    return {arrow: this.scale.perForce * unit, longest: this.scale.longest * unit};
  }

  /** Places of each body that moves, up to now. @returns {Vector[][]} */
  traces() {
    const [last] = sampleAt(this.motion.t, this.player.time);
    return (this.motion.bodies ?? []).map(({position}) => /** @type {Vector[]} */ ((position ?? []).slice(0, last + 1).filter(isVector)));
  }

  /** What rounding leaves of a force is none. @param {number} force */
  strength(force) {
    return force < k_rounding * (this.largest?.value ?? 0) ? '0' : fixed(force);
  }

  /** @param {import('./frames.js').Frame} frame */
  say(frame) {
    const rows = (this.motion.reactions ?? []).map(({name, body, unit}, i) => {
      const reaction = frame.reactions[i];
      return [body ? `${name} on ${body}` : name, reaction ? `${this.strength(size(reaction.force))} ${unit ?? ''}` : 'not known'];
    });
    this.values.replaceChildren(...rows.flatMap(([name, value]) => [el('dt', {}, name), el('dd', {}, value)]));
  }

  pointer() {
    let last = /** @type {[number, number] | null} */ (null);
    this.place.addEventListener('pointerdown', (event) => {
      last = [event.clientX, event.clientY];
      this.place.setPointerCapture(event.pointerId);
    });
    this.place.addEventListener('pointermove', (event) => {
      if (!last) return;
      this.turn(-0.008 * (event.clientX - last[0]), 0.008 * (event.clientY - last[1]));
      last = [event.clientX, event.clientY];
    });
    for (const end of ['pointerup', 'pointercancel']) this.place.addEventListener(end, () => { last = null; });
    // With a modifier, or when the picture has the focus: else the wheel scrolls the page.
    this.place.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && document.activeElement !== this.place) return;
      event.preventDefault();
      this.zoom(Math.exp(0.0015 * event.deltaY));
    }, {passive: false});
  }

  /** @param {number} azimuth @param {number} elevation */
  turn(azimuth, elevation) {
    this.camera.turn(azimuth, elevation);
    this.show();
  }

  /** @param {number} factor */
  zoom(factor) {
    this.camera.zoom(factor);
    this.show();
  }

  /** @param {number} by samples */
  step(by) {
    const {t} = this.motion;
    const [at] = sampleAt(t, this.player.time + 1e-9 * (this.player.end - this.player.start));
    this.player.pause();
    this.player.seek(t[Math.max(0, Math.min(t.length - 1, at + by))]);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const action = /** @type {Record<string, () => void>} */ ({
      ' ': () => this.toggle(), ArrowLeft: () => this.turn(-k_turn, 0), ArrowRight: () => this.turn(k_turn, 0), ArrowUp: () => this.turn(0, k_turn), ArrowDown: () => this.turn(0, -k_turn),
      '+': () => this.zoom(0.9), '=': () => this.zoom(0.9), '-': () => this.zoom(1 / 0.9), ',': () => this.step(-1), '.': () => this.step(1), '0': () => this.firstView(), f: () => this.follow(!this.follows),
    })[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }
}

/** Three digits that do not change their width while they run. @param {number} value */
const fixed = (value) => isNumber(value) && value >= 0.1 && value < 1e5 ? value.toFixed(value < 10 ? 2 : value < 1000 ? 1 : 0) : plain(value);
