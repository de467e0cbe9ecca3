// The charts of a problem, in the order of the page.

import {builds} from './builds.js';
import {digitCost} from './digit_cost.js';
import {driftOf, drifting} from './drift.js';
import {effectLadder} from './effect_ladder.js';
import {effects} from './effects.js';
import {errorCalls} from './error_calls.js';
import {errorTime} from './error_time.js';
import {formulations} from './formulations.js';
import {lanes} from './lanes.js';
import {numbers} from './numbers.js';
import {projections} from './projections.js';
import {tolerance} from './tolerance.js';

/** Nobody has tried to make it more exact: `gauss-sim effects` has measured it. @param {import('../types.js').FullProblem} problem */
export const isOfEffects = ({effects: found, points, why}) => Boolean(found) && points.length === 0 && !why;

/** @param {import('../types.js').FullProblem} problem @returns {import('../types.js').Chart[]} */
export const chartsOf = (problem) => [...(isOfEffects(problem) ? [] : chartsOfRuns(problem)), ...(problem.effects ? [effects, effectLadder] : [])];

/** @param {import('../types.js').FullProblem} problem @returns {import('../types.js').Chart[]} */
const chartsOfRuns = (problem) => [
  errorTime, errorCalls, tolerance, digitCost, ...drifting(problem).map(driftOf), formulations, numbers, projections, lanes, builds,
];
