// The charts of a problem, in the order of the page.

import {builds} from './builds.js';
import {digitCost} from './digit_cost.js';
import {driftOf, drifting} from './drift.js';
import {errorCalls} from './error_calls.js';
import {errorTime} from './error_time.js';
import {formulations} from './formulations.js';
import {lanes} from './lanes.js';
import {numbers} from './numbers.js';
import {projections} from './projections.js';
import {tolerance} from './tolerance.js';

/** @param {import('../types.js').FullProblem} problem @returns {import('../types.js').Chart[]} */
export const chartsOf = (problem) => [
  errorTime, errorCalls, tolerance, digitCost, ...drifting(problem).map(driftOf), formulations, numbers, projections, lanes, builds,
];
