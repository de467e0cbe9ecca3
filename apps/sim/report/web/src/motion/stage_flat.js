// The scene drawn on a plane, with perspective but without hidden surfaces: for browsers without WebGL.

import {arrowOf} from './arrows.js';
import {bodyColour} from './colours.js';
import {boxEdges, circle, ground} from './ground.js';
import {isVector} from './frames.js';
import {plus, scaled, turned} from './vectors.js';

/** @typedef {import('../types.js').Vector} Vector */
/** @typedef {import('./stage.js').Scene} Scene */
/** @typedef {(place: Vector) => {x: number, y: number, depth: number, scale: number}} Projection */

export class FlatStage {
  /** @param {HTMLCanvasElement} canvas @param {import('../types.js').Motion} motion */
  constructor(canvas, motion) {
    this.kind = 'flat';
    this.canvas = canvas;
    this.motion = motion;
    this.pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    this.size = [1, 1];
  }

  /** @param {number} width @param {number} height @param {number} density */
  resize(width, height, density) {
    this.size = [width, height];
    this.canvas.width = Math.round(width * density);
    this.canvas.height = Math.round(height * density);
    this.pen.setTransform(density, 0, 0, density, 0, 0);
  }

  destroy() {}

  /** @param {Scene} scene */
  draw(scene) {
    const [width, height] = this.size;
    const project = scene.camera.projection(width, height);
    this.pen.clearRect(0, 0, width, height);
    this.pen.lineCap = this.pen.lineJoin = 'round';
    for (const line of ground(scene.camera).lines) this.path(project, line, scene.colours.ground, 1);
    scene.traces.forEach((trace, i) => this.path(project, trace, bodyColour(scene.colours, i), 1.5, 0.7));
    for (const line of scene.frame.lines) if (line) this.path(project, line, scene.colours.line, 4);
    for (const draw of this.bodies(scene, project)) draw();
    for (const reaction of scene.frame.reactions) if (reaction) this.arrow(project, reaction, scene);
  }

  /** The farthest first. @param {Scene} scene @param {Projection} project */
  bodies(scene, project) {
    const bodies = this.motion.bodies ?? [];
    return scene.frame.bodies.map((pose, i) => ({pose, body: bodies[i], colour: bodyColour(scene.colours, i)}))
      .flatMap(({pose, body, colour}) => pose ? [{depth: project(pose.position).depth, draw: () => this.body(project, pose, body, colour)}] : [])
      .sort((a, b) => b.depth - a.depth).map(({draw}) => draw);
  }

  /** @param {Projection} project @param {import('./frames.js').Pose} pose @param {import('../types.js').Body} body @param {string} colour */
  body(project, pose, {shape}, colour) {
    const place = (/** @type {Vector} */ local) => plus(pose.position, turned(pose.orientation, local));
    if (!shape || shape.kind === 'none') return;
    if (shape.kind === 'sphere') return this.disc(project, pose.position, shape.radius ?? 0, colour, shape.see_through);
    if (shape.kind === 'box' && isVector(shape.size)) {
      for (const edge of boxEdges(/** @type {Vector} */ (shape.size))) this.path(project, edge.map(place), colour, 2);
      return undefined;
    }
    if (shape.kind === 'cylinder') return this.tube(project, place, shape.radius ?? 0, shape.length ?? 0, colour);
    return this.disc(project, pose.position, 0, colour);
  }

  /** @param {Projection} project @param {Vector} middle @param {number} radius @param {string} colour @param {boolean} [hollow] */
  disc(project, middle, radius, colour, hollow = false) {
    const {x, y, scale} = project(middle);
    this.pen.beginPath();
    this.pen.arc(x, y, Math.max(radius * scale, 4), 0, 2 * Math.PI);
    this.pen.globalAlpha = hollow ? 0.15 : 1;
    this.pen.fillStyle = colour;
    this.pen.fill();
    this.pen.globalAlpha = 1;
    this.pen.strokeStyle = colour;
    this.pen.lineWidth = 1.5;
    this.pen.stroke();
  }

  /** @param {Projection} project @param {(local: Vector) => Vector} place @param {number} radius @param {number} length @param {string} colour */
  tube(project, place, radius, length, colour) {
    const ends = [-0.5 * length, 0.5 * length];
    for (const z of ends) this.path(project, circle(radius, z).map(place), colour, 1.5);
    this.path(project, [0, 16].map((i) => place(circle(radius, 0)[i])), colour, 1.5);  // shows that it turns
    for (let i = 0; i < 8; ++i) this.path(project, ends.map((z) => place(circle(radius, z)[4 * i])), colour, 1, 0.6);
  }

  /** @param {Projection} project @param {Vector[]} places @param {string} colour @param {number} width @param {number} [opacity] */
  path(project, places, colour, width, opacity = 1) {
    if (places.length < 2) return;
    this.pen.beginPath();
    places.map(project).forEach(({x, y}, i) => i === 0 ? this.pen.moveTo(x, y) : this.pen.lineTo(x, y));
    this.pen.globalAlpha = opacity;
    this.pen.strokeStyle = colour;
    this.pen.lineWidth = width;
    this.pen.stroke();
    this.pen.globalAlpha = 1;
  }

  /** @param {Projection} project @param {{at: Vector, force: Vector}} reaction @param {Scene} scene */
  arrow(project, reaction, {arrow: perForce, longest, colours}) {
    const arrow = arrowOf(reaction, perForce, longest);
    if (!arrow) return;
    const [from, to] = [project(reaction.at), project(plus(reaction.at, scaled(arrow.along, arrow.length)))];
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    if (length < 2) return;
    const [x, y] = [(to.x - from.x) / length, (to.y - from.y) / length];
    const head = Math.min(12, 0.6 * length);
    const pen = this.pen;
    pen.strokeStyle = pen.fillStyle = colours.reaction;
    pen.lineWidth = 3;
    pen.beginPath();
    pen.moveTo(from.x, from.y);
    pen.lineTo(to.x - x * head, to.y - y * head);
    pen.stroke();
    for (const back of arrow.isCut ? [0, head] : [0]) {
      const tip = {x: to.x - back * x, y: to.y - back * y};
      pen.beginPath();
      pen.moveTo(tip.x, tip.y);
      pen.lineTo(tip.x - head * x - 0.45 * head * y, tip.y - head * y + 0.45 * head * x);
      pen.lineTo(tip.x - head * x + 0.45 * head * y, tip.y - head * y - 0.45 * head * x);
      pen.fill();
    }
  }
}
