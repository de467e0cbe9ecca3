// What effects cost and change, as gauss-sim writes it: a choice of one among several, a set without a motion, and one that an error needs though
// it is no rung.

const set = (what, effects, operations, ns, run_seconds, change, output) => ({what, effects, operations, ns, run_seconds, calls: 1200, change, ...(output ? {output} : {})});

export const effects = () => ({
  scene: 'lagrange_top', duration: 5, method: 'prince87', engine: 'compiled', good_to: 3e-8,
  about: {gravity: 'weight', rigid: 'a rod that keeps its length', elastic: 'a rod that bends', air: 'drag <of> air & "wind"', buoyancy: 'weight of the air', magnus: 'force across the spin'},
  all: set(undefined, ['gravity', 'elastic', 'air', 'buoyancy'], 46, 18.8, 2.29e-3, 0),
  none: set(undefined, ['elastic'], 11, 3.34, 14.6e-6, 1.2, 'nutation'),
  shared_operations: -6,
  each: [
    set('without gravity (and buoyancy)', ['elastic', 'air'], 31, 16.1, 246e-6, 1, 'nutation'),
    set('rigid instead of elastic', ['gravity', 'rigid', 'air', 'buoyancy'], 9, 9.53, 165e-6, 7.2e-4, 'nutation'),
    {what: 'without air', effects: ['gravity', 'elastic', 'buoyancy'], why: 'the step is too small at t = 0.2 s'},
    {...set('without buoyancy', ['gravity', 'elastic', 'air'], 8, 18.4, 2.27e-3, 3e-3, 'nutation'), lacks: ['lift']},
  ],
  ladder: [
    set('all', ['gravity', 'elastic', 'air', 'buoyancy'], 46, 18.8, 2.29e-3, 0),
    set('rigid instead of elastic', ['gravity', 'rigid', 'air', 'buoyancy'], 9, 9.53, 165e-6, 7.2e-4, 'nutation'),
    set('without buoyancy', ['gravity', 'rigid', 'air'], 9, 9.75, 171e-6, 4.8e-3, 'nutation'),
    set('without air', ['gravity', 'rigid'], 2, 9.33, 23.2e-6, 0.038, 'nutation'),
    set('without gravity', ['rigid'], 0, 2.22, 14.9e-6, 1.1, 'nutation'),
  ],
  need: {change: 1e-3, chosen: set(undefined, ['gravity', 'rigid', 'air', 'buoyancy'], 9, 9.53, 165e-6, 7.2e-4, 'nutation')},
});
