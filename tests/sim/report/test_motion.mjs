// What a motion is at any time, how large it is beside its path, and what the camera that follows it sees.

import assert from 'node:assert/strict';
import test from 'node:test';
import {arrowOf, scaleOf, tipsOf} from '../../../apps/sim/report/web/src/motion/arrows.js';
import {Camera} from '../../../apps/sim/report/web/src/motion/camera.js';
import {centreOf, extent, frameAt, travel, upOf, usualReaction} from '../../../apps/sim/report/web/src/motion/frames.js';
import {ground} from '../../../apps/sim/report/web/src/motion/ground.js';
import {motions} from './sample/motions.mjs';

const disc = motions.rolling_disc();

/** Two bodies, a unit apart, that go 50 units along x. */
const pair = () => {
  const t = Array.from({length: 51}, (_, i) => i);
  return {t, bodies: [{name: 'a', position: t.map((x) => [x, 0, 0])}, {name: 'b', position: t.map((x) => [x, 0, 1])}]};
};

test('what goes far is many times its own size away, what swings is not', () => {
  assert.ok(Math.abs(travel(pair()).times - Math.hypot(50, 1)) < 1e-9);
  assert.ok(travel(disc).times > 4);
  for (const name of ['double_pendulum', 'slider_crank', 'four_bar', 'lagrange_top']) assert.ok(travel(motions[name]()).times < 3, name);
});

test('a lone body, whose size nobody knows, is not followed', () => {
  const {t, bodies: [body]} = pair();
  assert.equal(travel({t, bodies: [{...body, shape: {kind: 'box', size: [2, 2, 2]}}]}), null);
});

test('the box of what is followed is that of the mechanism, from its centre, and has all of it at any time', () => {
  const {extent: {low, high, radius}} = travel(pair());
  assert.deepEqual([low, high, radius], [[0, 0, -0.5], [0, 0, 0.5], 0.5]);
  const {extent: box} = travel(disc);
  for (const time of disc.t) {
    const centre = centreOf(disc, frameAt(disc, time));
    const {bodies: [{position}], reactions: [{at}]} = frameAt(disc, time);
    for (const place of [position, at]) place.forEach((part, i) => assert.ok(part - centre[i] >= box.low[i] - 1e-9 && part - centre[i] <= box.high[i] + 1e-9));
  }
});

test('a camera that follows keeps the mechanism in the middle and larger; one that holds the path does not', () => {
  const camera = new Camera(upOf(disc), extent(disc));
  const seen = (time) => camera.projection(800, 400)(frameAt(disc, time).bodies[0].position);
  const far = [0, 2, 4].map(seen);
  assert.ok(Math.hypot(far[0].x - far[2].x, far[0].y - far[2].y) > 80);
  camera.show(travel(disc).extent, 0);
  const near = [0, 2, 4].map((time) => {
    camera.carried = centreOf(disc, frameAt(disc, time));
    return seen(time);
  });
  for (const {x, y, scale} of near) {
    assert.ok(Math.hypot(x - near[0].x, y - near[0].y) < 1e-9);
    assert.ok(Math.abs(x - 400) < 100 && Math.abs(y - 200) < 100);
    assert.ok(scale > 2 * Math.max(...far.map((one) => one.scale)));
  }
  assert.ok(camera.filling() > 0.7 && camera.filling() < 0.8, 'the first view fits wherever the mechanism is');
});

test('the grid below what is followed stays on the same lines, at the same height', () => {
  const camera = new Camera([0, 0, 1], extent(disc));
  camera.show(travel(disc).extent, -0.25);
  for (const time of [0, 1.3, 7.7]) {
    camera.carried = centreOf(disc, frameAt(disc, time));
    const {lines, cell} = ground(camera);
    for (const [from] of lines) {
      assert.equal(from[2], -0.25);
      for (const part of from.slice(0, 2)) assert.ok(Math.abs(part / cell - Math.round(part / cell)) < 1e-9);
    }
    const middle = lines.flat().reduce((sum, place) => sum.map((part, i) => part + place[i] / lines.length / 2), [0, 0, 0]);
    assert.ok(Math.abs(middle[0] - camera.aim()[0]) <= cell && Math.abs(middle[1] - camera.aim()[1]) <= cell);
  }
});

test('one peak of a reaction does not make all other arrows short', () => {
  const t = [0, 1, 2, 3, 4];
  const force = [1, 2, 3, 2, 900].map((x) => [x, 0, 0]);
  assert.equal(usualReaction({t, reactions: [{name: 'r', at: force, force}, {name: 's', at: force, force: [null, [0, 2.5, 0], null, null, null]}]}), 2.5);
  assert.equal(usualReaction({t, bodies: []}), 0);
});

/** A pendulum's support that is hit once: one force is far beyond all others. */
const hit = () => {
  const motion = motions.double_pendulum();
  motion.reactions.forEach((reaction) => { reaction.force = reaction.force.map((force, i) => i === 40 && force ? force.map((part) => 300 * part) : force); });
  return motion;
};

/** As the page looks at a motion first. */
function firstView(motion, aspect) {
  const way = travel(motion);
  const follows = way !== null && way.times > 4;
  const box = follows ? way.extent : extent(motion);
  const camera = new Camera(upOf(motion), box);
  camera.show(box, null, tipsOf(motion, scaleOf(motion), box.radius, follows));
  camera.shape(aspect);
  return {camera, follows};
}

for (const [name, motion] of Object.entries({...motions, hit})) {
  test(`${name}: arrows end within the first view at any time, and usual ones can be seen`, () => {
    const shown = motion();
    const scale = scaleOf(shown);
    for (const aspect of [0.9, 1.6, 2.4]) {
      const {camera, follows} = firstView(shown, aspect);
      const lengths = [];
      for (const time of shown.t) {
        const frame = frameAt(shown, time);
        if (follows) camera.carried = centreOf(shown, frame);
        const project = camera.projection(400 * aspect, 400);
        for (const reaction of frame.reactions) {
          const arrow = reaction && arrowOf(reaction, scale.perForce * camera.extent.radius, scale.longest * camera.extent.radius);
          if (!arrow) continue;
          const [from, to] = [0, arrow.length].map((part) => project(reaction.at.map((value, i) => value + part * arrow.along[i])));
          assert.ok(to.x >= 0 && to.x <= 400 * aspect && to.y >= 0 && to.y <= 400, `${to.x} ${to.y} at ${time}`);
          lengths.push(Math.hypot(to.x - from.x, to.y - from.y));
        }
      }
      if (lengths.length > 0) assert.ok(Math.max(...lengths.sort((a, b) => a - b).slice(0, Math.ceil(0.6 * lengths.length))) > 12, String(lengths[Math.floor(0.6 * lengths.length)]));
      assert.ok(camera.filling() > 0.4, `the mechanism takes ${camera.filling()} of the view`);
    }
  });
}

test('arrows are as long as forces are strong, and what is cut says so', () => {
  const [scale, peaked] = [motions.slider_crank, hit].map((motion) => scaleOf(motion()));
  assert.equal(scale.isCut, false);
  assert.equal(peaked.isCut, true);
  const at = [0, 0, 0];
  const [one, two, ten] = [[0.2, 0, 0], [0, 0.4, 0], [0, 0, -2]].map((force) => arrowOf({at, force}, 1, 0.6));
  assert.deepEqual([one.length, two.length, ten.length, ten.along], [0.2, 0.4, 0.6, [0, 0, -1]]);
  assert.deepEqual([one, two, ten].map(({isCut}) => isCut), [false, false, true]);
  assert.equal(arrowOf({at, force: at}, 1, 0.6), null);
});
