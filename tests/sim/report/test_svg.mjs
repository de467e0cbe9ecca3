// Charts as SVG files: well-formed, always the same, of one width, and nothing in them but drawing.

import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {study as sample} from './sample/study.mjs';

const folder = mkdtempSync(join(tmpdir(), 'gauss-svg-'));
after(() => rmSync(folder, {recursive: true}));

const study = {...sample()};
study.problems = study.problems.slice(0, 2);

function drawn(content, name) {
  const [file, out] = [join(folder, `${name}.json`), join(folder, name)];
  writeFileSync(file, typeof content === 'string' ? content : JSON.stringify(content));
  const run = spawnSync(process.execPath, [process.env.REPORT_SVG, file, out], {encoding: 'utf8'});
  return {...run, pictures: run.status === 0 ? Object.fromEntries(readdirSync(out).map((one) => [one, readFileSync(join(out, one), 'utf8')])) : {}};
}

/** Tags in order and closed, attributes quoted, nothing raw in the text: what a strict parser asks for. */
function wellFormed(text) {
  const open = [];
  const token = /<(\/?)([\w:]+)((?:\s+[\w:-]+="[^"<]*")*)\s*(\/?)>|([^<]+)/gy;
  let at = 0;
  for (let found; at < text.length && (found = token.exec(text)); at = token.lastIndex) {
    const [, closing, name, attributes, empty, plain] = found;
    assert.doesNotMatch((attributes ?? '') + (plain ?? ''), /&(?!amp;|lt;|gt;|quot;|#\d+;|#39;)/);
    if (plain !== undefined || empty) continue;
    if (closing) assert.equal(open.pop(), name);
    else open.push(name);
  }
  assert.equal(at, text.length, text.slice(at, at + 200));
  assert.deepEqual(open, []);
}

test('each chart that has something to show is a picture of 760 pixels', () => {
  const {pictures} = drawn(study, 'first');
  const names = Object.keys(pictures);
  for (const id of ['error-time', 'error-calls', 'tolerance', 'digit-cost', 'drift-energy', 'formulations', 'numbers', 'projections', 'lanes', 'builds']) assert.ok(names.includes(`double_pendulum-${id}.svg`), id);
  assert.ok(names.includes('summary.svg'));
  for (const [name, text] of Object.entries(pictures)) {
    wellFormed(text);
    assert.match(text, /^<svg xmlns="http:\/\/www.w3.org\/2000\/svg" viewBox="0 0 760 \d+" width="760" height="\d+" role="img" aria-label="[^"]{30,}">\n<rect width="760" height="\d+" fill="#ffffff"\/>/, name);
    assert.doesNotMatch(text, /NaN|undefined|<script|<style|href|url\((?!#zr-)|@import/, name);
  }
  const symbols = pictures['double_pendulum-error-time.svg'].match(/<path/g).length;
  assert.ok(symbols > study.problems[0].points.length, String(symbols));
});

test('the same study gives the same bytes, alone or among others', () => {
  const [once, again] = ['once', 'again'].map((name) => drawn({...study, problems: study.problems.map((problem) => ({...problem, points: problem.points.slice(0, 90)}))}, name).pictures);
  assert.deepEqual(once, again);
  const alone = drawn({...study, problems: [{...study.problems[1], points: study.problems[1].points.slice(0, 90)}]}, 'alone').pictures;
  for (const name of ['sphere_in_cylinder-lanes.svg', 'sphere_in_cylinder-drift-energy.svg']) {
    assert.ok(alone[name].length > 1000);
    assert.equal(alone[name], once[name]);
  }
});

test('names that are meant badly stay text, and files stay in their folder', () => {
  const bad = '"/></svg><script>&amp;\'';
  const problem = {...study.problems[0], name: `../${bad}`};
  problem.points = problem.points.slice(0, 80).map((point) => ({...point, method: point.method + bad, formulation: point.formulation + bad}));
  problem.lanes = problem.lanes.map((lane) => ({...lane, number: bad}));
  const {pictures, status} = drawn({...study, problems: [problem]}, 'bad');
  assert.equal(status, 0);
  assert.ok(Object.keys(pictures).length > 5);
  for (const text of Object.values(pictures)) wellFormed(text);
});

test('what is no study is refused', () => {
  const {status, stderr} = drawn('{"format": 3}', 'wrong');
  assert.equal(status, 1);
  assert.match(stderr, /format 1/);
  assert.equal(spawnSync(process.execPath, [process.env.REPORT_SVG]).status, 2);
});
