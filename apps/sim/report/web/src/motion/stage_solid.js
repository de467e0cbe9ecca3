// The scene drawn by WebGL, with three.js.

import {
  BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, DoubleSide, Group, HemisphereLight, Line, LineBasicMaterial,
  LineSegments, Mesh, MeshStandardMaterial, PerspectiveCamera, Quaternion, Scene as World, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';
import {arrowOf} from './arrows.js';
import {bodyColour} from './colours.js';
import {isVector} from './frames.js';
import {ground} from './ground.js';
import {k_field} from './camera.js';
import {plus, scaled} from './vectors.js';

/** @typedef {import('../types.js').Vector} Vector */
/** @typedef {import('./stage.js').Scene} Scene */

const k_along = new Vector3(0, 1, 0);  // of three's cylinders and cones

export class SolidStage {
  /** @param {HTMLCanvasElement} canvas @param {WebGL2RenderingContext} context @param {import('../types.js').Motion} motion */
  constructor(canvas, context, motion) {
    this.kind = 'solid';
    this.motion = motion;
    this.renderer = new WebGLRenderer({canvas, context, alpha: true, antialias: true, preserveDrawingBuffer: true});
    this.renderer.setClearColor(0x000000, 0);
    this.world = new World();
    this.eye = new PerspectiveCamera(k_field * 180 / Math.PI, 1, 0.01, 100);
    this.parts = /** @type {ReturnType<typeof partsOf> | null} */ (null);
    this.colours = /** @type {Scene['colours'] | null} */ (null);
    this.extent = /** @type {import('./frames.js').Extent | null} */ (null);
  }

  /** @param {number} width @param {number} height @param {number} density */
  resize(width, height, density) {
    this.renderer.setPixelRatio(density);
    this.renderer.setSize(width, height, false);
    this.eye.aspect = width / height;
  }

  destroy() {
    this.clear();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  clear() {
    this.world.traverse((/** @type {any} */ part) => {
      part.geometry?.dispose();
      part.material?.dispose();
    });
    this.world.clear();
  }

  /** @param {Scene} scene */
  draw(scene) {
    if (!this.parts || this.colours !== scene.colours || this.extent !== scene.camera.extent) this.build(scene);
    const parts = /** @type {ReturnType<typeof partsOf>} */ (this.parts);
    scene.frame.bodies.forEach((pose, i) => putBody(parts.bodies[i], pose));
    scene.frame.lines.forEach((places, i) => putRods(parts.lines[i], places));
    scene.frame.reactions.forEach((reaction, i) => putArrow(parts.reactions[i], reaction, scene, parts.thickness));
    scene.traces.forEach((trace, i) => putTrace(parts.traces[i], trace));
    putGrid(parts.grid, scene.camera);
    this.look(scene.camera);
    this.renderer.render(this.world, this.eye);
  }

  /** @param {Scene} scene */
  build(scene) {
    this.clear();
    this.colours = scene.colours;
    this.extent = scene.camera.extent;  // rods are as thick as it is large
    this.parts = partsOf(this.motion, scene);
    const {bodies, lines, reactions, traces, grid} = this.parts;
    this.world.add(...lights(scene.camera.up), grid, ...bodies, ...lines, ...reactions, ...traces);
  }

  /** @param {import('./camera.js').Camera} camera */
  look(camera) {
    this.eye.near = 0.01 * camera.distance;
    this.eye.far = camera.distance + 20 * camera.extent.radius;
    this.eye.up.set(...camera.up);
    this.eye.position.set(...camera.eye());
    this.eye.lookAt(...camera.aim());
    this.eye.updateProjectionMatrix();
  }
}

/** @param {Vector} up */
function lights(up) {
  const sky = new HemisphereLight(0xffffff, 0x8a94a0, 2.1);
  sky.position.set(...up);
  const sun = new DirectionalLight(0xffffff, 1.9);
  sun.position.set(...plus(scaled(up, 2), [0.7, -1.1, 0.4]));
  return [sky, sun];
}

/** @param {import('../types.js').Motion} motion @param {Scene} scene */
function partsOf(motion, scene) {
  const {colours, camera} = scene;
  const thickness = 0.012 * camera.extent.radius;
  return {
    thickness, grid: gridOf(camera, colours.ground),
    bodies: (motion.bodies ?? []).map((body, i) => bodyOf(body, bodyColour(colours, i), 2 * thickness)),
    lines: (motion.lines ?? []).map((line) => rodsOf(Math.max(...(line.points ?? []).map((places) => places?.length ?? 0), 0) - 1, thickness, colours.line)),
    reactions: (motion.reactions ?? []).map(() => arrowParts(thickness, colours.reaction)),
    traces: scene.traces.map((_, i) => traceOf(motion.t.length + 1, bodyColour(colours, i))),
  };
}

const matt = (/** @type {string} */ colour, seeThrough = false) => new MeshStandardMaterial({
  color: new Color(colour), roughness: 0.55, metalness: 0.05, transparent: seeThrough, opacity: seeThrough ? 0.16 : 1, depthWrite: !seeThrough, side: seeThrough ? DoubleSide : 0,
});

/** @param {import('./camera.js').Camera} camera @param {string} colour */
function gridOf(camera, colour) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(ground(camera).lines.flat(2)), 3));
  const grid = new LineSegments(geometry, new LineBasicMaterial({color: new Color(colour)}));
  grid.frustumCulled = false;  // it goes along with what is followed
  return grid;
}

/** @param {LineSegments} grid @param {import('./camera.js').Camera} camera */
function putGrid(grid, camera) {
  const position = grid.geometry.getAttribute('position');
  ground(camera).lines.flat().forEach(([x, y, z], i) => position.setXYZ(i, x, y, z));
  position.needsUpdate = true;
}

/** @param {import('../types.js').Body} body @param {string} colour @param {number} dot radius of a point */
function bodyOf({shape}, colour, dot) {
  const group = new Group();
  const geometry = shapeOf(shape, dot);
  if (!geometry) return group;
  group.add(new Mesh(geometry, matt(colour, shape?.see_through)));
  // Alone they would not show that they turn.
  if (shape?.kind === 'sphere' && !shape.see_through) group.add(...stripes(shape.radius ?? 0));
  if (shape?.kind === 'cylinder' && !shape.see_through) group.add(bar(shape.radius ?? 0, shape.length ?? 0));
  return group;
}

/** Across a disc, seen from both sides. @param {number} radius @param {number} length */
const bar = (radius, length) => new Mesh(new BoxGeometry(1.9 * radius, 0.12 * radius, 1.05 * length), matt('#ffffff'));

/** @param {number} radius */
const stripes = (radius) => [0, Math.PI / 2].map((turn) => {
  const mesh = new Mesh(new CylinderGeometry(1.004 * radius, 1.004 * radius, 0.1 * radius, 48, 1, true), matt('#ffffff'));
  mesh.rotation.x = turn;
  return mesh;
});

/** @param {import('../types.js').Shape | undefined} shape @param {number} dot */
function shapeOf(shape, dot) {
  if (!shape || shape.kind === 'none') return null;
  if (shape.kind === 'sphere') return new SphereGeometry(shape.radius ?? dot, 40, 24);
  if (shape.kind === 'box' && isVector(shape.size)) return new BoxGeometry(.../** @type {Vector} */ (shape.size));
  // Around z, as the format says; three's are around y.
  if (shape.kind === 'cylinder') return new CylinderGeometry(shape.radius, shape.radius, shape.length, 56, 1, shape.see_through).rotateX(Math.PI / 2);
  return new SphereGeometry(dot, 16, 12);
}

/** @param {Group} group @param {import('./frames.js').Pose | null} pose */
function putBody(group, pose) {
  group.visible = pose !== null;
  if (!pose) return;
  const [w, x, y, z] = pose.orientation;
  group.position.set(...pose.position);
  group.quaternion.set(x, y, z, w);
}

/** Rods, then their ends. @param {number} count @param {number} radius @param {string} colour */
function rodsOf(count, radius, colour) {
  const group = new Group();
  for (let i = 0; i < count; ++i) group.add(new Mesh(new CylinderGeometry(radius, radius, 1, 16), matt(colour)));
  for (let i = 0; i <= count; ++i) group.add(new Mesh(new SphereGeometry(1.5 * radius, 16, 12), matt(colour)));
  return group;
}

/** @param {Group} group @param {Vector[] | null} places */
function putRods(group, places) {
  const count = (group.children.length - 1) / 2;
  group.children.slice(0, count).forEach((rod, i) => {
    rod.visible = Boolean(places && places[i + 1]);
    if (places && rod.visible) span(rod, places[i], places[i + 1]);
  });
  group.children.slice(count).forEach((end, i) => {
    end.visible = Boolean(places && places[i]);
    if (places && end.visible) end.position.set(...places[i]);
  });
}

/** Puts a cylinder of length 1 between two places. @param {import('three').Object3D} rod @param {Vector} from @param {Vector} to */
function span(rod, from, to) {
  const [a, b] = [new Vector3(...from), new Vector3(...to)];
  const along = b.clone().sub(a);
  const length = Math.max(along.length(), 1e-12);
  rod.position.copy(a.add(b).multiplyScalar(0.5));
  rod.quaternion.copy(new Quaternion().setFromUnitVectors(k_along, along.divideScalar(length)));
  rod.scale.set(1, length, 1);
}

/** A shaft, a head, and a second one for arrows that are cut. They are seen through bodies, in which they may be. @param {number} radius @param {string} colour */
function arrowParts(radius, colour) {
  const group = new Group();
  const shapes = [new CylinderGeometry(radius, radius, 1, 16), ...[0, 1].map(() => new ConeGeometry(2.6 * radius, 7 * radius, 20))];
  for (const shape of shapes) {
    const part = new Mesh(shape, matt(colour));
    part.material.depthTest = false;
    part.renderOrder = 1;
    group.add(part);
  }
  return group;
}

/** @param {Group} group @param {{at: Vector, force: Vector} | null} reaction @param {Scene} scene @param {number} thickness */
function putArrow(group, reaction, scene, thickness) {
  const arrow = reaction && arrowOf(reaction, scene.arrow, scene.longest);
  group.visible = arrow !== null && arrow.length > thickness;
  if (!reaction || !arrow || !group.visible) return;
  const [shaft, ...heads] = group.children;
  const headLength = Math.min(7 * thickness, 0.6 * arrow.length);
  const place = (/** @type {number} */ back) => plus(reaction.at, scaled(arrow.along, arrow.length - back));
  span(shaft, reaction.at, place(headLength));
  heads.forEach((head, i) => {
    head.visible = i === 0 || arrow.isCut;
    head.position.set(...place((i + 0.5) * headLength));
    head.quaternion.copy(shaft.quaternion);
    head.scale.setScalar(headLength / (7 * thickness));
  });
}

/** @param {number} most @param {string} colour */
function traceOf(most, colour) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * most), 3));
  const line = new Line(geometry, new LineBasicMaterial({color: new Color(colour), transparent: true, opacity: 0.75}));
  line.frustumCulled = false;  // its box would have to follow the places
  return line;
}

/** @param {Line} line @param {Vector[]} places */
function putTrace(line, places) {
  const position = line.geometry.getAttribute('position');
  places.forEach(([x, y, z], i) => position.setXYZ(i, x, y, z));
  position.needsUpdate = true;
  line.geometry.setDrawRange(0, places.length);
}
