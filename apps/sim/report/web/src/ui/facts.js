// What a problem and a machine are, in a few lines.

import {runsInWords, whyUnmade} from '../counts.js';
import {counted, isNumber, plain, seconds, small} from '../format.js';
import {begun, notRun, tally} from '../maths/points.js';
import {isOfEffects} from '../charts/all.js';
import {el, pairs} from './dom.js';

/** @typedef {import('../types.js').FullProblem} FullProblem */

/** @param {(string | null | undefined | false)[]} parts */
const joined = (parts) => parts.filter(Boolean).join(', ');

/** @param {import('../types.js').Reference | null | undefined} reference */
function referenceOf(reference) {
  if (!reference) return 'none: errors are not known';
  const methods = (reference.methods ?? []).join('; ');
  const agreement = isNumber(reference.agreement) ? `; they agree to ${small(reference.agreement)}` : '';
  return `${reference.kind}${methods ? `: ${methods}` : ''}${agreement}`;
}

/** What does not change has errors relative to something else than its range. @param {FullProblem['outputs'][number]} output */
function outputOf({name, unit, range, scale}) {
  const isConstant = isNumber(range) && isNumber(scale) && range < scale / 2;
  const extent = isConstant ? 'constant' : isNumber(range) && `range ${plain(range)}`;
  const said = joined([unit, extent]);
  return said ? `${name} (${said})` : name;
}

/** Settings without a run, in lines: those that charts show as such, and those of which all that is alike was not run, which they leave out. @param {FullProblem['points']} points */
function notRunOf(points) {
  const [all, shown] = [tally(points), tally(begun(points))];
  if (all.unmade === 0) return '';
  const others = all.unmade - shown.unmade;
  return [
    `${counted(all.unmade, 'setting')}.`, shown.unmade > 0 && `${plain(shown.unmade)} beside runs, which charts show without a result: ${whyUnmade(shown)}.`,
    others > 0 && [`${plain(others)} that charts leave out:`, ...notRun(points)].join('\n– '),
  ].filter(Boolean).join('\n');
}

/** What each is, and which of them are not called for. @param {import('../types.js').Effects | null | undefined} effects */
function effectsOf(effects) {
  const acting = new Set(effects?.all?.effects ?? []);
  return Object.entries(effects?.about ?? {}).map(([name, about]) => `${name}${about && `: ${about}`}${acting.has(name) ? '' : ' (not called for)'}`).join('\n');
}

/** @param {FullProblem} problem */
export function factsOf(problem) {
  const outputs = problem.outputs.map(outputOf).join(', ');
  const found = /** @type {[string, string][]} */ ([]);
  if (problem.scene) found.push(['scene', problem.scene]);
  if (problem.file) found.push(['model', problem.file]);
  if (isNumber(problem.duration)) found.push(['motion', joined([`${plain(problem.duration)} s`, isNumber(problem.samples) && counted(problem.samples, 'sample')])]);
  if (outputs) found.push(['compared', outputs]);
  if (!isOfEffects(problem)) found.push(['reference', referenceOf(problem.reference)], ['runs', runsInWords(tally(problem.points))]);
  const missing = notRunOf(problem.points);
  if (missing) found.push(['not run', missing]);
  const effects = effectsOf(problem.effects);
  if (effects) found.push(['effects', effects]);
  return pairs(found, 'pairs facts');
}

/** @param {import('../types.js').Study} study */
export function machineOf(study) {
  const machine = study.machine ?? {};
  const text = joined([machine.processor, isNumber(machine.cores) && counted(machine.cores, 'core'), machine.system, machine.compiler, machine.flags]);
  return el('p', {class: 'machine'}, joined([study.tool, text || 'on a machine that nobody described', isNumber(study.budget_s) && `${seconds(study.budget_s)} of runs for each problem`]));
}

/** @param {import('../types.js').Study} study */
export function interruptionOf(study) {
  if (study.interrupted !== true) return null;
  return el('p', {class: 'interrupted'}, 'This study was interrupted: it has what had been measured by then, and what would have come after that is missing.');
}
