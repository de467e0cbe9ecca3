// Runs as a study has them, from laws of how methods behave: steps go with the tolerance to the power -1/(order + 1), errors with the
// tolerance, until rounding ends it; number types multiply times. No number here was measured.

const k_methods = [
  {name: 'prince8', library: 'Boost.Odeint', order: 8, stages: 13, steps: 9, miss: 2},
  {name: 'dopri5', library: 'Boost.Odeint', order: 5, stages: 6, steps: 14, miss: 4},
  {name: 'taylor', library: 'gauss', order: 20, stages: 9, steps: 6, miss: 0.6},
  {name: 'adams', library: 'SUNDIALS', order: 7, stages: 1.4, steps: 60, miss: 60},
  {name: 'bdf', library: 'SUNDIALS', order: 4, stages: 1.6, steps: 80, miss: 200},
  {name: 'gauss_legendre', library: 'gauss', order: 6, stages: 20, fixed: true, miss: 1},
];

const k_numbers = [
  {name: 'double', epsilon: 1.1e-16, slower: 1}, {name: 'long double', epsilon: 5.4e-20, slower: 3.4}, {name: 'float128', epsilon: 9.6e-35, slower: 42},
];

const rounded = (value, digits = 4) => Number(value.toPrecision(digits));

/** Four digits of a random size around 1. */
const near = (rand, spread = 0.5) => 10 ** ((rand() - 0.5) * spread);

function* grid(problem) {
  for (const method of k_methods) {
    for (const number of k_numbers) {
      if (method.library === 'SUNDIALS' && number.name !== 'double') continue;
      for (const formulation of problem.formulations) {
        for (const projection of formulation.projections) yield {method, number, formulation, projection};
      }
    }
  }
}

const exponents = ({name}, fixed) => Array.from({length: name === 'double' || fixed ? 10 : name === 'long double' ? 12 : 16}, (_, i) => name === 'float128' && !fixed ? 3 + i * 1.5 : 3 + i);

/** @returns {object} one run */
function run(cell, digits, problem, rand) {
  const {method, number, formulation, projection} = cell;
  const tolerance = Number(`1e-${Math.round(digits)}`);
  const step = rounded(problem.fast / 4 / 2 ** (digits - 3), 3);
  const steps = method.fixed ? Math.round(problem.duration / step) : Math.round(method.steps * problem.duration / problem.fast * 10 ** (digits / (method.order + 1)));
  const calls = Math.round(steps * method.stages * near(rand, 0.1));
  const wish = method.fixed ? 0.02 * (step / problem.fast) ** method.order : tolerance * method.miss;
  const floor = number.epsilon * problem.growth * Math.sqrt(steps);
  const error = rounded(wish * formulation.miss * near(rand) + floor * near(rand));
  const time = calls * formulation.cost * (projection === 'none' ? 1 : 1.25) * 1e-9 * number.slower * near(rand, 0.08);
  return {
    method: method.name, library: method.library, formulation: formulation.name, code: 'shared', number: number.name, projection, engine: 'compiled',
    tolerance: method.fixed ? null : tolerance, step: method.fixed ? step : null, status: 'ok', why: '', error, worst_output: problem.outputs[0].name,
    time_s: rounded(time), time_min_s: rounded(time * 0.96), time_max_s: rounded(time * 1.09),
    repeats: 5, calls, steps, rejected: method.fixed ? 0 : Math.round(steps * 0.04 * rand()),
    drift: {energy: rounded(error * 0.3 * near(rand)), constraints: formulation.redundant ? rounded(projection === 'none' ? error : 3 * number.epsilon * near(rand)) : 0},
    pareto: false, is_default: false,
  };
}

const k_lost = {error: null, worst_output: null, drift: null};

/** Some runs fail, as some do. */
function withFailure(point, digits, rand) {
  if (point.time_s > 12) return {...point, ...k_lost, status: 'refused', why: `would take ${rounded(point.time_s, 2)} s, and five runs of it more than the budget`, time_s: null, time_min_s: null, time_max_s: null, repeats: 0, calls: null, steps: null, rejected: null};
  if (point.method === 'bdf' && digits > 10) return {...point, ...k_lost, status: 'refused', why: 'bdf takes tolerances down to 1e-10 only', time_s: null, time_min_s: null, time_max_s: null, repeats: 0, calls: null, steps: null, rejected: null};
  if (point.number === 'double' && point.tolerance === 1e-12 && point.formulation === 'redundant') return {...point, ...k_lost, status: 'failed', why: 'constraints_lost at t = 3.1 s: projection moved the state by 2000 tolerances'};
  if (rand() < 0.008) return {...point, ...k_lost, status: 'failed', why: `steps below rounding at t = ${rounded(9 * rand(), 3)} s`};
  return point;
}

/** Nobody has both a smaller error and a smaller time; slow, and plain enough to be right. */
export function markFront(points) {
  const ok = points.filter((point) => point.status === 'ok' && Number.isFinite(point.error) && Number.isFinite(point.time_s));
  for (const point of ok) point.pareto = !ok.some((other) => other.error <= point.error && other.time_s <= point.time_s && (other.error < point.error || other.time_s < point.time_s));
  return points;
}

export function runs(problem, rand) {
  const points = [];
  for (const cell of grid(problem)) {
    for (const digits of exponents(cell.number, cell.method.fixed)) points.push(withFailure(run(cell, digits, problem, rand), digits, rand));
  }
  const usual = points.find((point) => point.method === 'prince8' && point.number === 'double' && point.tolerance === 1e-9 && point.status === 'ok');
  if (usual) usual.is_default = true;
  return markFront(points.map((point, i) => ({id: i + 1, ...point})));
}

/** Drift over time of a few runs: energy grows with the root of time, or steadily. */
export function drifts(points, duration, rand) {
  const chosen = ['prince8', 'taylor', 'gauss_legendre', 'adams'].flatMap((method) => points.find((point) => point.method === method && point.status === 'ok' && point.number === 'double' && (point.tolerance === null || point.tolerance === 1e-9)) ?? []);
  const t = Array.from({length: 101}, (_, i) => rounded(duration * i / 100, 6));
  return chosen.map((point) => ({
    point: point.id, t,
    energy: t.map((time) => time === 0 ? 0 : rounded(point.drift.energy * (point.method === 'gauss_legendre' ? 1 : time / duration) * near(rand, 0.4), 3)),
    constraints: t.map((time) => time === 0 ? 0 : rounded(point.drift.constraints * near(rand, 0.4), 3)),
  }));
}
