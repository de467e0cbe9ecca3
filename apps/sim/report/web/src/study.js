// The study in the page: read, and brought into a form in which nothing is missing.

/** @typedef {import('./types.js').Study} Study */
/** @typedef {import('./types.js').FullProblem} FullProblem */

export const k_format = 1;

const list = (/** @type {any} */ value) => Array.isArray(value) ? value.filter((entry) => entry !== null && typeof entry === 'object') : [];

/** @param {any} problem @returns {FullProblem} */
function full(problem) {
  const lists = Object.fromEntries(['outputs', 'builds', 'points', 'drifts', 'lanes'].map((key) => [key, list(problem[key])]));
  return {...problem, ...lists, name: String(problem.name ?? 'without a name')};
}

/**
 * @param {string} text JSON
 * @returns {{study: Study, problems: FullProblem[]} | string} a sentence where it is no study
 */
export function readStudy(text) {
  if (text.trimStart().startsWith('@')) return 'This page is a template: nobody has put a study into it.';
  let study;
  try {
    study = JSON.parse(text);
  } catch (problem) {
    return `What this page holds is not JSON: ${/** @type {Error} */ (problem).message}.`;
  }
  if (study === null || typeof study !== 'object' || Array.isArray(study)) return 'What this page holds is no study.';
  if (study.format !== k_format) return `This page reads format ${k_format} of studies, and the study says ${JSON.stringify(study.format) ?? 'none'}.`;
  return {study, problems: list(study.problems).map(full)};
}
