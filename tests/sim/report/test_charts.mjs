// What charts say of a study, without a browser: each spot is a run, nothing is drawn that is not there, and nothing is left out without a word.

import assert from 'node:assert/strict';
import test from 'node:test';
import {linearAxis, logAxis, shortSeconds} from '../../../apps/sim/report/web/src/charts/axes.js';
import {chartsOf} from '../../../apps/sim/report/web/src/charts/all.js';
import {errorTime} from '../../../apps/sim/report/web/src/charts/error_time.js';
import {apartBy, endLabels} from '../../../apps/sim/report/web/src/charts/end_labels.js';
import {freePlace} from '../../../apps/sim/report/web/src/charts/free_label.js';
import {summaryOf} from '../../../apps/sim/report/web/src/charts/summary.js';
import {tally} from '../../../apps/sim/report/web/src/maths/points.js';
import {k_light} from '../../../apps/sim/report/web/src/look.js';
import {readStudy} from '../../../apps/sim/report/web/src/study.js';
import {random} from './sample/random.mjs';
import {study} from './sample/study.mjs';

const {problems} = readStudy(JSON.stringify(study()));
const look = {...k_light, methods: ['prince8', 'dopri5', 'taylor', 'adams', 'bdf', 'gauss_legendre'], numbers: ['double', 'long double', 'float128'], still: false};
const made = (problem, id, points = problem.points) => chartsOf(problem).find((chart) => chart.id === id).make(problem, points, look);

const itemOf = (picture, {series, index}) => picture.option.series[series].data[index];

test('every spot stands on an item that refers to it', () => {
  for (const problem of problems) {
    for (const chart of [...chartsOf(problem), summaryOf(problems)]) {
      const picture = chart.make(problem, problem.points, look);
      if (typeof picture === 'string') continue;
      picture.spots.forEach((spot, i) => assert.equal(itemOf(picture, spot).ref, i, `${problem.name} ${chart.id}`));
      assert.ok(picture.takeaway.length > 10 && !/NaN|undefined|null|Infinity/.test(picture.takeaway + (picture.note ?? '')), picture.takeaway);
      assert.ok(picture.table.rows.length > 0);
    }
  }
});

test('each run is drawn once in error against time, where its numbers say', () => {
  for (const problem of problems) {
    const picture = made(problem, 'error-time');
    assert.equal(picture.spots.length, problem.points.length);
    const places = new Set(picture.spots.map((spot) => itemOf(picture, spot).value.join()));
    for (const point of problem.points.filter(({status}) => status === 'ok')) assert.ok(places.has([Math.log10(point.error), Math.log10(point.time_s)].join()), String(point.id));
    assert.deepEqual(picture.table.rows.map(({id}) => id).sort((a, b) => a - b), problem.points.map(({id}) => id));
  }
});

test('all settings and results of a run are in its hint', () => {
  const [problem] = problems;
  const picture = made(problem, 'error-time');
  const detail = picture.spots.map((spot) => Object.fromEntries(spot.detail())).find((found) => found.default);
  const usual = problem.points.find((point) => point.is_default);
  assert.equal(detail.method, usual.method);
  assert.equal(detail['number type'], usual.number);
  for (const key of ['library', 'formulation', 'code', 'projection', 'engine', 'tolerance', 'status', 'error', 'worst output', 'time', 'calls', 'steps', 'rejected steps', 'drift of energy', 'drift of constraints']) assert.ok(key in detail, key);
});

test('a front that the study sees otherwise is mentioned', () => {
  const problem = structuredClone(problems[0]);
  assert.doesNotMatch(errorTime.make(problem, problem.points, look).note, /another front/);
  problem.points.find(({pareto}) => pareto).pareto = false;
  assert.match(errorTime.make(problem, problem.points, look).note, /another front its own: 1 runs/);
});

test('an error of 0 is drawn at the end of the axis, and the note says so', () => {
  const problem = structuredClone(problems[1]);
  problem.points[0].error = 0;
  const picture = made(problem, 'error-time');
  assert.match(picture.note, /error of 0 is drawn at the end/);
  const low = picture.option.xAxis.min;
  assert.ok(picture.spots.some((spot) => itemOf(picture, spot).value[0] === low && spot.detail().some(([label, value]) => label === 'error' && value === '0')));
});

const labelsOf = ({axisLabel}) => axisLabel.customValues.map(axisLabel.formatter);
const isRound = (value) => [1, 2, 5].some((digit) => Math.abs(Math.log10(value / digit) - Math.round(Math.log10(value / digit))) < 1e-9);

test('a logarithmic axis holds its numbers, with three to ten round labels of one notation, however narrow or wide they are', () => {
  const rand = random(11);
  for (let round = 0; round < 2000; ++round) {
    const low = 10 ** (-40 + 50 * rand());
    const high = low * 10 ** (rand() < 0.5 ? 2.5 * rand() : 45 * rand());
    const {axis, at} = logAxis(look, '', [low, high]);
    const labels = labelsOf(axis);
    assert.ok(labels.length >= 3 && labels.length <= 10, `${low} ${high}: ${labels}`);
    assert.ok(axis.min <= at(low) + 1e-8 && at(high) <= axis.max + 1e-8, `${low} ${high}: ${labels}`);
    assert.ok(axis.axisLabel.customValues.every((value) => isRound(10 ** (value - Math.floor(value)))));
    assert.equal(new Set(labels.map((label) => label.includes('e'))).size, 1, String(labels));
    for (const [i, label] of labels.entries()) assert.ok(Math.abs(Math.log10(Number(label.replace(/\u202f/g, ''))) - axis.axisLabel.customValues[i]) < 1e-9, label);
  }
});

test('numbers within a decade or two have labels at 1, 2 and 5', () => {
  assert.deepEqual(labelsOf(logAxis(look, '', [0.0031, 0.0083], {label: shortSeconds}).axis), ['2 ms', '5 ms', '10 ms']);
  assert.deepEqual(labelsOf(logAxis(look, '', [3, 3]).axis), ['1', '2', '5']);
  assert.deepEqual(labelsOf(logAxis(look, '', [12, 700]).axis), ['10', '20', '50', '100', '200', '500', '1000']);
  assert.deepEqual(labelsOf(logAxis(look, '', [0, 2e-7, 1e-6]).axis), ['0', '2e-7', '5e-7', '1e-6']);
});

test('linear axes have round labels', () => {
  const labels = (...range) => labelsOf(linearAxis(look, '', ...range));
  assert.deepEqual(labels({low: 0, high: 7.3}), ['0', '1', '2', '3', '4', '5', '6', '7', '8']);
  assert.deepEqual(labels({low: 0, high: 7.3, ends: true}), ['0', '1', '2', '3', '4', '5', '6', '7']);
  assert.deepEqual(labels({low: 0, high: 150}), ['0', '20', '40', '60', '80', '100', '120', '140', '160']);
  assert.deepEqual(labels({low: 1, high: 2.3, digits: [1, 5]}), ['1', '1.5', '2', '2.5']);
  assert.deepEqual(labels({low: 1, high: 17, digits: [1, 5]}), ['1', '5', '10', '15', '20']);
  for (const problem of problems) {
    const {xAxis} = made(problem, 'digit-cost').option;
    const [first, ...others] = labelsOf(xAxis).map((label) => Number(label.replace('× ', '')));
    assert.equal(first, 1);
    assert.ok([0.1, 0.5, 1, 5].some((step) => others.every((value) => Math.abs(value / step - Math.round(value / step)) < 1e-9) && others.length <= 9), String(others));
  }
});

test('tiny ratios of error and tolerance keep two digits', () => {
  const problem = structuredClone(problems[0]);
  problem.points.find((point) => point.tolerance === 1e-3 && point.status === 'ok').error = 1.23e-9;
  const {columns, rows} = made(problem, 'tolerance').table;
  const {format} = columns.find(({key}) => key === 'ratio');
  const written = rows.map(({ratio}) => format(ratio)).filter((text) => text !== '–');
  assert.ok(written.includes('1.2e-6'));
  assert.ok(written.every((text) => /^\d\.\de-?\d+$/.test(text)), String(written));
});

test('a label finds the nearest place where no point is, and none where points are everywhere', () => {
  const area = {left: 0, right: 600, top: 0, bottom: 300};
  assert.deepEqual(freePlace('default', [300, 150], [], area).map(Math.round), [300, 129], 'above, where nothing is');
  const rand = random(3);
  for (let round = 0; round < 300; ++round) {
    const points = Array.from({length: 60}, () => [600 * rand(), 300 * rand()]);
    const place = freePlace('default', points[0], points, area);
    if (!place) continue;
    for (const [x, y] of points) assert.ok(Math.abs(x - place[0]) > 26 || Math.abs(y - place[1]) > 11, `${place} ${x} ${y}`);
    assert.ok(place[0] > 24 && place[0] < 576 && place[1] >= 8 && place[1] <= 292);
  }
  const everywhere = Array.from({length: 3000}, (_, i) => [(i % 60) * 10, Math.floor(i / 60) * 6]);
  assert.equal(freePlace('default', [300, 150], everywhere, area), null);
});

test('runs with fixed steps are left out of tolerances, and counted', () => {
  const picture = made(problems[0], 'tolerance');
  const fixed = problems[0].points.filter(({tolerance}) => tolerance === null).length;
  const runs = problems[0].points.filter(({tolerance, status}) => tolerance === null && status !== 'refused').length;
  assert.match(picture.note, new RegExp(`^${runs} runs with steps of one length`));
  assert.equal(picture.spots.length, problems[0].points.length - fixed);
});

test('all counts of runs are those of runs that were begun', () => {
  const [problem] = problems;
  const of = (status) => problem.points.filter((point) => point.status === status).length;
  const [arrived, stopped, refused] = ['ok', 'failed', 'refused'].map(of);
  assert.ok(arrived > 100 && stopped > 3 && refused > 3);
  const {runs, unmade, ...rest} = tally(problem.points);
  assert.deepEqual([runs, rest.arrived, rest.stopped, unmade], [arrived + stopped, arrived, stopped, refused]);
  for (const id of ['error-time', 'error-calls']) {
    const {takeaway, table} = made(problem, id);
    assert.match(takeaway, new RegExp(`${stopped} of ${runs} runs have no result: ${stopped} stopped on the way\\. ${refused} settings beside them were not run`));
    assert.match(table.caption, new RegExp(`The last ${refused} rows are settings that were not run`));
    assert.ok(table.rows.slice(-refused).every(({status}) => status === 'refused'));
  }
  const {takeaway} = summaryOf(problems).make(problem, [], look);
  const all = problems.flatMap(({points}) => points);
  assert.match(takeaway.replace(/\u202f/g, ''), new RegExp(`${all.filter(({status}) => status === 'ok').length} of ${all.filter(({status}) => status !== 'refused').length} runs have a result; ${all.filter(({status}) => status === 'refused').length} more settings were not run`));
});

test('drifts follow the filters, and invariants of any name have a chart', () => {
  const problem = structuredClone(problems[0]);
  problem.drifts[0].momentum = problem.drifts[0].t.map(() => -1e-9);
  assert.ok(chartsOf(problem).some(({id}) => id === 'drift-momentum'));
  assert.equal(made(problem, 'drift-momentum').table.rows[0].most, 1e-9);
  assert.equal(made(problem, 'drift-energy').table.rows.length, 4);
  assert.equal(made(problem, 'drift-energy', problem.points.filter(({method}) => method === 'taylor')).table.rows.length, 1);
});

/** Twelve runs of one method, whose drift passes through 0 and is nothing at all now and then. */
function drifting() {
  const [problem] = problems;
  const some = problem.points.filter((point) => point.status === 'ok' && point.number === 'double').slice(0, 12).map((point, i) => ({...point, method: 'taylor', is_default: i === 7}));
  const t = Array.from({length: 121}, (_, i) => i / 12);
  const drifts = some.map(({id}, run) => ({point: id, t, energy: t.map((time, i) => i % 40 === 0 ? 0 : i % 17 === 0 ? -1e-61 : 10 ** (run / 2 - 12) * time * Math.sin(7 * time + run))}));
  return {...problem, points: some, drifts};
}
const curvesIn = (picture) => picture.option.series.filter(({type}) => type === 'line');

test('an axis of drifts ends at rounding, whatever single samples are, and says so', () => {
  const picture = made(drifting(), 'drift-energy');
  const {min, max, axisLabel} = picture.option.yAxis;
  assert.ok(min >= -18 && min <= -13 && max > -6 && max < -3, `${min} ${max}`);
  assert.equal(axisLabel.formatter(min), `≤ 1e${min}`);
  assert.match(picture.note, new RegExp(`below 1e${min} is drawn at the lower end`));
  for (const {data} of curvesIn(picture)) for (const {value} of data) assert.ok(value[1] >= min && value[1] <= max);
  const fine = drifting();
  fine.points.forEach((point) => { point.number = 'float128'; });
  fine.drifts.forEach((drift) => { drift.energy = drift.energy.map((value) => 1e-22 * value); });
  assert.ok(made(fine, 'drift-energy').option.yAxis.min < -33, 'float128 has digits that double has not');
});

test('a curve of drift is the largest one so far', () => {
  const problem = drifting();
  const picture = chartsOf(problem).find(({id}) => id === 'drift-energy').make(problem, problem.points, look, true);
  const {min} = picture.option.yAxis;
  for (const {data, name} of curvesIn(picture)) {
    const {no} = {no: picture.table.rows.findIndex((row) => row.name === name)};
    for (let i = 1; i < data.length; ++i) assert.ok(data[i].value[1] >= data[i - 1].value[1]);
    assert.equal(data[data.length - 1].value[1], Math.max(min, Math.log10(picture.table.rows[no].most)));
  }
});

test('runs of one method drift in colours of their own, few at first and all on demand', () => {
  const problem = drifting();
  const chart = chartsOf(problem).find(({id}) => id === 'drift-energy');
  const [few, all] = [false, true].map((more) => chart.make(problem, problem.points, look, more));
  assert.deepEqual([few, all].map((picture) => picture.more), [{drawn: 6, all: 12, word: 'curves'}, {drawn: 12, all: 12, word: 'curves'}]);
  assert.deepEqual([few, all].map((picture) => curvesIn(picture).length), [6, 12]);
  assert.equal(new Set(curvesIn(all).map(({lineStyle}) => lineStyle.color)).size, 12);
  assert.equal(few.table.rows.length, 12);
  assert.match(few.note, /6 of 12 curves are drawn/);
  const ranks = few.key.extra.map(({label}) => Number(label.split(':')[0]));
  const usual = 12 - 7;  // of twelve that grow, the eighth
  assert.ok(ranks.includes(1) && ranks.includes(12) && ranks.includes(usual), String(ranks));
  const colours = (picture) => Object.fromEntries(picture.key.extra.map(({label, colour}) => [label, colour]));
  for (const [label, colour] of Object.entries(colours(few))) assert.equal(colours(all)[label], colour, 'the same with more of them');
  const left = chart.make(problem, problem.points.slice(3), look, true);
  const byName = (picture) => new Map(curvesIn(picture).map(({lineStyle}) => [lineStyle.color, 1]));
  for (const colour of byName(left).keys()) assert.ok(byName(all).has(colour), 'the same under filters');
});

test('numbers at the ends of curves are a line apart, in their order, and those of one place together', () => {
  const labels = made(drifting(), 'drift-energy').option.series.at(-1).data;
  assert.ok(labels.length > 3);
  assert.deepEqual(apartBy([5, 4.9, 4.8, 1], 0.5, [0, 10]), [5, 4.5, 4, 1]);
  assert.deepEqual(apartBy([0.2, 0.1, 0.05], 0.5, [0, 10]), [1, 0.5, 0]);
  const together = endLabels(look, [{text: '1', x: 1, y: 3}, {text: '2', x: 1, y: 3}, {text: '3', x: 1, y: 1}], [0, 5], 340).data;
  assert.deepEqual(together.map(({label, value}) => [label.formatter, value[1]]), [['1, 2', 3], ['3', 1]]);
  const many = endLabels(look, ['4', '5', '6', '7'].map((text) => ({text, x: 1, y: 3})), [0, 5], 340).data;
  assert.deepEqual(many.map(({label}) => label.formatter), ['4 … 7']);
});

test('runs are named by what they do not have in common', () => {
  const {table} = made(drifting(), 'drift-energy');
  assert.match(table.caption, /All: double/);
  assert.ok(table.rows.every(({name}) => /^taylor/.test(name) && !/double/.test(name)));
  assert.equal(new Set(table.rows.map(({rank}) => rank)).size, 12);
});

test('comparisons name the fastest, and by how much', () => {
  const picture = made(problems[0], 'formulations');
  const row = picture.table.rows.find(({target, name}) => target === 1e-6 && name === 'redundant');
  const best = Math.min(...problems[0].points.filter((p) => p.status === 'ok' && p.error <= 1e-6).map((p) => p.time_s));
  const own = Math.min(...problems[0].points.filter((p) => p.status === 'ok' && p.error <= 1e-6 && p.formulation === 'redundant').map((p) => p.time_s));
  assert.equal(row.time, own);
  assert.equal(row.ratio, own / best);
});

test('where there is nothing to show, a sentence says why', () => {
  const [nothing] = readStudy('{"format": 1, "problems": [{"name": "nothing"}]}').problems;
  for (const chart of [...chartsOf(nothing), summaryOf([nothing])]) assert.match(String(chart.make(nothing, [], look)), /^[A-Z].*\.$/, chart.id);
});

test('one point of each kind, and points of nulls, are no trouble', () => {
  const bare = {id: 1, method: 'm', status: 'ok', error: 1e-3, time_s: 1};
  const nulls = {id: 2, method: 'm', status: 'failed', why: 'no', error: null, time_s: null, tolerance: 1e-3, calls: null, drift: null, number: null};
  for (const points of [[bare], [nulls], [bare, nulls], [{...bare, error: null}], [{...bare, time_s: null, tolerance: 1e-3}], [{...bare, error: 0, time_s: 0, tolerance: 1e-300}]]) {
    const problem = {...problems[0], points, drifts: [{point: 1, t: [0, null, 2], energy: [null, 1, 0]}, {point: 9, t: []}], lanes: [{number: 'double', lanes: 4, threads: 1, trajectories_per_s: null, ratio: null}], builds: [{formulation: 'a', number: 'b', generate_s: null, compile_s: 1}]};
    for (const chart of chartsOf(problem)) {
      const picture = chart.make(problem, points, look);
      if (typeof picture !== 'string') assert.doesNotMatch(picture.takeaway, /NaN|undefined|Infinity|null/, chart.id);
    }
  }
});

test('what is no study is said to be none', () => {
  for (const [text, said] of [['@STUDY@', /template/], ['{', /not JSON/], ['[]', /no study/], ['{"format": 2}', /format 1 .* says 2/], ['{}', /says none/]]) assert.match(readStudy(text), said);
});
