// Error against time.

import {plain, seconds} from '../format.js';
import {front, time} from '../maths/points.js';
import {shortSeconds} from './axes.js';
import {workPrecision} from './work_precision.js';

/** @type {import('../types.js').Chart} */
export const errorTime = {
  id: 'error-time', short: 'Error → time', title: 'Error → time: what a more exact result costs',
  about: 'Each symbol is one run with one setting. Down is faster, right is more exact.',
  make: (problem, points, look) => checked(problem, points, workPrecision(points, look, {
    title: `${problem.name}: error and time`, of: time, axis: 'time of a run', label: shortSeconds, write: seconds, fewest: 'Fastest', more: 'time',
    caption: 'Runs: the front first, then by error.',
  })),
};

/** The study names its front, too; without filters the two have to be the same. @param {import('../types.js').FullProblem} problem @param {import('../types.js').Point[]} points @param {import('../types.js').Picture | string} picture */
function checked(problem, points, picture) {
  if (typeof picture === 'string' || points.length !== problem.points.length) return picture;
  const found = new Set(front(points));
  const other = points.filter((point) => typeof point.pareto === 'boolean' && point.pareto !== found.has(point)).length;
  if (other > 0) picture.note += ` The study calls another front its own: ${plain(other)} runs are on one of the two and not on the other. What is drawn was found from the errors and times that are listed here.`;
  return picture;
}
