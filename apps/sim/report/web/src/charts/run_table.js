// The table of runs that belongs to charts of single runs. What is alike in all of them is left out, and said in the caption.

import {column, count, counted, seconds, small} from '../format.js';
import {k_settings, made, settingOf} from '../maths/points.js';
import {statusOf} from './detail.js';

/** @typedef {import('../types.js').Point} Point */
/** @typedef {import('../types.js').Column} Column */

/** @type {Column[]} */
const k_results = [
  {key: 'tolerance', title: 'tolerance', format: (v) => small(v), numeric: true},
  {key: 'step', title: 'step (s)', format: (v) => small(v), numeric: true},
  {key: 'error', title: 'error', format: column, numeric: true},
  {key: 'time_s', title: 'time', format: seconds, numeric: true},
  {key: 'calls', title: 'calls', format: count, numeric: true},
  {key: 'steps', title: 'steps', format: count, numeric: true},
  {key: 'rejected', title: 'rejected', format: count, numeric: true},
];

/** @param {Point[]} points @param {Point[]} front @param {string} caption @param {Column[]} [more] columns before those of results */
export function runTable(points, front, caption, more = []) {
  const [method, ...differing] = k_settings.filter(([key]) => new Set(points.map((point) => settingOf(point, key))).size > 1 || key === 'method');
  const named = differing.map(([key, title]) => ({key, title}));  // the number type first: it says what an error can be
  const alike = k_settings.filter((setting) => setting !== method && !differing.includes(setting) && points.some((point) => point[setting[0]]));
  const used = k_results.filter(({key}) => points.some((point) => /** @type {any} */ (point)[key] !== null && /** @type {any} */ (point)[key] !== undefined));
  const onFront = new Set(front.map(({id}) => id));
  const marks = (/** @type {Point} */ point) => [onFront.has(point.id) && 'front', point.is_default && 'default'].filter(Boolean).join(', ');
  const failures = points.some((point) => point.status !== 'ok');
  const unmade = points.length - made(points).length;
  const words = [
    caption, unmade > 0 && `The last ${counted(unmade, 'row')} ${unmade === 1 ? 'is a setting that was' : 'are settings that were'} not run.`,
    alike.length > 0 && `All: ${alike.map(([key, label]) => `${label} ${settingOf(points[0], key)}`).join(', ')}.`,
  ];
  return {
    caption: words.filter(Boolean).join(' '),
    columns: [
      {key: method[0], title: method[1]}, ...named.filter(({key}) => key === 'number'), ...used, ...more, ...named.filter(({key}) => key !== 'number'), {key: 'marks', title: 'marks'},
      ...(failures ? [{key: 'status', title: 'status'}, {key: 'why', title: 'why'}] : []),
    ],
    rows: [...points].sort(order(onFront)).map((point) => ({...point, marks: marks(point), status: statusOf(point)})),
  };
}

/** The front comes first, from the cheapest on; runs without an error come behind all others, and what was not run last. @param {Set<number>} onFront */
function order(onFront) {
  const size = (/** @type {number | null} */ value) => value ?? Number.MAX_VALUE;
  const isUnmade = (/** @type {Point} */ point) => Number(point.status === 'refused');
  return (/** @type {Point} */ a, /** @type {Point} */ b) => isUnmade(a) - isUnmade(b) || Number(onFront.has(b.id)) - Number(onFront.has(a.id))
    || (onFront.has(a.id) ? size(b.error) - size(a.error) : size(a.error) - size(b.error)) || size(a.time_s) - size(b.time_s);
}
