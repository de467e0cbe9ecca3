// Error against time.

import {seconds} from '../format.js';
import {time} from '../maths/points.js';
import {shortSeconds} from './axes.js';
import {workPrecision} from './work_precision.js';

/** @type {import('../types.js').Chart} */
export const errorTime = {
  id: 'error-time', short: 'Error → time', title: 'Error → time: what a more exact result costs',
  about: 'Each symbol is one run with one setting. Down is faster, right is more exact.',
  make: (problem, points, look) => workPrecision(points, look, {
    title: `${problem.name}: error and time`, of: time, axis: 'time of a run', label: shortSeconds, write: seconds, fewest: 'Fastest', more: 'time',
    caption: 'Runs: the front first, then by error.',
  }),
};
