// The page of gauss-sim effects in Chromium, and effects in that of a study.

import assert from 'node:assert/strict';
import test from 'node:test';
import {colours, fileOf, hintOf, rowsOf, section, withPage} from './browser.mjs';
import {effects} from './sample/effects.mjs';

const alone = fileOf({format: 1, tool: 'gauss-sim 0.1.0', problems: [{name: 'top', about: 'A top that nods', file: 'top.yaml', duration: 5, effects: effects()}]});

test('a page of effects has nothing of runs', () => withPage({url: alone}, async (page) => {
  assert.equal(await page.locator('h1').textContent(), 'What effects cost and change');
  assert.equal(await page.title(), 'top – what effects cost and change');
  assert.deepEqual(await page.locator('.figure').evaluateAll((all) => all.map((one) => one.dataset.chart)), ['effects', 'effect-ladder']);
  assert.deepEqual(await page.locator('.sections a').allTextContents(), ['Effects', 'Effect ladder']);
  assert.equal(await page.locator('.filters:visible').count(), 0);
  const facts = await page.locator('.facts').textContent();
  assert.match(facts, /gravity: weight\nrigid: a rod that keeps its length \(not called for\)/);
  assert.ok(facts.includes('air: drag <of> air & "wind"'));
  assert.doesNotMatch(facts, /reference|runs/);
}));

test('bars and symbols are in the order of the table, and names are whole', () => withPage({url: alone, hash: '#/top/effects'}, async (page) => {
  const found = await section(page, 'effects');
  const rows = await rowsOf(found);
  assert.deepEqual(rows.map(({set}) => set), ['all', 'without gravity (and buoyancy)', 'rigid instead of elastic', 'without air', 'without buoyancy', 'none']);
  assert.equal(rows[2]['operations'], '9');
  assert.equal(rows[2]['changes the motion by'], '7.2e-4');
  const drawn = rows.filter(({operations}) => operations !== '–');
  const places = [];
  for (const {set} of drawn) {
    const label = found.locator('.plot svg text', {hasText: new RegExp(`^${set.split(' (')[0]}`)}).first();
    places.push((await label.boundingBox()).y);
  }
  assert.deepEqual(places, [...places].sort((a, b) => a - b));
}));

test('arrow keys go from rung to rung, and say what a set costs and changes', () => withPage({url: alone, hash: '#/top/effect-ladder'}, async (page) => {
  const found = await section(page, 'effect-ladder');
  await found.locator('.plot').focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  const hint = await hintOf(found);
  assert.equal(hint.set, 'rigid instead of elastic');
  assert.equal(hint['changes the motion by'], '7.2e-4 of nutation');
  assert.equal(hint.operations, '9');
  assert.match(await found.locator('[aria-live]').textContent(), /^set rigid instead of elastic, effects gravity, rigid, air, buoyancy, /);
}));

for (const [width, panels] of [[1440, 1], [390, 2]]) {
  test(`costs and changes stand ${panels === 1 ? 'beside' : 'below'} each other, ${width} pixels wide`, () => withPage({url: alone, hash: '#/top/effects', options: {viewport: {width, height: 900}}}, async (page) => {
    const found = await section(page, 'effects');
    const names = found.locator('.plot svg text', {hasText: /^rigid/});
    assert.equal(await names.count(), panels);
    const frame = await found.locator('.plot').boundingBox();
    for (const text of await found.locator('.plot svg text').all()) {
      const box = await text.boundingBox();
      assert.ok(box.x >= frame.x - 1 && box.x + box.width <= frame.x + frame.width + 1 && box.y + box.height <= frame.y + frame.height + 1, await text.textContent());
    }
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }));
}

test('panels go below each other when the window becomes narrow, and back', () => withPage({url: alone, hash: '#/top/effects'}, async (page) => {
  const names = (await section(page, 'effects')).locator('.plot svg text', {hasText: /^rigid/});
  for (const [width, panels] of [[390, 2], [1440, 1]]) {
    await page.setViewportSize({width, height: 900});
    await page.waitForFunction(([svg, count]) => [...document.querySelectorAll(svg)].filter((one) => one.textContent.startsWith('rigid')).length === count, ['[data-chart="effects"] .plot svg text', panels]);
    assert.equal(await names.count(), panels);
  }
}));

for (const width of [1440, 390]) {
  test(`each rung has its label, over no other, ${width} pixels wide`, () => withPage({url: alone, hash: '#/top/effect-ladder', options: {viewport: {width, height: 900}}}, async (page) => {
    const found = await section(page, 'effect-ladder');
    const boxes = await found.locator('.plot svg').evaluate((svg, rungs) => [...svg.querySelectorAll('text')].filter((one) => rungs.includes(one.textContent)).map((one) => { const {left, right, top, bottom} = one.getBoundingClientRect(); return {text: one.textContent, left, right, top: top + 2, bottom: bottom - 2}; }),
      effects().ladder.map(({what}) => what));
    assert.ok(boxes.length >= (width > 1000 ? 5 : 3), `${boxes.length} labels`);
    for (const a of boxes) for (const b of boxes) if (a !== b) assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, `${a.text} over ${b.text}`);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }));
}

test('charts of effects are drawn in dark colours and on paper, too', () => withPage({url: alone, options: {colorScheme: 'dark'}}, async (page) => {
  for (const id of ['effects', 'effect-ladder']) {
    const found = await section(page, id);
    assert.ok(await found.locator('.plot svg path[stroke="#56b4e9"]').count() > 0, id);
    assert.ok((await colours(page, await found.locator('.plot').screenshot())).drawn > 0.01, id);
  }
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  await page.emulateMedia({media: 'print'});
  assert.equal(await page.locator('.plot svg:visible').count(), 2);
  assert.ok(await page.locator('.plot svg path[stroke="#0072b2"]').count() > 0);
}));
