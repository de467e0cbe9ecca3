// node svg.mjs STUDY.json OUTDIR: the charts of a study as SVG files, light, 760 pixels wide. The same study gives the same bytes.

import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {stills} from './src/still.js';
import {readStudy} from './src/study.js';

const [input, folder] = process.argv.slice(2);
if (!input || !folder) {
  console.error('usage: node svg.mjs STUDY.json OUTDIR');
  process.exit(2);
}

const found = readStudy(readFileSync(input, 'utf8'));
if (typeof found === 'string') {
  console.error(`${input}: ${found}`);
  process.exit(1);
}
mkdirSync(folder, {recursive: true});
for (const {name, svg} of stills(found.problems)) {
  writeFileSync(join(folder, name), svg);
  console.log(name);
}
