// Projections onto the constraints and the energy.

import {askedFor, compared} from './asked_for.js';

/** @type {import('../types.js').Chart} */
export const projections = {
  id: 'projections', short: 'Projections', title: 'Projections: what keeping constraints costs, and what it brings',
  about: 'For each error, the fastest run of each kind of projection after a step, all else alike: by methods that were tried with each of them.',
  make: (problem, points, look) => askedFor(points, look, {
    key: 'projection', word: 'projection', title: `${problem.name}: projections`, sentence: compared,
  }),
};
