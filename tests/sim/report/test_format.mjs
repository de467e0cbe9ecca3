// Numbers are written as engineers read them.

import assert from 'node:assert/strict';
import test from 'node:test';
import {alike, column, count, factors, plain, seconds, small, times} from '../../../apps/sim/report/web/src/format.js';
import {csv, tabbed} from '../../../apps/sim/report/web/src/ui/csv.js';

const all = (write, cases) => { for (const [value, text] of cases) assert.equal(write(value), text, String(value)); };

test('errors keep their power of ten, and no digits that say nothing', () => {
  all(small, [[1.234e-10, '1.2e-10'], [1e-9, '1e-9'], [9.97e-7, '1e-6'], [0, '0'], [2.5, '2.5e0'], [1.2e-320, '1.2e-320'], [-3.21e-4, '-3.2e-4']]);
});

test('what is no number is a dash', () => {
  for (const write of [small, plain, seconds, column, count, factors([1]), factors([1e9]), times]) for (const value of [null, undefined, NaN, Infinity, '7']) assert.equal(write(value), '–');
});

test('times have the prefix that leaves one to three digits before the point', () => {
  all(seconds, [[3.4e-3, '3.40 ms'], [1.1e-4, '110 µs'], [9.996e-4, '1.00 ms'], [9.994e-4, '999 µs'], [2.5e-9, '2.50 ns'], [4e-13, '0.000400 ns'], [0, '0 s'], [1.4, '1.40 s'], [60, '60.0 s'], [12345, '12\u202f300 s']]);
});

test('counts are whole and grouped, other numbers have three digits', () => {
  all(plain, [[812, '812'], [12345, '12\u202f345'], [1.45e6, '1.45e6'], [1.2345, '1.23'], [0.0312, '0.0312'], [171642.4, '172\u202f000'], [1e-4, '1e-4'], [5e-324, '4.94e-324']]);
});

test('columns keep their digits, so that points stand below each other', () => {
  all(column, [[6e-13, '6.0e-13'], [0, '0'], [1.26e-3, '1.3e-3']]);
  all(count, [[1234567, '1\u202f234\u202f567'], [12, '12'], [0, '0']]);
});

test('factors have two digits at least, and one notation for a column', () => {
  all(factors([1.3, null, 0.012]), [[1.3, '1.30'], [12.44, '12.4'], [150, '150'], [0.0123, '0.012'], [0.5, '0.50'], [0.9999, '1.00'], [0, '0']]);
  all(factors([1.3, 2.6e-5]), [[1.3, '1.3e0'], [2.6e-5, '2.6e-5']]);
  all(factors([1.3, 2.6e7]), [[1.3, '1.3e0'], [2.6e7, '2.6e7']]);
});

test('labels of an axis are all with a point, or all with a power of ten', () => {
  all(alike([0.01, 1, 100]), [[0.01, '0.01'], [1, '1'], [100, '100']]);
  all(alike([1e-4, 0.01, 1]), [[1e-4, '1e-4'], [0.01, '1e-2'], [1, '1e0']]);
  all(alike([100, 1e6]), [[100, '1e2'], [1e6, '1e6']]);
});

const table = {caption: '', columns: [{key: 'a', title: 'name'}, {key: 'b', title: 'x, y'}], rows: [{a: 'say "hello", you', b: 1.2345678901234567e-10}, {a: 'two\nlines', b: null}]};

test('files have all digits, and quotes around what would tear a row', () => {
  assert.equal(csv(table), 'name,"x, y"\r\n"say ""hello"", you",1.2345678901234568e-10\r\n"two\nlines",\r\n');
});

test('the clipboard has a line for a row', () => {
  assert.equal(tabbed(table), 'name\tx, y\nsay "hello", you\t1.2345678901234568e-10\ntwo lines\t\n');
});
