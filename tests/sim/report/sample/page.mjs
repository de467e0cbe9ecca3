// A study in the page, as gauss-sim puts it there.

import {readFileSync} from 'node:fs';

/** `<` as \u003c: the text of a study must not end the element that it stands in. */
export const inPage = (study) => JSON.stringify(study).replaceAll('<', '\\u003c');

export const pageOf = (template, study) => readFileSync(template, 'utf8').replace('@STUDY@', () => inPage(study));
