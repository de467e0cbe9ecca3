// A study as gauss-sim writes them, always the same: six problems, with failures, nulls, redundant formulations, and no motion
// without a meaning. `node sample/study.mjs FILE` writes it.

import {writeFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {effects} from './effects.mjs';
import {motions} from './motions.mjs';
import {random} from './random.mjs';
import {drifts, runs} from './runs.mjs';

const minimal = {name: 'minimal', cost: 95, miss: 1, projections: ['none'], redundant: false};
const redundant = {name: 'redundant', cost: 210, miss: 1.6, projections: ['position', 'position and energy'], redundant: true};
const quaternion = {name: 'quaternion', cost: 150, miss: 0.8, projections: ['position'], redundant: true};

const k_problems = [
  {name: 'double_pendulum', about: 'Two bobs on rods, far from rest: close motions part, and errors grow.', duration: 10, fast: 0.5, growth: 90, formulations: [minimal, redundant],
    outputs: [{name: 'theta1', unit: 'rad', range: 3.1}, {name: 'theta2', unit: 'rad', range: 7.4}], reference: {kind: 'float128', methods: ['taylor order 30, step x 1', 'taylor order 26, step x 0.7'], agreement: 1e-27}},
  {name: 'sphere_in_cylinder', about: 'The ball of the paper, which rolls inside an upright cylinder and does not fall.', duration: 8, fast: 0.9, growth: 3, formulations: [minimal, quaternion],
    outputs: [{name: 'z', unit: 'm', range: 0.9}], reference: {kind: 'closed form', methods: ['z = A cos(k t)'], agreement: null}},
  {name: 'slider_crank', about: 'A loop that is closed by a constraint.', duration: 6, fast: 0.4, growth: 8, formulations: [minimal, redundant],
    outputs: [{name: 'x', unit: 'm', range: 0.8}], reference: {kind: 'float128', methods: ['taylor order 30, step x 1', 'taylor order 26, step x 0.7'], agreement: 4e-28}},
  {name: 'four_bar', about: 'Four bars with a crank that turns round.', duration: 6, fast: 0.4, growth: 12, formulations: [redundant],
    outputs: [{name: 'phi', unit: 'rad', range: 1.9}], reference: {kind: 'float128', methods: ['taylor order 30, step x 1'], agreement: 2e-27}},
  {name: 'rolling_disc', about: 'A disc that rolls on a plane without slipping.', duration: 10, fast: 0.7, growth: 5, formulations: [minimal, quaternion],
    outputs: [{name: 'x', unit: 'm', range: 2.2}, {name: 'lean', unit: 'rad', range: 0.4}], reference: {kind: 'float128', methods: ['taylor order 30, step x 1'], agreement: 1e-27}},
  {name: 'lagrange_top', about: 'A heavy top on a fixed point; no reactions are asked for.', duration: 5, fast: 0.3, growth: 6, formulations: [quaternion],
    outputs: [{name: 'nutation', unit: 'rad', range: 0.6}], reference: {kind: 'float128', methods: ['taylor order 30, step x 1'], agreement: 6e-28}},
];

const k_number_costs = {double: 1, 'long double': 1.1, float128: 1.7};

function builds(problem, rand) {
  return problem.formulations.flatMap(({name, cost}) => Object.entries(k_number_costs).map(([number, factor]) => ({
    formulation: name, number, generate_s: Number((0.02 + 0.0002 * cost + 0.01 * rand()).toPrecision(3)), compile_s: Number(((0.7 + 0.004 * cost) * factor * (0.95 + 0.1 * rand())).toPrecision(3)),
    operations: Math.round(cost * 0.73),
  })));
}

function lanes(rand) {
  const base = 9000 + Math.round(4000 * rand());
  return [[1, 1], [4, 1], [8, 1], [4, 2], [8, 2]].flatMap(([width, threads]) => ['double', 'float'].map((number) => {
    const ratio = Number((width ** 0.88 * threads ** 0.95 * (number === 'float' && width === 8 ? 1.5 : 1)).toPrecision(3));
    return {number, lanes: width, threads, trajectories: 4096, trajectories_per_s: Math.round(base * ratio), ratio};
  }));
}

function problemOf(given, i) {
  const rand = random(1000 + i);
  const {name, about, duration, outputs, reference} = given;
  const points = runs(given, rand);
  return {name, about, file: `${name}.yaml`, duration, samples: 501, outputs, reference, builds: builds(given, rand), points, drifts: drifts(points, duration, rand), lanes: i < 4 ? lanes(rand) : [], motion: motions[name](), ...(name === 'lagrange_top' ? {effects: effects()} : {})};
}

export const study = () => ({
  format: 1, tool: 'gauss-sim 0.1.0', machine: {processor: 'a sample, on no machine', cores: 2, system: 'Debian 12', compiler: 'g++ 12.2.0', flags: '-std=c++17 -O3'}, budget_s: 60,
  problems: k_problems.map(problemOf),
});

if (process.argv[1] === fileURLToPath(import.meta.url)) writeFileSync(process.argv[2], `${JSON.stringify(study())}\n`);
