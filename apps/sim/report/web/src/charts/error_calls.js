// Error against calls: what does not depend on the machine.

import {plain} from '../format.js';
import {calls} from '../maths/points.js';
import {workPrecision} from './work_precision.js';

/** @type {import('../types.js').Chart} */
export const errorCalls = {
  id: 'error-calls', short: 'Error → calls', title: 'Error → calls: the same on any machine',
  about: 'Calls of the right-hand side, or of what a method asks of the model instead of it. A call of power series is one whole series. They repeat to the last one, where times do not.',
  make: (problem, points, look) => workPrecision(points, look, {
    title: `${problem.name}: error and calls`, of: calls, axis: 'calls of the model', write: (value) => `${plain(value)} calls`, fewest: 'Fewest calls',
    more: 'calls', caption: 'Runs: the front first, then by error.',
  }),
};
