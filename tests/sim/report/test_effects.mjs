// What charts say of effects, without a browser: sets are compared as gauss-sim --need compares them, and nothing is left out without a word.

import assert from 'node:assert/strict';
import test from 'node:test';
import {chartsOf, isOfEffects} from '../../../apps/sim/report/web/src/charts/all.js';
import {needed, neededFor, setsOf} from '../../../apps/sim/report/web/src/maths/effects.js';
import {k_light} from '../../../apps/sim/report/web/src/look.js';
import {readStudy} from '../../../apps/sim/report/web/src/study.js';
import {effects as sample} from './sample/effects.mjs';

const look = {...k_light, methods: [], numbers: [], still: false};
const problemWith = (effects) => readStudy(JSON.stringify({format: 1, problems: [{name: 'top', effects}]})).problems[0];
const made = (id, effects) => { const problem = problemWith(effects); return chartsOf(problem).find((chart) => chart.id === id).make(problem, [], look); };
const names = (set) => set.effects.join();
const spotted = (picture) => picture.spots.map((spot) => ({...Object.fromEntries(spot.detail()), item: picture.option.series[spot.series].data[spot.index]}));

test('an accuracy needs the set with the fewest operations, then the fewest effects', () => {
  assert.deepEqual(needed(sample()).map(({from, set}) => [from, names(set)]), [
    [0, 'gravity,elastic,air,buoyancy'], [7.2e-4, 'gravity,rigid,air,buoyancy'], [3e-3, 'gravity,elastic,air'], [0.038, 'gravity,rigid'], [1.1, 'rigid'],
  ]);
  for (const change of [1e-9, 7.2e-4, 2e-3, 3.5e-3, 0.5, 3]) {
    const within = setsOf(sample()).filter((set) => set.change <= change);
    const best = within.sort((a, b) => a.operations - b.operations || a.effects.length - b.effects.length)[0];
    assert.equal(names(neededFor(sample(), change)), names(best), String(change));
  }
});

test('of two sets with as many operations an accuracy needs the one with fewer effects', () => {
  const given = sample();
  given.each = given.each.slice(0, 2);
  assert.equal(names(neededFor(given, 5e-3)), 'gravity,rigid,air');
});

test('each set is there once, the one without a motion in the table alone', () => {
  assert.equal(setsOf(sample()).length, 8);
  const picture = made('effects', sample());
  assert.equal(picture.table.rows.length, 6);
  assert.equal(picture.spots.length, 5);
  const without = picture.table.rows.find(({what}) => what === 'without air');
  assert.match(without.why, /too small/);
  assert.match(picture.note, /1 row of the table has no motion/);
});

test('every spot stands on an item that refers to it, with what the set costs and changes', () => {
  for (const id of ['effects', 'effect-ladder']) {
    const picture = made(id, sample());
    picture.spots.forEach((spot, i) => assert.equal(picture.option.series[spot.series].data[spot.index].ref, i, id));
    assert.ok(!/NaN|undefined|null|Infinity/.test(picture.takeaway + picture.note), picture.takeaway);
    for (const spot of spotted(picture)) for (const key of ['set', 'effects', 'changes the motion by', 'operations', 'call of the rates', 'run', 'beside all']) assert.ok(spot[key] && spot[key] !== '–', `${id} ${key}`);
  }
  assert.equal(spotted(made('effects', sample())).find(({set}) => set === 'without buoyancy')['without outputs'], 'lift');
});

test('rungs stand where their change and their time say, and the line joins them in their order', () => {
  const picture = made('effect-ladder', sample());
  const line = picture.option.series.find(({type, name}) => type === 'line' && name === 'left out in turn').data;
  const ladder = sample().ladder;
  assert.equal(line.length, ladder.length);
  ladder.slice(1).forEach(({change, run_seconds}, i) => assert.deepEqual(line[i + 1], [Math.log10(change), Math.log10(run_seconds)]));
  assert.equal(line[0][0], picture.option.xAxis.min, 'all effects have no error: at the end');
  assert.equal(picture.spots.length, 8);
});

test('the ladder says which errors each set is needed for, and what the one that was asked for needs', () => {
  const picture = made('effect-ladder', sample());
  const said = Object.fromEntries(picture.table.rows.map(({names, needed}) => [names, needed]));
  assert.deepEqual(said, {
    'gravity, elastic, air, buoyancy': 'below 7.2e-4', 'gravity, rigid, air, buoyancy': '7.2e-4 to 3e-3', 'gravity, rigid, air': '', 'gravity, rigid': '0.038 to 1.1', rigid: 'from 1.1 on',
    'gravity, elastic, air': '3e-3 to 0.038',
  });
  assert.match(picture.takeaway, /1e-3 needs gravity, rigid, air, buoyancy: 9 of 46 operations, and 0.072 of the time/);
  const ring = picture.option.series.find(({name}) => name === 'needed');
  assert.deepEqual(ring.data, [[Math.log10(7.2e-4), Math.log10(165e-6)]]);
  const all = sample();
  all.need.change = 1e-5;
  assert.match(made('effect-ladder', all).takeaway, /needs all effects: 46 operations/);
});

test('what the run itself is off by is drawn where it is on the axis', () => {
  const noise = (good_to) => made('effect-ladder', {...sample(), good_to}).option.series.find(({name}) => name === 'error of the run itself');
  assert.equal(noise(1e-3).markLine.data[0].xAxis, -3);
  assert.equal(noise(1e-12), undefined);
  assert.match(made('effect-ladder', {...sample(), good_to: 1e-12}).note, /good to 1e-12/);
});

test('where nothing was measured a sentence says why', () => {
  for (const id of ['effects', 'effect-ladder']) assert.match(made(id, {why: 'it takes more than 61 s'}), /what effects cost and change: it takes more than 61 s\.$/);
  assert.match(made('effect-ladder', {all: sample().all, each: [], ladder: []}), /one set of effects alone/);
});

test('a study without runs shows effects alone, and one without effects none', () => {
  assert.deepEqual(chartsOf(problemWith(sample())).map(({id}) => id), ['effects', 'effect-ladder']);
  assert.equal(isOfEffects(problemWith(sample())), true);
  const other = problemWith(undefined);
  assert.equal(isOfEffects(other), false);
  assert.equal(chartsOf(other).some(({id}) => id.startsWith('effect')), false);
  // With a reason why there is no run, that is what the page is about.
  assert.ok(chartsOf({...problemWith(sample()), why: 'it sticks'}).some(({id}) => id === 'error-time'));
});
