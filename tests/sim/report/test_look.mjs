// Colours can be read and told apart: contrast as WCAG 2.2 has it, and distances as eyes without red or green cones see them.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import test from 'node:test';
import {colourOf, dashOf, fillOf, k_dark, k_light, symbolOf} from '../../../apps/sim/report/web/src/look.js';

const channels = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255);
const linear = (colour) => channels(colour).map((c) => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

function contrast(a, b) {
  const [x, y] = [luminance(linear(a)), luminance(linear(b))].sort((p, q) => q - p);
  return (x + 0.05) / (y + 0.05);
}

// Machado, Oliveira, Fernandes 2009, severity 1, on linear channels.
const k_eyes = {
  usual: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
};

/** CIE L*a*b*, in which equal distances look about equal. */
function lab(rgb) {
  const [r, g, b] = rgb.map((value) => Math.min(1, Math.max(0, value)));
  const xyz = [0.4124 * r + 0.3576 * g + 0.1805 * b, luminance([r, g, b]), 0.0193 * r + 0.1192 * g + 0.9505 * b];
  const [x, y, z] = [0.9505, 1, 1.089].map((white, i) => { const t = xyz[i] / white; return t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116; });
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

const seen = (colour, eyes) => lab(eyes.map((row) => row.reduce((sum, part, i) => sum + part * linear(colour)[i], 0)));
const distance = (a, b) => Math.hypot(...a.map((part, i) => part - b[i]));

function variables(theme) {
  const css = readFileSync(new URL('../../../apps/sim/report/web/src/styles/theme.css', import.meta.url), 'utf8');
  const block = theme === 'dark' ? css.slice(css.indexOf("[data-theme='dark']")) : css.slice(0, css.indexOf("[data-theme='dark']"));
  return Object.fromEntries([...block.matchAll(/--([\w-]+): (#[0-9a-f]{6})/g)].map(([, name, value]) => [name, value]));
}

for (const [name, look] of [['light', k_light], ['dark', k_dark]]) {
  test(`${name}: text has a contrast of 4.5 with what it stands on`, () => {
    const colours = variables(name);
    for (const text of ['ink', 'muted', 'accent', 'fault']) for (const ground of ['ground', 'surface']) assert.ok(contrast(colours[text], colours[ground]) >= 4.5, `${text} on ${ground}`);
    assert.ok(contrast(colours.accent, colours['accent-soft']) >= 4.5);
    for (const text of [look.ink, look.muted, look.fault]) assert.ok(contrast(text, look.surface) >= 4.5, text);
    assert.ok(contrast(look.fault, look.band) >= 4.5);
  });

  test(`${name}: charts and page have the same colours`, () => {
    const colours = variables(name);
    assert.deepEqual([look.ink, look.muted, look.surface, look.accent, look.fault, look.grid], [colours.ink, colours.muted, colours.surface, colours.accent, colours.fault, colours.rule]);
  });

  test(`${name}: symbols have a contrast of 3 with the page`, () => {
    for (const colour of look.colours) assert.ok(contrast(colour, look.surface) >= 3, `${colour}: ${contrast(colour, look.surface)}`);
  });

  for (const [eyes, matrix] of Object.entries(k_eyes)) {
    test(`${name}: the first six colours are far apart for eyes with ${eyes}`, () => {
      const [first] = [look.colours.slice(0, 6)];
      for (const [i, a] of first.entries()) for (const b of first.slice(i + 1)) assert.ok(distance(seen(a, matrix), seen(b, matrix)) > 9, `${a} ${b}: ${distance(seen(a, matrix), seen(b, matrix))}`);
    });
  }
}

for (const [name, look] of [['light', k_light], ['dark', k_dark]]) {
  test(`${name}: twenty-six methods have colours of their own, and where colour-blind eyes see two alike their symbols differ`, () => {
    const methods = Array.from({length: 26}, (_, i) => `m${i}`);
    const full = {...look, methods, numbers: [], still: false};
    const pairs = methods.flatMap((a, i) => methods.slice(i + 1).map((b) => [a, b]));
    for (const [a, b] of pairs) {
      const apart = (matrix) => distance(seen(colourOf(full, a), matrix), seen(colourOf(full, b), matrix));
      assert.ok(apart(k_eyes.usual) > 18, `${a} ${b}: ${apart(k_eyes.usual)}`);
      for (const matrix of [k_eyes.protanopia, k_eyes.deuteranopia]) assert.ok(apart(matrix) > 9 || symbolOf(full, a) !== symbolOf(full, b), `${a} ${b}: ${apart(matrix)}`);
    }
  });
}

test('no two of sixty-four methods have both colour and symbol in common', () => {
  const look = {...k_light, methods: Array.from({length: 64}, (_, i) => `m${i}`), numbers: ['a', 'b', 'c', 'd'], still: false};
  const marks = look.methods.map((name) => `${colourOf(look, name)} ${symbolOf(look, name)}`);
  assert.equal(new Set(marks).size, 64);
  assert.equal(new Set(look.numbers.map((name) => String(dashOf(look, name)))).size, 4);
  assert.equal(new Set(look.numbers.map((name) => fillOf(look, name, '#0072b2'))).size, 4);
});

test('a method keeps its colour, whichever runs are shown', () => {
  const look = {...k_light, methods: ['a', 'b', 'c'], numbers: [], still: false};
  assert.equal(colourOf(look, 'b'), k_light.colours[1]);
});
