// Fronts, cheapest settings and costs of a digit, against their definitions.

import assert from 'node:assert/strict';
import test from 'node:test';
import {digitCost, digitCostBetween} from '../../../apps/sim/report/web/src/maths/digit_cost.js';
import {paretoFront} from '../../../apps/sim/report/web/src/maths/pareto.js';
import {alikeBut, cheapest, front, targets} from '../../../apps/sim/report/web/src/maths/points.js';
import {random} from './sample/random.mjs';
import {markFront} from './sample/runs.mjs';
import {study} from './sample/study.mjs';

const point = (error, time_s, more = {}) => ({method: 'm', status: 'ok', error, time_s, ...more});
const ids = (points) => points.map(({id}) => id).sort((a, b) => a - b);

test('the front is what nobody beats, by the definition, with ties and zeros', () => {
  const rand = random(7);
  for (let round = 0; round < 200; ++round) {
    // Few values, so that many are equal.
    const points = Array.from({length: 30}, (_, id) => ({id, ...point(Math.floor(6 * rand()), Math.floor(6 * rand()))}));
    const expected = points.filter((a) => !points.some((b) => b.error <= a.error && b.time_s <= a.time_s && (b.error < a.error || b.time_s < a.time_s)));
    assert.deepEqual(ids(paretoFront(points, (p) => p.error, (p) => p.time_s)), ids(expected));
  }
});

test('the front comes by error, and falls in time', () => {
  const found = front(study().problems[0].points);
  assert.ok(found.length > 5);
  for (let i = 1; i < found.length; ++i) assert.ok(found[i].error > found[i - 1].error && found[i].time_s < found[i - 1].time_s);
});

test('the front of the page is the front of the study', () => {
  for (const {points} of study().problems) assert.deepEqual(ids(front(points)), ids(points.filter(({pareto}) => pareto)));
});

test('settings are compared where all others are alike', () => {
  const run = (formulation, method, projection) => ({...point(1e-6, 1), formulation, method, projection, code: 'optimised', number: 'double'});
  const points = [run('a', 'taylor', 'full'), run('a', 'taylor', 'off'), run('a', 'rk4', 'full'), run('b', 'taylor', 'full'), run('b', 'prince87', 'full'), run('a', 'prince87', 'full')];
  assert.deepEqual(alikeBut(points, 'formulation'), [points[0], points[3], points[4], points[5]]);
  assert.deepEqual(alikeBut(points, 'projection'), [points[0], points[1]]);
  assert.deepEqual(alikeBut([points[1], points[3]], 'formulation'), []);
  // What a method does not take was not tried with it.
  const both = [run('a', 'taylor', 'full'), {...run('a', 'taylor', 'velocities'), status: 'refused'}, run('a', 'prince87', 'full'), run('a', 'prince87', 'velocities')];
  assert.deepEqual(alikeBut(both, 'projection'), [both[2], both[3]]);
});

test('what failed, or has no error or time, is on no front', () => {
  const points = [point(1e-9, 1, {status: 'failed'}), point(null, 1), point(1e-3, null), point(NaN, 1), point(1e-2, 2)];
  assert.deepEqual(front(points), [points[4]]);
  assert.deepEqual(markFront(points.map((p) => ({...p}))).map(({pareto}) => Boolean(pareto)), [false, false, false, false, true]);
});

test('the cheapest setting may be more exact than asked for, and is a run that was made', () => {
  const points = [point(1e-3, 5), point(1e-7, 3), point(1e-9, 8), point(1e-12, 1, {status: 'failed'})];
  assert.equal(cheapest(points, 1e-3), points[1]);
  assert.equal(cheapest(points, 1e-7), points[1]);
  assert.equal(cheapest(points, 1e-8), points[2]);
  assert.equal(cheapest(points, 1e-10), null);
});

test('errors asked for go on as far as somebody gets', () => {
  assert.deepEqual(targets([]).slice(-1), [1e-12]);
  assert.deepEqual(targets([point(3e-22, 1)]).slice(-2), [1e-18, 1e-21]);
  assert.deepEqual(targets([point(1e-14, 1)]).slice(-3), [1e-12, 1e-13, 1e-14]);
});

test('a digit costs what the law of a method says: order 5 costs 10^(1/5)', () => {
  const law = Array.from({length: 10}, (_, i) => point(10 ** -i, 1e-4 * 10 ** (i / 5)));
  const cost = digitCost(law);
  assert.ok(Math.abs(cost.factor - 10 ** 0.2) < 1e-12);
  assert.equal(cost.runs, 10);
  assert.ok(Math.abs(digitCostBetween(law, 1e-3, 1e-6) - 10 ** 0.2) < 1e-12);
});

test('runs that waste time or are held up by rounding do not count', () => {
  const law = Array.from({length: 8}, (_, i) => point(10 ** -i, 1e-4 * 10 ** (i / 4)));
  const wasted = [point(1e-2, 5), point(3e-7, 9), point(0, null), point(1e-9, 1e-9, {status: 'failed'})];
  assert.equal(digitCost([...law, ...wasted]).factor, digitCost(law).factor);
});

test('too little to tell is no cost', () => {
  assert.equal(digitCost([]), null);
  assert.equal(digitCost([point(1e-3, 1), point(1e-6, 2)]), null);
  assert.equal(digitCost([point(1e-3, 1), point(9e-4, 2), point(8e-4, 3)]), null);
  assert.equal(digitCostBetween([point(1e-4, 1), point(1e-6, 2), point(1e-8, 3)], 1e-3, 1e-6), null);
});
