// Counts of runs in words: the same ones in facts, sentences and summary. A run is a setting that was begun.

import {counted, plain} from './format.js';

/** @typedef {ReturnType<typeof import('./maths/points.js').tally>} Tally */

/** @param {[number, string][]} parts */
const listed = (parts) => parts.filter(([count]) => count > 0).map(([count, word]) => `${plain(count)} ${word}`).join(', ');

/** @param {Tally} tally */
const withoutResult = ({stopped, unknown}) => listed([[stopped, 'stopped on the way'], [unknown, 'have an error that nobody knows']]);

/** @param {Tally} tally */
export function whyUnmade({late, unfit}) {
  const [want, suit] = ['for want of time', 'as they do not suit the model'];
  return late > 0 && unfit > 0 ? listed([[late, want], [unfit, suit]]) : late > 0 ? want : suit;
}

/** @param {Tally} tally */
export function runsInWords(tally) {
  const without = withoutResult(tally);
  return `${plain(tally.runs)}, ${plain(tally.arrived)} of them with a result${without && `; ${without}`}`;
}

/** What has no result, in a sentence or two; nothing where all have one. @param {Tally} tally */
export function lostInWords(tally) {
  const without = withoutResult(tally);
  return [
    without && `${plain(tally.runs - tally.arrived)} of ${counted(tally.runs, 'run')} have no result: ${without}.`,
    tally.unmade > 0 && `${counted(tally.unmade, 'setting')} beside them ${tally.unmade === 1 ? 'was' : 'were'} not run: ${whyUnmade(tally)}.`,
  ].filter(Boolean).join(' ');
}
