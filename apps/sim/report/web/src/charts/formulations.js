// Formulations of the same mechanism: which coordinates describe it, and how its equations are derived.

import {askedFor, compared} from './asked_for.js';

/** @type {import('../types.js').Chart} */
export const formulations = {
  id: 'formulations', short: 'Formulations', title: 'Formulations: the same motion in other equations',
  about: 'For each error, the fastest run of each formulation, by a method, in code, a number type and with a projection that all of them were tried with.',
  make: (problem, points, look) => askedFor(points, look, {
    key: 'formulation', word: 'formulation', title: `${problem.name}: formulations`, sentence: compared,
  }),
};
